//! Near to a singular position, where some velocity would take an infinite rate: what is left of the rates there.

use crate::axes::{Axis, RateRanges};
use crate::cartesian::{Machine, off_zero};

/// How close to a singular position a machine slows down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margin {
    /// From a singular luff angle (rad); above 0, below 45°.
    pub luff: f64,
    /// From the slewing axis, of a trolley (m); above 0.
    pub radius: f64,
}

/// How fast the load and the slewing axis move, which bounds what rates make sense near a singular position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pace {
    /// Horizontal speed asked for, against what the axis stands on (m/s).
    pub horizontal: f64,
    /// Vertical speed asked for (m/s).
    pub vertical: f64,
    /// Yaw rate of what the axis stands on (rad/s).
    pub yaw: f64,
}

impl Machine {
    /// How far it is from the nearest singular position, as a share of the margin; 1 where that is out of the margin.
    pub fn clearance(&self, margin: Margin) -> f64 {
        let way = match *self {
            Self::Boom { luff, .. } => from_horizontal(luff).0.min(from_upright(luff).0) / margin.luff,
            Self::BoomLift { luff, .. } => from_upright(luff).0 / margin.luff,
            Self::Tower { radius } => radius / margin.radius,
        };
        way.min(1.0)
    }

    /// Between which rates its axes can move, with what each could do elsewhere.
    ///
    /// No rate gets greater than at the margin: within, the load moves slower instead. And what brings the machine closer
    /// to a singular position gets slower on its way and stops there; what leads away from it goes on.
    pub fn ranges(&self, limits: RateRanges, pace: Pace, margin: Margin) -> RateRanges {
        let mut ranges = limits;
        let share = |way: f64, margin: f64| (way / margin).min(1.0);
        let (slew, luff, trolley) = (Axis::Slew as usize, Axis::Luff as usize, Axis::Trolley as usize);
        match *self {
            Self::Boom { length, luff: angle, .. } => {
                let most = pace.horizontal / (length * margin.luff.sin());
                ranges.0[slew] = ranges.0[slew].within(most + pace.yaw.abs());
                let (low, up) = from_horizontal(angle);
                let (high, down) = from_upright(angle);
                // Towards the upright the luff rate needs no bound other than its own.
                let most = if high < margin.luff { pace.horizontal / (length * angle.sin().abs()) } else { most };
                ranges.0[luff] = ranges.0[luff]
                    .within(most)
                    .slowed(-up, share(low, margin.luff))
                    .slowed(-down, share(high, margin.luff));
            }
            Self::Tower { radius } => {
                ranges.0[slew] = ranges.0[slew].within(pace.horizontal / margin.radius + pace.yaw.abs());
                if radius < margin.radius {
                    ranges.0[trolley] =
                        ranges.0[trolley].within(pace.horizontal).slowed(-1.0, share(radius, margin.radius));
                }
            }
            Self::BoomLift { length, luff: angle } => {
                let most = pace.horizontal / (length * margin.luff.sin());
                ranges.0[slew] = ranges.0[slew].within(most + pace.yaw.abs());
                let (high, down) = from_upright(angle);
                if high < margin.luff {
                    ranges.0[luff] = ranges.0[luff]
                        .within(pace.horizontal.hypot(pace.vertical) / length)
                        .slowed(-down, share(high, margin.luff));
                }
            }
        }
        ranges
    }
}

/// How far a luff angle is from horizontal (rad), and the sign of the rate that leads away from it.
fn from_horizontal(luff: f64) -> (f64, f64) {
    let (sin, cos) = luff.sin_cos();
    (sin.abs().asin(), off_zero(sin).signum() * off_zero(cos).signum())
}

/// How far a luff angle is from upright (rad), and the sign of the rate that leads away from it.
fn from_upright(luff: f64) -> (f64, f64) {
    let (sin, cos) = luff.sin_cos();
    (cos.abs().asin(), -off_zero(sin).signum() * off_zero(cos).signum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::axes::{AXES, AxisRates};
    use crate::{Rigging, Vector};

    const MARGIN: Margin = Margin { luff: 0.05, radius: 0.5 };

    #[test]
    fn away_from_singular_positions_nothing_is_slower() {
        let limits = RateRanges::either_way(&AxisRates::repeat(0.3));
        let pace = Pace { horizontal: 5.0, vertical: 1.0, yaw: 0.2 };
        for i in 0..60 {
            let (luff, length) = (-3.0 + 0.097 * f64::from(i), 0.5 + 0.7 * f64::from(i));
            let ropes = Rigging { boom: length, jib: 0.33, sheave: 0.29, jib_angle: 2.4 }.at(luff);
            let boom = Machine::Boom { length, luff, ropes };
            let lift = Machine::BoomLift { length, luff };
            let tower = Machine::Tower { radius: length };
            for machine in [boom, lift, tower] {
                if machine.clearance(MARGIN) < 1.0 {
                    continue;
                }
                for velocity in [[5.0, 0.0, 1.0], [-3.0, 4.0, -1.0], [0.0, -5.0, 0.0]].map(Vector::from) {
                    let free =
                        machine.ranges(RateRanges::either_way(&AxisRates::repeat(f64::INFINITY)), pace, MARGIN).0;
                    let rates = machine.rates(velocity);
                    let fits = |axis: usize| free[axis].min <= rates[axis] && rates[axis] <= free[axis].max;
                    // At the margin itself both are the same but for rounding.
                    assert!((0..AXES).all(|axis| fits(axis) || rates[axis].abs() < 1.0001 * free[axis].max));
                    let ranges = machine.ranges(limits, pace, MARGIN).0;
                    assert!((0..AXES).all(|axis| ranges[axis].max <= 0.3 && ranges[axis].min >= -0.3));
                }
            }
        }
    }
}
