//! The kinds of shaper, and the designs of those that need no more than a mode.

use std::fmt;

use crate::{DesignError, Mode, Shaper, binomial, ei, humps, umzv};

/// The kinds of shaper. [`Specification`](crate::Specification) designs any of them, [`design`] those for which a mode says enough.
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
    /// Zero vibration and three derivatives, 2T_d long.
    ZVDDD,
    /// Extra-insensitive, T_d long: allows a little vibration at the design frequency to gain width around it.
    EI,
    /// Two-hump extra-insensitive, about 3T/2 long: no vibration at the design frequency, humps of the limit on either side.
    TwoHumpEI,
    /// Three-hump extra-insensitive, about 2T long: a hump of the limit at the design frequency and one on either side.
    ThreeHumpEI,
    /// Specified insensitivity: the shortest positive shaper that keeps V below a limit over a range of frequencies.
    SI,
    /// Unity-magnitude zero vibration (1.3), impulses +1, −1, +1, about T/3 long: fast, but may exceed the command's range.
    UMZV,
    /// Unity-magnitude zero vibration and derivative, impulses +1, −1, +1, −1, +1, about 0.73T long.
    UMZVD,
    /// Unity-magnitude extra-insensitive: five impulses like UMZVD's, with a hump of the limit at the design frequency.
    UMEI,
    /// UMZV for a drive that accelerates and brakes with different time constants: a train of +1, −1, +1 for each.
    UMZVc,
    /// ZVD for a drive with an acceleration limit: no vibration and no slope behind the ramps that it makes of a step.
    ALZVD,
    /// EI for a drive with an acceleration limit.
    ALEI,
    /// SI for a drive with an acceleration limit: the shortest command that keeps V below a limit over a range of frequencies.
    ALSI,
    /// A shaper of its own for each of two modes, in series.
    Convolved,
    /// At most three impulses, negative ones among them, that leave nothing of either of two modes.
    MinimumImpulse,
    /// Specified insensitivity around each of two modes: the shortest positive shaper that keeps V below a limit over both ranges.
    MultiModeSI,
}

impl Kind {
    /// All kinds, in the order of their declaration.
    pub const ALL: [Self; 19] = [
        Self::None,
        Self::ZV,
        Self::ZVD,
        Self::ZVDD,
        Self::ZVDDD,
        Self::EI,
        Self::TwoHumpEI,
        Self::ThreeHumpEI,
        Self::SI,
        Self::UMZV,
        Self::UMZVD,
        Self::UMEI,
        Self::UMZVc,
        Self::ALZVD,
        Self::ALEI,
        Self::ALSI,
        Self::Convolved,
        Self::MinimumImpulse,
        Self::MultiModeSI,
    ];

    /// The kinds that [`design`] knows: a mode, and for some a vibration limit, says all about them.
    pub const OF_A_MODE: [Self; 11] = [
        Self::None,
        Self::ZV,
        Self::ZVD,
        Self::ZVDD,
        Self::ZVDDD,
        Self::EI,
        Self::TwoHumpEI,
        Self::ThreeHumpEI,
        Self::UMZV,
        Self::UMZVD,
        Self::UMEI,
    ];

    /// The name, as in the literature.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "None",
            Self::ZV => "ZV",
            Self::ZVD => "ZVD",
            Self::ZVDD => "ZVDD",
            Self::ZVDDD => "ZVDDD",
            Self::EI => "EI",
            Self::TwoHumpEI => "TwoHumpEI",
            Self::ThreeHumpEI => "ThreeHumpEI",
            Self::SI => "SI",
            Self::UMZV => "UMZV",
            Self::UMZVD => "UMZVD",
            Self::UMEI => "UMEI",
            Self::UMZVc => "UMZVc",
            Self::ALZVD => "ALZVD",
            Self::ALEI => "ALEI",
            Self::ALSI => "ALSI",
            Self::Convolved => "Convolved",
            Self::MinimumImpulse => "MinimumImpulse",
            Self::MultiModeSI => "MultiModeSI",
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// Designs the shaper of one of the kinds [`Kind::OF_A_MODE`]. Does not allocate.
///
/// `vibration_limit` is the residual vibration V, as a share of the unshaped one, that `EI`, `TwoHumpEI`, `ThreeHumpEI` and `UMEI`
/// work with (usually 0.05); the other kinds do not look at it. All of these but `TwoHumpEI` have it at the design frequency.
///
/// # Errors
/// [`DesignError::Kind`] for the other kinds; [`DesignError::VibrationLimit`] for such a kind's limit outside 0 ≤ V < 1; [`DesignError::NoSolution`] when damping, or damping
/// and limit, are so large that the kind's equations have no solution, with positive impulses where it has them; it names a
/// damping ratio that has one. For V = 0.05, `EI` has solutions up to ζ = 0.6, `TwoHumpEI` 0.36, `ThreeHumpEI` 0.26, `UMEI` 0.65,
/// and `UMZVD` has them up to 0.85; for V = 0.1, `TwoHumpEI` up to 0.28 and `ThreeHumpEI` 0.19.
pub fn design(kind: Kind, mode: Mode, vibration_limit: f64) -> Result<Shaper, DesignError> {
    match kind {
        Kind::None => Ok(Shaper::unshaped()),
        Kind::ZV => Ok(binomial::design::<2>(mode)),
        Kind::ZVD => Ok(binomial::design::<3>(mode)),
        Kind::ZVDD => Ok(binomial::design::<4>(mode)),
        Kind::ZVDDD => Ok(binomial::design::<5>(mode)),
        Kind::EI => ei::design(mode, vibration_limit),
        Kind::TwoHumpEI => humps::two_hump(mode, vibration_limit),
        Kind::ThreeHumpEI => humps::three_hump(mode, vibration_limit),
        Kind::SI
        | Kind::UMZVc
        | Kind::ALZVD
        | Kind::ALEI
        | Kind::ALSI
        | Kind::Convolved
        | Kind::MinimumImpulse
        | Kind::MultiModeSI => Err(DesignError::Kind { kind }),
        Kind::UMZV => umzv::design(mode),
        Kind::UMZVD => humps::unity(kind, mode, 0.0),
        Kind::UMEI => humps::unity(kind, mode, vibration_limit),
    }
}
