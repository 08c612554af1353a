//! Where a smooth function of one variable is least.

use std::ops::RangeInclusive;

/// A function's value, slope and curvature.
pub(crate) type Jet = [f64; 3];

/// All local minima over a range, its ends included where the function is least there, in ascending order.
///
/// `points` equidistant samples must resolve the function: between two of them it bends one way or hardly at all.
pub(crate) fn minima(range: RangeInclusive<f64>, points: usize, function: impl Fn(f64) -> Jet) -> Vec<(f64, Jet)> {
    minima_of(range, points, &function)
}

/// The same, in one piece of code for all functions: all this is in FMUs.
fn minima_of(range: RangeInclusive<f64>, points: usize, function: &dyn Fn(f64) -> Jet) -> Vec<(f64, Jet)> {
    let (first, last) = range.into_inner();
    if first == last {
        return vec![(first, function(first))];
    }
    let step = (last - first) / points as f64;
    let place = |point: usize| if point == points { last } else { first + point as f64 * step };
    let samples: Vec<Jet> = (0..=points).map(|point| function(place(point))).collect();
    let mut found = Vec::new();
    // where the slope is zero, the curvature says where it goes on from there
    let falls = |[_, slope, curvature]: Jet| slope < 0.0 || (slope == 0.0 && curvature < 0.0);
    if !falls(samples[0]) {
        found.push((first, samples[0]));
    }
    for (point, pair) in samples.windows(2).enumerate() {
        if falls(pair[0]) && !falls(pair[1]) {
            let at = stationary(place(point), place(point + 1), function);
            found.push((at, function(at)));
        }
    }
    if falls(samples[points]) {
        found.push((last, samples[points]));
    }
    found
}

/// Newton's method for a zero of the slope, which rises from `low` to `high`, within a bracket.
fn stationary(mut low: f64, mut high: f64, function: &dyn Fn(f64) -> Jet) -> f64 {
    let mut at = 0.5 * (low + high);
    for _ in 0..60 {
        let [_, slope, curvature] = function(at);
        if slope < 0.0 {
            low = at;
        } else {
            high = at;
        }
        let newton = at - slope / curvature;
        let next = if low < newton && newton < high { newton } else { 0.5 * (low + high) };
        if (next - at).abs() <= 1e-13 * high.abs() {
            return next;
        }
        at = next;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inner_minima_and_ends() {
        let found = minima(-4.0..=8.0, 40, |x: f64| [x.cos(), -x.sin(), -x.cos()]);
        let places: Vec<f64> = found.iter().map(|(place, _)| *place).collect();
        let expected = [-std::f64::consts::PI, std::f64::consts::PI, 8.0];
        assert_eq!(places.len(), 3, "cos falls at both ends: {places:?}");
        for (place, expected) in places.iter().zip(expected) {
            assert!((place - expected).abs() < 1e-12);
        }
        assert_eq!(minima(0.5..=1.0, 4, |x| [x, 1.0, 0.0]), [(0.5, [0.5, 1.0, 0.0])]);
        assert_eq!(minima(0.5..=1.0, 4, |x| [-x, -1.0, 0.0]), [(1.0, [-1.0, -1.0, 0.0])]);
    }
}
