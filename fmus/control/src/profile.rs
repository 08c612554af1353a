//! The fastest way to a place, at a bounded velocity and acceleration, decided anew at every sample.

/// What a move must keep to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Greatest speed (m/s).
    pub velocity: f64,
    /// Greatest change of it (m/s²).
    pub acceleration: f64,
}

impl Limits {
    /// The velocity nearest to `wanted` that can be had an `interval` (s) after `velocity`.
    #[must_use]
    pub fn towards(&self, wanted: f64, velocity: f64, interval: f64) -> f64 {
        let change = self.acceleration * interval;
        wanted.clamp(-self.velocity, self.velocity).clamp(velocity - change, velocity + change)
    }

    /// The greatest speed (m/s) from which one can still stop in a `way` (m), braking every `interval` (s).
    ///
    /// Braking by a·Δt at each sample from v takes the way v Δt + (v − aΔt) Δt + … = (v² + a Δt v)/2a, if v is a multiple
    /// of aΔt; so that speed is v = −aΔt/2 + √((aΔt/2)² + 2 a s), and following that law brakes by exactly aΔt. The last
    /// sample takes what is left.
    #[must_use]
    pub fn braking(&self, way: f64, interval: f64) -> f64 {
        let half = 0.5 * self.acceleration * interval;
        (half.hypot((2.0 * self.acceleration * way).sqrt()) - half).max(0.0).min(way / interval)
    }

    /// The velocity for the next `interval` (s) of the fastest way over a `distance` (m) to rest there, now at `velocity`.
    ///
    /// Since it looks at nothing but where it is and how fast, it makes a new plan at every sample.
    #[must_use]
    pub fn to_rest_after(&self, distance: f64, velocity: f64, interval: f64) -> f64 {
        if interval <= 0.0 {
            return velocity;
        }
        self.towards(self.braking(distance.abs(), interval).copysign(distance), velocity, interval)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const LIMITS: Limits = Limits { velocity: 0.75, acceleration: 0.63 };

    fn run(distance: f64, velocity: f64, interval: f64, count: usize) -> Vec<[f64; 2]> {
        let (mut place, mut velocity) = (0.0, velocity);
        let mut next = || {
            velocity = LIMITS.to_rest_after(distance - place, velocity, interval);
            place += velocity * interval;
            [place, velocity]
        };
        (0..count).map(|_| next()).collect()
    }

    proptest! {
        #[test]
        fn every_move_ends_at_its_target_within_the_limits(distance in -20.0..20.0_f64, start in -0.75..0.75_f64, interval in 1e-3..0.2_f64) {
            // As long as the way and a detour take at full speed, and both ramps.
            let count = ((distance.abs() + 1.0) / 0.75 + 6.0) / interval;
            let course = run(distance, start, interval, count as usize);
            let mut before = start;
            for [_, velocity] in &course {
                prop_assert!(velocity.abs() <= 0.75 && (velocity - before).abs() <= 0.63 * interval * (1.0 + 1e-9));
                before = *velocity;
            }
            let [place, velocity] = course[course.len() - 1];
            prop_assert!((place - distance).abs() < 1e-12 * (1.0 + distance.abs()) && velocity.abs() < 1e-9, "{place} at {velocity}");
        }
    }

    /// The trapezoid: s/v + v/a, and an interval for what does not fit.
    #[test]
    fn a_move_is_as_fast_as_a_trapezoid() {
        let course = run(3.0, 0.0, 0.01, 2000);
        let end = course.iter().position(|[place, _]| (place - 3.0).abs() < 1e-9).expect("an end") + 1;
        let fastest = 3.0 / 0.75 + 0.75 / 0.63;
        let took = 0.01 * end as f64;
        assert!((fastest - 0.01..fastest + 0.05).contains(&took), "{took} s for {fastest} s");
        // Beyond it by what braking in whole steps leaves over, at most.
        assert!(course.iter().all(|[place, _]| *place <= 3.0 + 0.63 * 0.01 * 0.01));
    }
}
