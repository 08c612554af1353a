//! The best command for given prices: on where they are lowest, for as long as it takes.

use std::f64::consts::FRAC_PI_2;

use super::problem::Command;
use crate::order::order_by;
use crate::specified::{Jet, minima, samples};

/// The command that is on where the price is below a threshold, which is chosen for the given on-time.
pub(super) fn reply(price: &impl Fn(f64) -> Jet, longest: f64, highest: f64, on_time: f64) -> Command {
    let slopes = monotone(price, longest, highest);
    let lowest = slopes.iter().map(|slope| slope.low()).fold(f64::INFINITY, f64::min);
    let top = slopes.iter().map(|slope| slope.high()).fold(f64::NEG_INFINITY, f64::max);
    // next to a minimum of the price, and to its maximum, the on-time grows as a root: over the angle it is a straight line
    let threshold_at = |angle: f64| lowest + (top - lowest) * angle.sin().powi(2);
    let surplus = |threshold: f64| {
        let on: f64 = slopes.iter().map(|slope| slope.part_below(price, threshold)).map(|[from, to]| to - from).sum();
        on - on_time
    };
    let angle = root(|angle| surplus(threshold_at(angle)), [0.0, -on_time], [FRAC_PI_2, longest - on_time]);
    let threshold = threshold_at(angle);
    let mut command: Command = Vec::new();
    for [from, to] in slopes.iter().map(|slope| slope.part_below(price, threshold)).filter(|[from, to]| from < to) {
        match command.last_mut() {
            Some(last) if last[1] >= from => last[1] = to,
            _ => command.push([from, to]),
        }
    }
    // where the price is flat to rounding, as next to a minimum or that of two cuts that cancel, one part is as good as another
    let on: f64 = command.iter().map(|[from, to]| to - from).sum();
    let share = on_time / on;
    for [from, to] in &mut command {
        let kept = if *from == 0.0 {
            0.0
        } else if *to == longest {
            longest
        } else {
            0.5 * (*from + *to)
        };
        (*from, *to) = (kept + (*from - kept) * share, kept + (*to - kept) * share);
    }
    command
}

/// A stretch over which the price only rises or only falls.
struct Slope {
    from: f64,
    to: f64,
    prices: [f64; 2],
}

impl Slope {
    fn low(&self) -> f64 {
        self.prices[0].min(self.prices[1])
    }

    fn high(&self) -> f64 {
        self.prices[0].max(self.prices[1])
    }

    fn part_below(&self, price: &impl Fn(f64) -> Jet, threshold: f64) -> [f64; 2] {
        if self.high() <= threshold {
            return [self.from, self.to];
        }
        if self.low() >= threshold {
            return [self.from, self.from];
        }
        let crossing = self.crossing(price, threshold);
        if self.prices[0] < threshold { [self.from, crossing] } else { [crossing, self.to] }
    }

    /// Newton's method within the bracket.
    fn crossing(&self, price: &impl Fn(f64) -> Jet, threshold: f64) -> f64 {
        let rises = self.prices[1] > self.prices[0];
        let (mut low, mut high) = (self.from, self.to);
        let mut at = 0.5 * (low + high);
        for _ in 0..60 {
            let [value, slope, _] = price(at);
            if (value < threshold) == rises {
                low = at;
            } else {
                high = at;
            }
            let newton = at - (value - threshold) / slope;
            let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
            if (next - at).abs() <= 1e-14 * high {
                return next;
            }
            at = next;
        }
        at
    }
}

fn monotone(price: &impl Fn(f64) -> Jet, longest: f64, highest: f64) -> Vec<Slope> {
    let points = samples(highest * longest);
    let mut places = vec![0.0, longest];
    places.extend(minima(0.0..=longest, points, price).iter().map(|(place, _)| *place));
    places.extend(minima(0.0..=longest, points, |tau| price(tau).map(|part| -part)).iter().map(|(place, _)| *place));
    order_by(&mut places, |place| *place);
    places.dedup();
    let prices: Vec<f64> = places.iter().map(|place| price(*place)[0]).collect();
    let pairs = places.windows(2).zip(prices.windows(2));
    pairs.map(|(place, price)| Slope { from: place[0], to: place[1], prices: [price[0], price[1]] }).collect()
}

/// A root between two points [x, f(x)] of a function that rises, by false position with Illinois' correction; where it jumps past
/// zero, a place above.
fn root(function: impl Fn(f64) -> f64, mut low: [f64; 2], mut high: [f64; 2]) -> f64 {
    let (scale, mut side) = (-low[1], 0);
    for step in 0..100 {
        let at = if step % 4 == 3 || low[1] == high[1] {
            0.5 * (low[0] + high[0])
        } else {
            (low[0] * high[1] - high[0] * low[1]) / (high[1] - low[1])
        };
        let value = function(at);
        if value.abs() <= 1e-13 * scale {
            return at;
        }
        if high[0] - low[0] <= 1e-16 * high[0].abs() {
            break;
        }
        if value < 0.0 {
            low = [at, value];
            high[1] *= if side < 0 { 0.5 } else { 1.0 };
            side = -1;
        } else {
            high = [at, value];
            low[1] *= if side > 0 { 0.5 } else { 1.0 };
            side = 1;
        }
    }
    high[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_on_where_it_is_cheapest() {
        // cos τ < cos(π − ½) within ½ of π, and of 3π
        let price = |tau: f64| [tau.cos(), -tau.sin(), -tau.cos()];
        let command = reply(&price, 10.5, 1.0, 2.0);
        let pi = std::f64::consts::PI;
        for (pulse, middle) in command.iter().zip([pi, 3.0 * pi]) {
            assert!((pulse[0] - middle + 0.5).abs() < 1e-12 && (pulse[1] - middle - 0.5).abs() < 1e-12);
        }
        assert_eq!(command.len(), 2);
        let [[from, to]] = reply(&price, 5.0, 1.0, 1e-5)[..] else { panic!("one pulse") };
        // the threshold is 1e-11 above the lowest price, which is resolved to 1e-16
        assert!((to - from - 1e-5).abs() < 1e-9 && (0.5 * (from + to) - pi).abs() < 1e-6);
    }
}
