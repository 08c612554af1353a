//! The kinds of shaper, and the one door to their designs.

use std::fmt;

use crate::{DesignError, Mode, Shaper, binomial, ei, umzv};

/// The kinds of shaper for one mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// No shaping: one impulse of amplitude 1 at time 0.
    None,
    /// Zero vibration (1.1): the shortest positive shaper, T_d/2 long.
    ZV,
    /// Zero vibration and derivative (1.2), T_d long: V also has zero slope over frequency.
    ZVD,
    /// Zero vibration and two derivatives, 3T_d/2 long.
    ZVDD,
    /// Extra-insensitive, T_d long: allows a little vibration at the design frequency to gain width around it.
    EI,
    /// Unity-magnitude zero vibration (1.3), impulses +1, −1, +1, about T/3 long: fast, but may exceed the command's range.
    UMZV,
}

impl Kind {
    /// All kinds, in the order of their declaration.
    pub const ALL: [Self; 6] = [Self::None, Self::ZV, Self::ZVD, Self::ZVDD, Self::EI, Self::UMZV];

    /// The name, as in the literature.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "None",
            Self::ZV => "ZV",
            Self::ZVD => "ZVD",
            Self::ZVDD => "ZVDD",
            Self::EI => "EI",
            Self::UMZV => "UMZV",
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// Designs the shaper of the given kind for one mode. Does not allocate.
///
/// `vibration_limit` is the residual vibration V at the design frequency, as a share of the unshaped one, that `EI` works
/// with (usually 0.05); the other kinds do not look at it.
///
/// # Errors
/// [`DesignError::VibrationLimit`] for an `EI` limit outside 0 ≤ V < 1; [`DesignError::NoSolution`] when damping and limit are
/// both so large that `EI`'s equations have no solution with positive impulses (none is missing for ζ ≤ 0.3 with V ≤ 0.1).
pub fn design(kind: Kind, mode: Mode, vibration_limit: f64) -> Result<Shaper, DesignError> {
    match kind {
        Kind::None => Ok(Shaper::unshaped()),
        Kind::ZV => Ok(binomial::design::<2>(mode)),
        Kind::ZVD => Ok(binomial::design::<3>(mode)),
        Kind::ZVDD => Ok(binomial::design::<4>(mode)),
        Kind::EI => ei::design(mode, vibration_limit),
        Kind::UMZV => umzv::design(mode),
    }
}
