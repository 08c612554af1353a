//! Shapers of all kinds side by side: what each costs, what it leaves, and which to take.

mod behind;
pub mod candidate;
pub mod recommendation;

use std::ops::RangeInclusive;

use swayless_shaping::{Design, Drive, Kind, Mode, Specification, residual_vibration};

pub use behind::{DriveStep, Ramps};
use candidate::needs_insensitivity;
pub use candidate::{Candidate, Figures, OfMode, Refusal};
pub use recommendation::{Recommendation, recommend};

/// What shapers are compared for.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// One mode, or two.
    pub modes: Vec<UncertainMode>,
    /// Residual vibration that is allowed, as a share of the unshaped one.
    pub vibration_limit: f64,
    /// Residual vibration at which insensitivity is measured.
    pub level: f64,
    /// What `Convolved` is made of.
    pub base_kinds: [Kind; 2],
    /// Which of the solutions of `MinimumImpulse`, from 1.
    pub solution: usize,
    /// The drive behind the shaper; `None` for one that follows at once.
    pub drive: Option<DriveStep>,
    /// The kinds to compare.
    pub kinds: Vec<Kind>,
}

/// A mode that is not known exactly.
#[derive(Debug, Clone, PartialEq)]
pub struct UncertainMode {
    /// What shapers are designed for.
    pub mode: Mode,
    /// The frequencies (rad/s) that it may have.
    pub range: RangeInclusive<f64>,
}

impl Request {
    /// The shapers of all its kinds, in their order.
    pub fn candidates(&self) -> Vec<Candidate> {
        self.kinds.iter().map(|kind| Candidate::new(self, *kind)).collect()
    }

    /// Residual vibration that a shaper leaves of a mode, behind the drive if one is given.
    pub fn vibration(&self, design: &Design, mode: Mode) -> f64 {
        match self.drive {
            Some(drive) => drive.vibration(design, mode),
            None => residual_vibration(design.shaper(), mode.frequency(), mode.damping_ratio()),
        }
    }

    fn has_acceleration_limit(&self) -> bool {
        self.drive.is_some_and(|step| matches!(step.drive, Drive::RateLimit { .. }))
    }

    fn has_time_constants(&self) -> bool {
        self.drive.is_some_and(|step| matches!(step.drive, Drive::FirstOrder { .. }))
    }

    /// What is asked of a kind for the first mode alone, or for both.
    fn specification(&self, kind: Kind, both: bool) -> Specification {
        let first = &self.modes[0];
        let second = self.modes.get(1).filter(|_| both).map(|second| second.mode);
        let mut plain = Specification {
            vibration_limit: self.vibration_limit,
            base_kinds: self.base_kinds,
            solution: self.solution,
            ..Specification::new(kind, first.mode)
        };
        if let Some(DriveStep { drive, velocity }) = self.drive {
            plain.velocity_limit = velocity;
            match drive {
                Drive::RateLimit { acceleration } => plain.acceleration_limit = acceleration,
                Drive::FirstOrder { acceleration_time_constant, braking_time_constant } => {
                    plain.acceleration_time_constant = acceleration_time_constant;
                    plain.braking_time_constant = braking_time_constant;
                }
                Drive::Ideal | Drive::SecondOrder { .. } => {}
            }
        }
        match kind {
            // These are for ranges, in the middle of which their design frequencies are, and both as wide as the wider.
            _ if needs_insensitivity(kind) => {
                let widths = self.modes.iter().take(if both { 2 } else { 1 }).map(UncertainMode::insensitivity);
                let second = second.and(self.modes.get(1)).map(UncertainMode::middle);
                let insensitivity = widths.fold(0.0, f64::max);
                Specification { modes: [Some(first.middle()), second], insensitivity, ..plain }
            }
            _ => Specification { modes: [Some(first.mode), second], ..plain },
        }
    }
}

/// Ranges are not known more exactly than to one part in so many.
const EXACTNESS: f64 = 1e12;

impl UncertainMode {
    /// The mode with the frequency in the middle of the range.
    fn middle(&self) -> Mode {
        let middle = 0.5 * (self.range.start() + self.range.end());
        // What is in the middle but for a rounding stays what it was given as.
        match (middle - self.mode.frequency()).abs() * EXACTNESS <= middle {
            true => self.mode,
            false => Mode::new(middle, self.mode.damping_ratio()).unwrap_or(self.mode),
        }
    }

    /// The full width of the range over its middle.
    fn insensitivity(&self) -> f64 {
        let width = (self.range.end() - self.range.start()) / self.middle().frequency();
        (width * EXACTNESS).round() / EXACTNESS
    }
}
