//! Swing: where it starts, and what is seen of it.

use swayless_export::{Scalar, Variables};
use swayless_mechanics::{Payload, Suspension, Swing, SwingFrame};

/// Damping and start of a swing.
#[derive(Clone, Variables)]
pub struct SwingParameters<R: Scalar> {
    /// Damping of the swing (d); for small swing 2ζω.
    #[variable(unit = "1/s", min = 0.0, max = 1e3)]
    pub damping: R,
    /// Radial swing at the start.
    #[variable(unit = "rad", min = -1.57, max = 1.57)]
    pub radial_start: R,
    /// Tangential swing at the start.
    #[variable(unit = "rad", min = -std::f64::consts::PI, max = std::f64::consts::PI)]
    pub tangential_start: R,
    /// Rate of the radial swing at the start.
    #[variable(unit = "rad/s", min = -100.0, max = 100.0)]
    pub radial_rate_start: R,
    /// Rate of the tangential swing at the start.
    #[variable(unit = "rad/s", min = -100.0, max = 100.0)]
    pub tangential_rate_start: R,
}

impl<R: Scalar> SwingParameters<R> {
    /// The payload at the start, under a resting pivot of a crane that points to `yaw` (rad).
    pub fn started(&self, yaw: R, length: R) -> Payload<R> {
        let frame = SwingFrame::new(yaw, R::zero());
        let angles = Swing { radial: self.radial_start, tangential: self.tangential_start };
        let rates = Swing { radial: self.radial_rate_start, tangential: self.tangential_rate_start };
        Payload::started(frame.direction(angles), frame.direction_rate(angles, rates), length)
    }
}

/// What is seen of a swing.
#[derive(Clone, Variables)]
pub struct SwingOutputs<R: Scalar> {
    /// Radial swing, positive away from the slewing axis.
    #[variable(unit = "rad")]
    pub radial: R,
    /// Tangential swing, positive towards increasing slew.
    #[variable(unit = "rad")]
    pub tangential: R,
    /// Time derivative of the radial swing.
    #[variable(unit = "rad/s")]
    pub radial_rate: R,
    /// Time derivative of the tangential swing.
    #[variable(unit = "rad/s")]
    pub tangential_rate: R,
    /// Amplitude the payload would swing with if the pivot kept its present velocity and the hoist stopped.
    #[variable(unit = "rad")]
    pub amplitude: R,
}

impl<R: Scalar> SwingOutputs<R> {
    /// The swing of a payload, seen in a frame.
    pub fn of(payload: &Payload<R>, suspension: &Suspension<R>, frame: &SwingFrame<R>, gravity: R) -> Self {
        let n = payload.unit();
        let Swing { radial, tangential } = frame.angles(n);
        let rates = frame.rates(n, payload.direction_rate(suspension));
        let amplitude = payload.amplitude(suspension, gravity);
        Self { radial, tangential, radial_rate: rates.radial, tangential_rate: rates.tangential, amplitude }
    }
}
