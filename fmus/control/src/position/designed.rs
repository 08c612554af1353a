//! What a position controller designs for a crane.

use swayless_shaping::{Mode, Shaper};

use super::Form;
use crate::crane::Crane;
use crate::pendulum::Modes;
use crate::poles::{Feedback, closed_loop};
use crate::shapers::zero_vibration;

/// What is designed, and for what.
#[derive(Clone, Debug)]
pub struct Designed {
    pub of: (Crane, Form, Feedback),
    pub modes: Modes,
    pub shaper: Shaper,
    pub is_stable: bool,
}

impl Designed {
    /// The design for a crane.
    pub fn new(crane: Crane, form: Form, feedback: Feedback) -> Self {
        let modes = crane.pendulum.modes();
        let sway = Feedback { position_gain: 0.0, ..feedback };
        let shaped = match form {
            // The plan runs through the crane as it is.
            Form::Planned => {
                crane.pendulum.seen(&modes).map(|frequency| frequency.and_then(|f| Mode::new(f, 0.0).ok()))
            }
            Form::InLoop | Form::PlainLoop => {
                closed_loop(&crane, sway).and_then(|poles| poles.modes().ok()).unwrap_or_default()
            }
        };
        // With the prediction a position loop moves none of the other poles.
        let fed_back = if form == Form::InLoop { sway } else { feedback };
        let is_stable = closed_loop(&crane, fed_back).is_some_and(|poles| poles.is_stable());
        Self { of: (crane, form, feedback), modes, shaper: zero_vibration(shaped), is_stable }
    }
}
