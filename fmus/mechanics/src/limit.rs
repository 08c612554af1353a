//! End stops of a joint: at a limit it does not go further, whatever its rate is.

/// The range of a joint.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The least position.
    pub min: f64,
    /// The greatest position.
    pub max: f64,
}

impl Limits {
    /// Event indicators, one for each end: not positive while the joint is held there. A joint is held from when it
    /// meets the stop until its rate points away, so that an indicator is the greater of way left and rate.
    pub fn indicators(self, position: f64, rate: f64) -> [f64; 2] {
        [(position - self.min).max(rate), (self.max - position).max(-rate)]
    }

    /// Whether the joint is held; if so, puts it on the stop, so that the indicator says so too.
    pub fn hold(self, position: &mut f64, rate: f64) -> bool {
        // An importer may stop a little before the crossing.
        let close = 1e-12 * self.min.abs().max(self.max.abs());
        let [low, high] = self.indicators(*position, rate);
        if low <= close && rate <= 0.0 {
            *position = self.min;
        } else if high <= close && rate >= 0.0 {
            *position = self.max;
        } else {
            return false;
        }
        true
    }

    /// What is wrong with a start position, if anything.
    pub fn check(self, position: f64) -> Option<String> {
        let Self { min, max } = self;
        if min > max {
            return Some(format!("lies between a least position of {min} and a greatest of {max}, which is less"));
        }
        let outside = position < min || position > max;
        outside.then(|| format!("is {position}; it must lie between {min} and {max}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_joint_is_held_at_its_stop_until_it_turns_back() {
        let limits = Limits { min: 1.0, max: 2.0 };
        let mut position = 2.0 + 1e-13;
        assert!(limits.hold(&mut position, 0.5));
        assert_eq!(position, 2.0);
        assert!(limits.indicators(position, 0.5)[1] <= 0.0);
        assert!(limits.indicators(position, -0.5)[1] > 0.0);
        assert!(!limits.hold(&mut position, -0.5));
        assert!(limits.hold(&mut position, 0.0), "at rest on the stop");
        let mut inside = 1.5;
        assert!(!limits.hold(&mut inside, -9.0));
        assert_eq!(inside, 1.5);
    }

    #[test]
    fn a_start_outside_is_refused() {
        assert_eq!(Limits { min: 1.0, max: 2.0 }.check(1.0), None);
        assert!(Limits { min: 1.0, max: 2.0 }.check(2.5).is_some_and(|why| why.contains("2.5")));
        assert!(Limits { min: 3.0, max: 2.0 }.check(2.5).is_some());
    }
}
