//! The poles of a crane whose swing and position are fed back (thesis 6.2.3).

use nalgebra::{Complex, SMatrix, SVector, Schur};
use swayless_shaping::{Mode, ModeError};

use crate::crane::Crane;

/// How many states a crane's axis has: x, V, V̇, p and ṗ.
const ORDER: usize = 7;

type Dynamics = SMatrix<f64, ORDER, ORDER>;

/// What is fed back: the command is `position_gain` (x_d − x) + `sway_gain` (θ + `lead_time` θ̇), with the hook's angle θ = u_h/L_h.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Feedback {
    /// K_p (1/s).
    pub position_gain: f64,
    /// k (m/s per rad).
    pub sway_gain: f64,
    /// How far ahead of the swing the feedback is (s).
    pub lead_time: f64,
}

/// A pole in the upper half plane, or on the real axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pole {
    /// |s| (rad/s).
    pub frequency: f64,
    /// −Re s/|s|: negative where the motion grows.
    pub damping_ratio: f64,
}

impl From<Complex<f64>> for Pole {
    fn from(s: Complex<f64>) -> Self {
        let frequency = s.norm();
        Self { frequency, damping_ratio: if frequency == 0.0 { 1.0 } else { -s.re / frequency } }
    }
}

/// The poles of a closed loop.
#[derive(Clone, Copy, Debug)]
pub struct ClosedLoop {
    poles: SVector<Complex<f64>, ORDER>,
    /// How many modes hook and payload have.
    modes: usize,
}

fn dynamics(crane: &Crane, feedback: Feedback) -> Dynamics {
    let Crane { pendulum, drive } = *crane;
    let (omega, stiffness, push) = (drive.natural_frequency, pendulum.stiffness(), pendulum.push());
    let mut a = Dynamics::zeros();
    (a[(0, 1)], a[(1, 2)], a[(3, 5)], a[(4, 6)]) = (1.0, 1.0, 1.0, 1.0);
    let angle_gain = feedback.sway_gain / pendulum.hoist;
    let gains = [-feedback.position_gain, -1.0, 0.0, angle_gain, 0.0, angle_gain * feedback.lead_time, 0.0];
    for (column, gain) in gains.into_iter().enumerate() {
        a[(2, column)] = omega * omega * gain;
    }
    a[(2, 2)] -= 2.0 * drive.damping_ratio * omega;
    for row in 0..2 {
        a[(5 + row, 2)] = -push[row];
        for column in 0..2 {
            a[(5 + row, 3 + column)] = -stiffness[(row, column)];
        }
    }
    if pendulum.mass_ratio == 0.0 {
        // What does not hang there does not swing: its coordinate only decays.
        (a[(6, 4)], a[(6, 6)]) = (-stiffness[(1, 1)], -2.0 * stiffness[(1, 1)].sqrt());
    }
    a
}

/// The poles of a crane with feedback; none if they cannot be computed, as with gains beyond all measure.
#[must_use]
pub fn closed_loop(crane: &Crane, feedback: Feedback) -> Option<ClosedLoop> {
    let dynamics = dynamics(crane, feedback);
    if !dynamics.iter().all(|element| element.is_finite()) {
        return None;
    }
    let poles = Schur::try_new(dynamics, f64::EPSILON, 1000)?.complex_eigenvalues();
    Some(ClosedLoop { poles, modes: if crane.pendulum.mass_ratio == 0.0 { 1 } else { 2 } })
}

impl ClosedLoop {
    /// All poles but conjugates, in order of frequency.
    pub fn poles(&self) -> impl Iterator<Item = Pole> {
        let mut poles: [Complex<f64>; ORDER] = self.poles.into();
        poles.sort_unstable_by(|a, b| a.norm_sqr().total_cmp(&b.norm_sqr()).then(a.im.total_cmp(&b.im)));
        poles.into_iter().filter(|s| s.im >= 0.0).map(Pole::from)
    }

    /// Whether all motion decays but, without position feedback, where the trolley stands.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        let largest = self.poles.iter().map(|s| s.norm()).fold(0.0, f64::max);
        self.poles.iter().all(|s| s.re < 1e-9 * largest)
    }

    /// The modes that swing, the least damped ones, in order of frequency. Where feedback damps them so well that they do not
    /// swing any more they are fewer than hook and payload have; one that grows counts as undamped.
    ///
    /// # Errors
    /// [`ModeError`] for a frequency that no shaper can be designed for.
    pub fn modes(&self) -> Result<[Option<Mode>; 2], ModeError> {
        const TOO_DAMPED_TO_SWING: f64 = 0.9;
        let mut least: [Option<Pole>; 2] = [None; 2];
        for s in self.poles.iter().filter(|s| s.im > 0.0) {
            let pole = Pole::from(*s);
            if pole.damping_ratio > TOO_DAMPED_TO_SWING {
                continue;
            }
            let mut next = Some(pole);
            for held in &mut least[..self.modes] {
                if let Some(new) = next
                    && held.is_none_or(|held| new.damping_ratio < held.damping_ratio)
                {
                    next = held.replace(new);
                }
            }
        }
        if let [Some(a), Some(b)] = least
            && a.frequency > b.frequency
        {
            least.swap(0, 1);
        }
        let mode =
            |pole: Option<Pole>| pole.map(|pole| Mode::new(pole.frequency, pole.damping_ratio.max(0.0))).transpose();
        Ok([mode(least[0])?, mode(least[1])?])
    }
}
