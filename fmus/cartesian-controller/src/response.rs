//! Where the joints will be when the drives have done what they were told: the drives answer late, and what is told now
//! has its effect then.

use serde::{Deserialize, Serialize};

/// The response of a drive, 1/(s²/ω² + 2ζs/ω + 1) from commanded to true rate, which all axes share.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Response {
    /// ω (rad/s); 0 for a drive that follows at once.
    pub frequency: f64,
    /// ζ.
    pub damping: f64,
}

/// How one drive moves, as far as it does what it is told.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "[f64; 2]", into = "[f64; 2]")]
pub struct Driven {
    rate: f64,
    acceleration: f64,
}

impl From<Driven> for [f64; 2] {
    fn from(Driven { rate, acceleration }: Driven) -> Self {
        [rate, acceleration]
    }
}

impl TryFrom<[f64; 2]> for Driven {
    type Error = &'static str;

    fn try_from([rate, acceleration]: [f64; 2]) -> Result<Self, Self::Error> {
        // No drive gets there: rates are cut at 100, and a response has at most 10⁴ rad/s.
        let can_be = rate.abs() < 1e6 && acceleration.abs() < 1e12;
        can_be.then_some(Self { rate, acceleration }).ok_or("a drive is faster than any")
    }
}

impl Response {
    /// The mean delay of a drive (s): 2ζ/ω.
    pub fn delay(self) -> f64 {
        if self.frequency == 0.0 { 0.0 } else { 2.0 * self.damping / self.frequency }
    }

    /// How far a joint still goes if its drive is told to stop: (2ζω v + v̇)/ω², which is how far it is behind what its
    /// drive has been told.
    pub fn way_to_go(self, driven: Driven) -> f64 {
        if self.frequency == 0.0 {
            return 0.0;
        }
        let omega = self.frequency;
        (2.0 * self.damping * omega * driven.rate + driven.acceleration) / (omega * omega)
    }

    /// How a drive moves after an interval (s) in which it was told a rate: by the trapezoidal rule, which is stable at
    /// any interval.
    pub fn driven(self, from: Driven, told: f64, interval: f64) -> Driven {
        let (omega, half) = (self.frequency, 0.5 * interval.min(LONGEST));
        if omega == 0.0 {
            return Driven::default();
        }
        let Driven { rate: v, acceleration: a } = from;
        let (stiffness, damping) = (omega * omega, 2.0 * self.damping * omega);
        let acceleration = (a + half * (stiffness * (2.0 * (told - v) - half * a) - damping * a))
            / (1.0 + half * (damping + half * stiffness));
        Driven { rate: v + half * (a + acceleration), acceleration }
    }
}

/// Beyond, a drive has settled in any case (s), unless it is not damped at all.
const LONGEST: f64 = 1e3;

#[cfg(test)]
mod tests {
    use super::*;

    /// The rates of a drive at rest that is told 1 from then on, by the closed form.
    fn step_response(Response { frequency, damping }: Response, t: f64) -> f64 {
        let damped = frequency * (1.0 - damping * damping).sqrt();
        let (sin, cos) = (damped * t).sin_cos();
        1.0 - (-damping * frequency * t).exp() * (cos + damping * frequency / damped * sin)
    }

    #[test]
    fn a_drive_answers_a_step_as_its_closed_form() {
        let response = Response { frequency: 3.7, damping: 0.75 };
        let (mut driven, mut way) = (Driven::default(), 0.0);
        for i in 1..=400 {
            let before = driven.rate;
            driven = response.driven(driven, 1.0, 0.01);
            way += 0.005 * (before + driven.rate);
            let t = 0.01 * f64::from(i);
            // The error of the rule: (ω h)³/12 each step, for a few times 1/(ω h) steps.
            assert!((driven.rate - step_response(response, t)).abs() < 1.5e-4, "{} after {t} s", driven.rate);
            // What it has been told, less what it has done.
            assert!((response.way_to_go(driven) - (t - way)).abs() < 1e-12);
        }
        assert!((response.way_to_go(driven) - response.delay()).abs() < 1e-4);
    }

    #[test]
    fn any_interval_and_state_stays_finite() {
        for frequency in [0.0, 0.1, 3.7, 1e4] {
            for damping in [0.0, 0.75, 10.0] {
                let response = Response { frequency, damping };
                let mut driven = Driven { rate: -1e6, acceleration: 1e12 };
                for interval in [1e-300, 1e-5, 0.01, 1.0, 1e3, 1e300] {
                    driven = response.driven(driven, 100.0, interval);
                    assert!(response.way_to_go(driven).is_finite() && response.delay().is_finite());
                }
            }
        }
    }

    #[test]
    fn forged_states_are_refused() {
        for forged in [[f64::NAN, 0.0], [0.0, f64::INFINITY], [2e6, 0.0], [0.0, -1e13]] {
            assert!(Driven::try_from(forged).is_err());
        }
        assert_eq!(Driven::try_from([1.0, -2.0]), Ok(Driven { rate: 1.0, acceleration: -2.0 }));
    }
}
