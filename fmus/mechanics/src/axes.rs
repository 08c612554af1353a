//! The axes that cranes move by, and between which rates each can move.

/// What a crane moves by. Ropes do what luff and hoist do, by another drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names say it")]
pub enum Axis {
    Slew,
    Luff,
    Hoist,
    Trolley,
    Extension,
    /// The luff line; positive reels in.
    LuffLine,
    /// The hoist line; positive pays out.
    HoistLine,
}

/// How many kinds of axes there are.
pub const AXES: usize = 7;

/// A rate of each [`Axis`] (rad/s, m/s), 0 where a machine has none.
pub type AxisRates = nalgebra::SVector<f64, AXES>;

/// Between which rates an axis can move, 0 among them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RateRange {
    /// The least rate, not positive.
    pub min: f64,
    /// The greatest rate, not negative.
    pub max: f64,
}

impl RateRange {
    /// As fast in both directions.
    #[must_use]
    pub fn either_way(limit: f64) -> Self {
        Self { min: -limit, max: limit }
    }

    /// Not faster than `limit` either way.
    #[must_use]
    pub fn within(self, limit: f64) -> Self {
        Self { min: self.min.max(-limit), max: self.max.min(limit) }
    }

    /// With a share only of the speed in the direction of `sign`.
    #[must_use]
    pub fn slowed(self, sign: f64, share: f64) -> Self {
        if sign > 0.0 { Self { max: self.max * share, ..self } } else { Self { min: self.min * share, ..self } }
    }

    /// Not so fast that the axis would pass either end of its range, which are so far below and above: it slows down by
    /// `acceleration`, and a rate holds for `interval` (s).
    ///
    /// From a rate v that falls by δ = a Δt at each interval it goes s = Δt (v + (v − δ) + (v − 2δ) + …) while the terms are
    /// positive: a polygon with corners at v = n δ, s = ½ δ Δt n (n + 1), whose inverse this is.
    #[must_use]
    pub fn before_ends(self, [below, above]: [f64; 2], acceleration: f64, interval: f64) -> Self {
        let fastest = |way: f64| {
            let (way, unit) = (way.max(0.0), 0.5 * acceleration * interval * interval);
            if interval <= 0.0 {
                return (2.0 * acceleration * way).sqrt();
            }
            // The last corner before.
            let corner = (2.0 * way / (unit + (unit * unit + 4.0 * unit * way).sqrt())).floor();
            (way + unit * corner * (corner + 1.0)) / (interval * (corner + 1.0))
        };
        Self { min: self.min.max(-fastest(below)), max: self.max.min(fastest(above)) }
    }

    /// The rate in the range that is closest to this one; a range of no numbers leaves it.
    #[must_use]
    pub fn cut(self, rate: f64) -> f64 {
        rate.max(self.min).min(self.max)
    }
}

/// Between which rates each [`Axis`] can move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RateRanges(pub [RateRange; AXES]);

impl RateRanges {
    /// Each as fast in both directions.
    #[must_use]
    pub fn either_way(limits: &AxisRates) -> Self {
        Self(core::array::from_fn(|axis| RateRange::either_way(limits[axis])))
    }

    /// The greatest share, at most 1, of `more` that fits into the ranges on top of what is there.
    #[must_use]
    pub fn share(&self, there: &AxisRates, more: &AxisRates) -> f64 {
        self.share_of(there, more, |_| true)
    }

    /// The same over some axes.
    pub(crate) fn share_of(&self, there: &AxisRates, more: &AxisRates, counts: impl Fn(usize) -> bool) -> f64 {
        let room = |axis: usize| {
            let (there, more, range) = (there[axis], more[axis], self.0[axis]);
            match more {
                0.0 => 1.0,
                _ if more > 0.0 => (range.max - there) / more,
                _ => (range.min - there) / more,
            }
        };
        (0..AXES).filter(|axis| counts(*axis)).map(room).fold(1.0, f64::min).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From any distance and at any pace an axis comes to rest at its end, not beyond it, and slows down no harder than it can.
    #[test]
    fn an_axis_stops_at_its_end() {
        for (way, interval, strength) in [(3.0, 0.01, 0.1), (0.7, 0.3, 0.5), (1e-4, 0.02, 0.05), (2.0, 0.02, 1e6)] {
            let free = RateRange::either_way(0.4);
            let (mut at, mut rate, mut slowed) = (0.0, f64::NAN, 0.0_f64);
            for _ in 0..4000 {
                let range = free.before_ends([at, way - at], strength, interval);
                assert!(range.min <= 0.0 && range.max >= 0.0, "{range:?} at {at}");
                slowed = slowed.max(rate - range.max);
                rate = range.max;
                at += rate * interval;
            }
            assert!((at - way).abs() < 1e-12 && rate < 1e-12, "{at} of {way}");
            assert!(slowed <= strength * interval * (1.0 + 1e-9), "{slowed}");
        }
        // Beyond its end it may only go back.
        let beyond = RateRange::either_way(0.4).before_ends([5.0, -0.1], 0.1, 0.02);
        assert!(beyond.max == 0.0 && beyond.min == -0.4);
    }
}
