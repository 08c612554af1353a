//! What is left of a motion when axes come to their limits (thesis 3.3, eqs. 3.20 and 3.21): all rates get slower by the
//! same share, so that the load goes on along its path.

use crate::axes::{AXES, Axis, AxisRates, RateRanges};
use crate::cartesian::Machine;
use crate::singular::{Margin, Pace};

/// Which rates get slower together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scaling {
    /// All of them: the load keeps to its path in space.
    Uniform,
    /// All but that of the hoist, as in the thesis: the load keeps to its path seen from above, but not to its height.
    WithoutHoist,
}

/// A motion as fast as the axes allow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Saturated {
    /// The rates of the axes.
    pub rates: AxisRates,
    /// The share that is left of the first motion, which goes before.
    pub first: f64,
    /// The share that is left of the second motion.
    pub second: f64,
    /// Whether the hoist is slower than that, where it does not get slower with the others.
    pub is_hoist_cut: bool,
}

impl Saturated {
    /// Whether nothing is lost.
    pub fn is_whole(&self) -> bool {
        self.first == 1.0 && self.second == 1.0 && !self.is_hoist_cut
    }
}

/// What holds axes back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restraint {
    /// Between which rates each axis can move (rad/s, m/s).
    pub limits: RateRanges,
    /// How close to a singular position the load gets slower.
    pub margin: Margin,
    /// Which rates get slower together.
    pub scaling: Scaling,
}

impl Machine {
    /// What is left of two motions that are added: of the first as much as there can be, of the second as much as there
    /// can be beside it. Close to a singular position all rates get slower together in any case.
    pub fn saturate(&self, [first, second]: [AxisRates; 2], pace: Pace, restraint: &Restraint) -> Saturated {
        let Restraint { limits, margin, scaling } = restraint;
        let still = AxisRates::zeros();
        let free = self.ranges(RateRanges::either_way(&AxisRates::repeat(f64::INFINITY)), pace, *margin);
        let slow_first = free.share(&still, &first);
        let first = first * slow_first;
        let slow_second = free.share(&first, &second);
        let second = second * slow_second;

        let ranges = self.ranges(*limits, pace, *margin);
        let [hoist, line] = [Axis::Hoist as usize, Axis::HoistLine as usize];
        let counts = |axis| *scaling == Scaling::Uniform || ![hoist, line].contains(&axis);
        let share_first = ranges.share_of(&still, &first, counts);
        let share_second = ranges.share_of(&(first * share_first), &second, counts);
        let mut rates = first * share_first + second * share_second;
        let mut is_hoist_cut = false;
        if *scaling == Scaling::WithoutHoist {
            let mut cut = |axis: usize, rate: f64| {
                let cut = ranges.0[axis].cut(rate);
                is_hoist_cut |= cut != rate;
                cut
            };
            // What luffing takes of the hoist line.
            let luffed = rates[hoist] - rates[line];
            rates[hoist] = cut(hoist, first[hoist] + second[hoist]);
            if let Self::Boom { .. } = self {
                let wanted = rates[hoist] - luffed;
                rates[line] = cut(line, wanted);
                rates[hoist] += rates[line] - wanted;
            }
        }
        // Within the ranges to the last bit.
        for axis in (0..AXES).filter(|axis| counts(*axis)) {
            rates[axis] = ranges.0[axis].cut(rates[axis]);
        }
        Saturated { rates, first: slow_first * share_first, second: slow_second * share_second, is_hoist_cut }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::{Rigging, Vector};

    const DEGREE: f64 = PI / 180.0;
    const MARGIN: Margin = Margin { luff: 0.05, radius: 0.5 };

    fn boom(length: f64, luff: f64) -> Machine {
        let ropes = Rigging { boom: length, jib: 0.3 * length, sheave: 0.28 * length, jib_angle: 2.4 }.at(luff);
        Machine::Boom { length, luff, ropes }
    }

    fn restraint(limits: &[(Axis, f64)], scaling: Scaling) -> Restraint {
        let mut all = AxisRates::repeat(1e3);
        limits.iter().for_each(|(axis, limit)| all[*axis as usize] = *limit);
        Restraint { limits: RateRanges::either_way(&all), margin: MARGIN, scaling }
    }

    /// What is left of a velocity (radial, tangential, upwards).
    fn left(machine: &Machine, velocity: [f64; 3], restraint: &Restraint) -> Saturated {
        let [radial, tangential, vertical] = velocity;
        let pace = Pace { horizontal: radial.hypot(tangential), vertical, yaw: 0.0 };
        machine.saturate([AxisRates::zeros(), machine.rates(velocity.into())], pace, restraint)
    }

    /// How a run along the line y = 2 m ends, from x = −9.2 m to 9.2 m at 1 m/s with steps of 1 ms.
    struct Run {
        time: f64,
        saturated: f64,
        off_line: f64,
        off_height: f64,
        x: f64,
    }

    /// The line of thesis 3.3, with a boom of 10 m that luffs with at most 4°/s and slews with at most 15°/s.
    fn straight(rates: impl Fn(&Machine, [f64; 3]) -> (AxisRates, bool)) -> Run {
        const STEP: f64 = 1e-3;
        let (r, y) = (10.0, 2.0_f64);
        let (mut slew, mut luff, mut length) = (y.atan2(-9.2), (9.2_f64.hypot(y) / r).acos(), 5.0);
        let start = r * luff.sin() - length;
        let mut run = Run { time: 0.0, saturated: 0.0, off_line: 0.0, off_height: 0.0, x: 0.0 };
        loop {
            let x = r * luff.cos() * slew.cos();
            if x >= 9.2 {
                return run;
            }
            run.x = x;
            run.off_line = run.off_line.max((r * luff.cos() * slew.sin() - y).abs());
            run.off_height = run.off_height.max((r * luff.sin() - length - start).abs());
            let (rates, saturated) = rates(&boom(r, luff), [slew.cos(), -slew.sin(), 0.0]);
            luff += rates[Axis::Luff as usize] * STEP;
            slew += rates[Axis::Slew as usize] * STEP;
            length += rates[Axis::Hoist as usize] * STEP;
            run.time += STEP;
            run.saturated += if saturated { STEP } else { 0.0 };
        }
    }

    const LIMITS: [(Axis, f64); 2] = [(Axis::Luff, 4.0 * DEGREE), (Axis::Slew, 15.0 * DEGREE)];

    /// An independent integration by the same steps: time, saturated time, off the line, off the height, end.
    #[track_caller]
    fn assert_run(run: &Run, wanted: [f64; 5]) {
        let found = [run.time, run.saturated, run.off_line, run.off_height, run.x];
        for (found, wanted) in found.into_iter().zip(wanted) {
            assert!((found / wanted - 1.0).abs() < 1e-9, "{found}, not {wanted}");
        }
    }

    #[test]
    fn without_a_law_the_load_leaves_line_and_height() {
        let run = straight(|crane, velocity| {
            let rates = crane.rates(velocity.into());
            let mut cut = rates;
            for (axis, limit) in LIMITS {
                cut[axis as usize] = rates[axis as usize].clamp(-limit, limit);
            }
            (cut, cut != rates)
        });
        assert_run(&run, [27.134, 23.015, 1.640_972_577_814_698_4, 7.264_735_970_479_547, 9.199_792_952_057_51]);
    }

    #[test]
    fn the_thesis_law_keeps_the_line_but_not_the_height() {
        let law = restraint(&LIMITS, Scaling::WithoutHoist);
        let run = straight(|crane, velocity| {
            let motion = left(crane, velocity, &law);
            (motion.rates, !motion.is_whole())
        });
        assert_run(&run, [32.952, 32.952, 0.001_465_875_350_782_575, 8.158_369_211_923_11, 9.199_939_922_085_752]);
    }

    /// What is left are the errors of the steps.
    #[test]
    fn scaling_all_rates_keeps_line_and_height() {
        let law = restraint(&LIMITS, Scaling::Uniform);
        let run = straight(|crane, velocity| {
            let motion = left(crane, velocity, &law);
            (motion.rates, !motion.is_whole())
        });
        let height = 0.000_495_611_342_724_799_9;
        assert_run(&run, [32.952, 32.952, 0.001_465_875_350_782_575, height, 9.199_939_922_085_752]);
    }

    /// Velocities and machines, close to singular positions and not.
    fn cases() -> impl Iterator<Item = (Machine, [f64; 3])> {
        let angles =
            [-2.0, -1e-3, -1e-13, 0.0, 1e-300, 1e-9, 1e-3, 0.04, 0.7, 1.53, 1.57, FRAC_PI_2, 1.58, 3.0, PI, 1e5];
        let machines = angles.into_iter().flat_map(|luff| {
            let radius = luff.abs() * 10.0;
            [boom(18.0, luff), Machine::BoomLift { length: 13.0, luff }, Machine::Tower { radius }]
        });
        let velocities = (0..64).map(|i| {
            let part = |i: i32| [0.0, 1.0, -1.0, 1e-3][usize::try_from(i % 4).expect("small")];
            [part(i), part(i / 4), part(i / 16)]
        });
        let velocities: Vec<_> = velocities.collect();
        machines.flat_map(move |machine| velocities.clone().into_iter().map(move |velocity| (machine, velocity)))
    }

    /// Whatever is asked for, the rates are finite and within the limits, and in the direction that was asked for.
    #[test]
    fn rates_keep_to_limits_and_direction() {
        let mut law = restraint(&[], Scaling::Uniform);
        for limit in [0.0, 0.02, 0.3, 1e3] {
            law.limits = RateRanges::either_way(&AxisRates::repeat(limit));
            for (machine, velocity) in cases() {
                let motion = left(&machine, velocity, &law);
                let wanted = machine.rates(velocity.into()) * motion.second;
                assert!((0.0..=1.0).contains(&motion.second), "{machine:?} {velocity:?}: {motion:?}");
                for axis in 0..AXES {
                    let (rate, wanted) = (motion.rates[axis], wanted[axis]);
                    assert!(rate.abs() <= limit, "{machine:?} {velocity:?}: {motion:?}");
                    assert!(
                        (rate - wanted).abs() <= 1e-12 * (1.0 + wanted.abs()),
                        "{machine:?} {velocity:?}: {motion:?}"
                    );
                }
            }
        }
    }

    /// Without limits no axis is faster than at the margin, where the load has its full speed.
    #[test]
    fn no_rate_grows_beyond_that_at_the_margin() {
        let law = restraint(&[], Scaling::Uniform);
        for (machine, velocity) in cases() {
            let speed = Vector::from(velocity).norm();
            let motion = left(&machine, velocity, &law);
            let reach = match machine {
                Machine::Boom { length, .. } | Machine::BoomLift { length, .. } => length * MARGIN.luff.sin(),
                Machine::Tower { .. } => MARGIN.radius,
            };
            for axis in [Axis::Slew, Axis::Luff] {
                let rate = motion.rates[axis as usize].abs();
                assert!(rate <= speed / reach * (1.0 + 1e-12), "{machine:?} {velocity:?}: {axis:?} with {rate}");
            }
        }
    }

    /// From a singular position away the machine gets going, towards it it comes to rest.
    #[test]
    fn a_machine_leaves_a_singular_position_and_does_not_pass_it() {
        let law = restraint(&[(Axis::Luff, 0.07), (Axis::Slew, 0.2), (Axis::Trolley, 1.0)], Scaling::Uniform);
        let run = |velocity: [f64; 3], start: f64, machine: &dyn Fn(f64) -> Machine, axis: Axis| {
            (0..4000).fold(start, |at, _| at + 0.01 * left(&machine(at), velocity, &law).rates[axis as usize])
        };
        let (outwards, inwards) = ([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
        let crane = |luff| boom(18.0, luff);
        let lift = |luff| Machine::BoomLift { length: 13.0, luff };
        let tower = |radius| Machine::Tower { radius };
        for start in [0.0, 1e-9, 0.02, 0.5] {
            let low = run(outwards, start, &crane, Axis::Luff);
            assert!((0.0..=start.min(1e-3)).contains(&low), "from {start} to {low}");
            let far = run(inwards, start, &crane, Axis::Luff);
            assert!((1.5..=FRAC_PI_2).contains(&far), "from {start} to {far}");
            let high = FRAC_PI_2 - run(inwards, FRAC_PI_2 - start, &lift, Axis::Luff);
            assert!((0.0..=start.min(1e-3)).contains(&high), "from {start} to {high}");
            let lowered = FRAC_PI_2 - run(outwards, FRAC_PI_2 - start, &lift, Axis::Luff);
            assert!(lowered > 0.4, "from {start} to {lowered}");
            let near = run(inwards, start, &tower, Axis::Trolley);
            assert!((0.0..=start.min(1e-3)).contains(&near), "from {start} to {near}");
            assert!(run(outwards, start, &tower, Axis::Trolley) > 39.0);
        }
    }

    /// The speed has no jumps: neither over the position nor over the direction of the command, but at the singular
    /// position itself.
    #[test]
    fn the_speed_is_continuous() {
        let law = restraint(&[(Axis::Luff, 0.07), (Axis::Slew, 0.2)], Scaling::Uniform);
        let speed = |luff: f64, angle: f64| left(&boom(18.0, luff), [angle.cos(), angle.sin(), 0.1], &law).second;
        let greatest_jump =
            |speeds: Vec<f64>| speeds.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
        for i in 0..12 {
            let angle = 0.55 * f64::from(i);
            let jump = greatest_jump((0..4000).map(|i| speed(0.001 + 1.569 * f64::from(i) / 4000.0, angle)).collect());
            assert!(jump < 0.05, "{jump} at {angle}");
        }
        // Close to a singular angle it falls steeply as the direction turns towards it: to (s/m)² within some (s/m)².
        for luff in [0.015, 0.04, 0.3, 1.3, 1.54, 1.555] {
            let jump = greatest_jump((0..8000).map(|i| speed(luff, 6.3 * f64::from(i) / 8000.0)).collect());
            assert!(jump < 0.2, "{jump} at {luff}");
        }
    }

    /// The second motion has what the first leaves.
    #[test]
    fn what_goes_before_stays_whole() {
        let law = restraint(&LIMITS, Scaling::Uniform);
        let machine = boom(10.0, 0.9);
        let pace = Pace { horizontal: 3.0, vertical: 0.0, yaw: 0.0 };
        let motions = [[0.4, 0.1, 0.0], [1.5, -0.7, 0.2]].map(|velocity| machine.rates(velocity.into()));
        let motion = machine.saturate(motions, pace, &law);
        assert!(motion.first == 1.0 && motion.second < 0.5 && !motion.is_whole(), "{motion:?}");
        assert!((motion.rates - motions[0] - motions[1] * motion.second).amax() < 1e-15);
        // What is too fast by itself leaves nothing for what goes the same way.
        let motion = machine.saturate([motions[0] * 9.0, motions[1]], pace, &law);
        assert!(motion.first < 1.0 && motion.second == 0.0, "{motion:?}");
        let motion = machine.saturate([motions[0] * 9.0, -motions[1]], pace, &law);
        assert!(motion.first < 1.0 && motion.second > 0.0, "{motion:?}");
    }

    /// The luff line and the hoist line have limits of their own.
    #[test]
    fn lines_saturate_as_axes_do() {
        let machine = boom(10.0, 0.9);
        let free = machine.rates(Vector::new(0.5, 0.2, 0.1));
        for axis in [Axis::LuffLine, Axis::HoistLine] {
            let limit = 0.25 * free[axis as usize].abs();
            for scaling in [Scaling::Uniform, Scaling::WithoutHoist] {
                let motion = left(&machine, [0.5, 0.2, 0.1], &restraint(&[(axis, limit)], scaling));
                assert!((motion.rates[axis as usize].abs() - limit).abs() < 1e-15 && !motion.is_whole());
                let hoist_alone = scaling == Scaling::WithoutHoist && axis == Axis::HoistLine;
                assert_eq!(motion.second, if hoist_alone { 1.0 } else { 0.25 });
            }
        }
    }
}
