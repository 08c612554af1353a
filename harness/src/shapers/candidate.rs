//! One kind of shaper in numbers.

use std::ops::RangeInclusive;

use swayless_shaping::{
    Design, Kind, Sensitivity, Shaper, Specification, SpecificationError, highest_vibration, insensitivity,
    residual_vibration,
};

use super::behind::width;
use super::{Ramps, Request, UncertainMode};

/// A kind of shaper: its numbers, or why there is none.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// The kind.
    pub kind: Kind,
    /// What it is designed by. With two modes, a kind for one is designed for the first.
    pub specification: Specification,
    /// What came of it.
    pub result: Result<Figures, Refusal>,
}

/// Why there is no shaper of a kind.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// It is made for an acceleration limit, and none is given.
    #[error("is made for a drive with an acceleration limit")]
    NoAccelerationLimit,
    /// It is made for unequal time constants, and none are given.
    #[error("is made for a drive that accelerates and brakes with different time constants")]
    NoTimeConstants,
    /// What is asked for has no design.
    #[error(transparent)]
    Specification(#[from] SpecificationError),
}

/// What a shaper costs and what it leaves.
#[derive(Debug, Clone)]
pub struct Figures {
    /// The design.
    pub design: Design,
    /// What it leaves, mode by mode, behind the drive if one is given.
    pub modes: Vec<OfMode>,
    /// The same without a drive.
    pub without_drive: Vec<OfMode>,
    /// How much later than the bare command the shaped one is complete (s).
    pub delay: f64,
    /// What becomes of the ramps, behind an acceleration limit.
    pub ramps: Option<Ramps>,
    /// The least and the greatest value of a shaped unit step.
    pub step: RangeInclusive<f64>,
    /// Σ|Aᵢ|: how far the shaped command may exceed the range of any command, as a multiple of it.
    pub gain: f64,
}

/// What a shaper leaves of a mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OfMode {
    /// V at the mode's frequency.
    pub residual: f64,
    /// The highest V over its range.
    pub worst: Sensitivity,
    /// Insensitivity at the request's level. A hump that rises above the level by no more than a hundredth of it, as a damped
    /// EI's does, does not end the range.
    pub insensitivity: f64,
}

/// Whether a kind works with the vibration limit: the names of those that do say so.
pub fn needs_vibration_limit(kind: Kind) -> bool {
    kind.name().contains("EI") || needs_insensitivity(kind)
}

/// Whether a kind is designed for a range of frequencies.
pub fn needs_insensitivity(kind: Kind) -> bool {
    kind.name().contains("SI")
}

/// Whether a kind is designed for an acceleration limit.
pub fn needs_acceleration_limit(kind: Kind) -> bool {
    kind.name().starts_with("AL")
}

impl Candidate {
    pub(super) fn new(request: &Request, kind: Kind) -> Self {
        let both = request.specification(kind, true);
        let (specification, design) = match both.design() {
            Err(SpecificationError::UnusedMode { .. }) => {
                let first = request.specification(kind, false);
                (first, first.design())
            }
            design => (both, design),
        };
        let design = match kind {
            _ if needs_acceleration_limit(kind) && !request.has_acceleration_limit() => {
                Err(Refusal::NoAccelerationLimit)
            }
            Kind::UMZVc if !request.has_time_constants() => Err(Refusal::NoTimeConstants),
            _ => design.map_err(Refusal::from),
        };
        Self { kind, specification, result: design.map(|design| Figures::new(request, design)) }
    }

    /// The kind's name, with what tells it from others of the kind.
    pub fn name(&self) -> String {
        let Specification { base_kinds: [first, second], solution, .. } = self.specification;
        match self.kind {
            Kind::Convolved => format!("{first}*{second}"),
            Kind::MinimumImpulse if solution != 1 => format!("{} {solution}", self.kind),
            kind => kind.to_string(),
        }
    }

    /// Its numbers, if there is such a shaper.
    pub fn figures(&self) -> Option<&Figures> {
        self.result.as_ref().ok()
    }
}

impl Figures {
    fn new(request: &Request, design: Design) -> Self {
        let shaper = design.shaper();
        let without_drive: Vec<OfMode> =
            request.modes.iter().map(|mode| OfMode::new(shaper, mode, request.level)).collect();
        let (modes, delay, ramps) = match request.drive {
            Some(drive) => {
                let modes = request.modes.iter().map(|mode| drive.of_mode(&design, request, mode)).collect();
                (modes, drive.delay(&design), drive.ramps(shaper))
            }
            None => (without_drive.clone(), design.duration(), None),
        };
        let sums = shaper.impulses().iter().scan(0.0, |sum, impulse| {
            *sum += impulse.amplitude;
            Some(*sum)
        });
        let (least, greatest) = sums.fold((0.0, 0.0_f64), |(least, greatest), sum| (sum.min(least), sum.max(greatest)));
        let gain = shaper.impulses().iter().map(|impulse| impulse.amplitude.abs()).sum();
        Self { modes, without_drive, delay, ramps, step: least..=greatest, gain, design }
    }

    /// The highest V over the ranges of all modes.
    pub fn worst(&self) -> f64 {
        self.modes.iter().map(|mode| mode.worst.vibration).fold(0.0, f64::max)
    }

    /// Whether a drive is so slow that it makes the same of the shaped command as of the bare one.
    pub fn is_idle(&self) -> bool {
        self.delay < 1e-9 * self.design.duration()
    }

    /// Whether the shaped command can leave the range of the command.
    pub fn exceeds_command(&self) -> bool {
        !self.design.shaper().is_positive()
    }
}

impl OfMode {
    fn new(shaper: &Shaper, UncertainMode { mode, range }: &UncertainMode, level: f64) -> Self {
        Self {
            residual: residual_vibration(shaper, mode.frequency(), mode.damping_ratio()),
            worst: highest_vibration(shaper, mode.damping_ratio(), range.clone()),
            insensitivity: match [level, 1.01 * level].map(|level| insensitivity(shaper, *mode, level)) {
                [exact, wide] if wide > 1.1 * exact => width(mode.frequency(), level, |frequency| {
                    residual_vibration(shaper, frequency, mode.damping_ratio())
                }),
                [exact, _] => exact,
            },
        }
    }
}
