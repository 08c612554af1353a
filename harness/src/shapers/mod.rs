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
        let modes = &self.modes[..if both { self.modes.len().min(2) } else { 1 }];
        let mut wanted = Specification {
            vibration_limit: self.vibration_limit,
            base_kinds: self.base_kinds,
            solution: self.solution,
            ..Specification::new(kind, modes[0].mode)
        };
        // SI kinds are for ranges, in the middle of which their design frequencies are, and both as wide as the wider.
        let kinds = if kind == Kind::Convolved { self.base_kinds } else { [kind; 2] };
        wanted.modes = [0, 1].map(|place| {
            let mode = modes.get(place)?;
            Some(if needs_insensitivity(kinds[place]) { mode.middle() } else { mode.mode })
        });
        let ranges = modes.iter().zip(kinds).filter(|(_, kind)| needs_insensitivity(*kind));
        if let Some(widest) = ranges.map(|(mode, _)| mode.insensitivity()).reduce(f64::max) {
            wanted.insensitivity = widest;
        }
        if let Some(DriveStep { drive, velocity }) = self.drive {
            wanted.velocity_limit = velocity;
            match drive {
                Drive::RateLimit { acceleration } => wanted.acceleration_limit = acceleration,
                Drive::FirstOrder { acceleration_time_constant, braking_time_constant } => {
                    wanted.acceleration_time_constant = acceleration_time_constant;
                    wanted.braking_time_constant = braking_time_constant;
                }
                Drive::Ideal | Drive::SecondOrder { .. } => {}
            }
        }
        wanted
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
