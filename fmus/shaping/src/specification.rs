//! The one door to every kind of shaper: what is wanted, and the design that answers it.

use std::error::Error;
use std::fmt;

use crate::{
    Band, CompensatedError, CompensatedForm, Design, DesignError, Kind, LimitedError, MinimumImpulseError, Mode, Ramp,
    ShaperError, SpecifiedError, TimeConstant, compensated, convolve, design, limited, limited_insensitivity,
    minimum_impulse_solution, specified_insensitivity, specified_insensitivity_of,
};

/// All that a design can depend on. Each kind looks at what it needs and at nothing else.
///
/// ```
/// use swayless_shaping::{Kind, Mode, Specification};
///
/// let load = Mode::new((9.81_f64 / 10.0).sqrt(), 0.0)?; // a load on 10 m of cable
/// let wanted = Specification { insensitivity: 0.4, ..Specification::new(Kind::SI, load) };
/// let design = wanted.design()?;
/// assert!(design.duration() < 1.01 * load.period()); // ±20 % of frequency for 5 % of vibration
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Specification {
    /// The kind of shaper.
    pub kind: Kind,
    /// The modes to be shaped for. The kinds for one mode refuse a second; `None` looks at neither.
    pub modes: [Option<Mode>; 2],
    /// Residual vibration V that is allowed, as a share of the unshaped one.
    pub vibration_limit: f64,
    /// Insensitivity I of `SI`, and of `MultiModeSI` for both modes: the full width of the range of frequencies in which V stays below
    /// the limit, over the mode's frequency.
    pub insensitivity: f64,
    /// Acceleration limit of the drive of `ALZVD`, `ALEI` and `ALSI`, a; infinite for none.
    pub acceleration_limit: f64,
    /// The change of the command that `ALZVD`, `ALEI` and `ALSI` are designed for, v_f.
    pub velocity_limit: f64,
    /// Time constant τ_a with which the drive of `UMZVc` speeds up, in seconds.
    pub acceleration_time_constant: f64,
    /// Time constant τ_b with which the drive of `UMZVc` slows down, in seconds.
    pub braking_time_constant: f64,
    /// The kinds that `Convolved` is made of, one for each mode: kinds of one mode.
    pub base_kinds: [Kind; 2],
    /// Which of the `MinimumImpulse` solutions, from 1, the shortest.
    pub solution: usize,
}

impl Specification {
    /// A kind for one mode, with 5 % of vibration allowed, for SI within ±20 % of the frequency, for a drive without lag and limit; if
    /// a second mode is added, ZV for each, or the shortest solution.
    #[must_use]
    pub fn new(kind: Kind, mode: Mode) -> Self {
        Self {
            kind,
            modes: [Some(mode), None],
            vibration_limit: 0.05,
            insensitivity: 0.4,
            acceleration_limit: f64::INFINITY,
            velocity_limit: 1.0,
            acceleration_time_constant: 0.0,
            braking_time_constant: 0.0,
            base_kinds: [Kind::ZV; 2],
            solution: 1,
        }
    }

    /// Designs it. Kinds with SI in their name allocate and take some milliseconds or, for two modes far apart, more, all others neither; a
    /// [`Designer`](crate::Designer) spares that where only the frequency has changed.
    ///
    /// # Errors
    /// [`SpecificationError`], whose [`quantity`](SpecificationError::quantity) says what to change.
    pub fn design(&self) -> Result<Design, SpecificationError> {
        match self.at_unit_frequency() {
            Some((unit, frequency)) => Ok(unit.design_directly()?.at_frequency(frequency)),
            None => self.design_directly(),
        }
    }

    pub(crate) fn design_directly(&self) -> Result<Design, SpecificationError> {
        match self.kind {
            Kind::None => Ok(Design::unshaped()),
            Kind::SI => {
                let mode = self.only_mode()?;
                let band = Band::around(mode.frequency(), self.insensitivity)?;
                Ok(specified_insensitivity(band, mode.damping_ratio(), self.vibration_limit)?.into())
            }
            Kind::UMZVc => {
                let (tau_a, tau_b) = (self.acceleration_time_constant, self.braking_time_constant);
                let both = compensated(self.only_mode()?, tau_a, tau_b, CompensatedForm::ExactRamp)?;
                Ok(Design::of_both(both.accelerating, both.braking))
            }
            Kind::ALZVD => self.limited(0.0),
            Kind::ALEI => self.limited(self.vibration_limit),
            Kind::ALSI => {
                let (mode, ramp) = (self.only_mode()?, Ramp::new(self.velocity_limit, self.acceleration_limit)?);
                let band = Band::around(mode.frequency(), self.insensitivity)?;
                let limited = limited_insensitivity(band, mode.damping_ratio(), ramp, self.vibration_limit)?;
                Ok(Design::alone(limited.shaper().clone()))
            }
            Kind::Convolved => {
                let [first, second] = [self.base(0)?, self.base(1)?];
                Ok(convolve(first.shaper(), second.shaper()).map_err(SpecificationError::Convolved)?.into())
            }
            Kind::MultiModeSI => {
                let range = |mode: Mode| -> Result<_, SpecifiedError> {
                    Ok((Band::around(mode.frequency(), self.insensitivity)?, mode.damping_ratio()))
                };
                let ranges = [range(self.mode(0)?)?, range(self.mode(1)?)?];
                Ok(specified_insensitivity_of(&ranges, self.vibration_limit)?.into())
            }
            Kind::MinimumImpulse => Ok(minimum_impulse_solution([self.mode(0)?, self.mode(1)?], self.solution)?.into()),
            _ => Ok(design(self.kind, self.only_mode()?, self.vibration_limit)?.into()),
        }
    }

    /// For kinds that are dear to design: the same around a frequency of 1 rad/s, and the frequency that its times are to be
    /// divided by. So all frequencies share one design.
    pub(crate) fn at_unit_frequency(&self) -> Option<(Self, f64)> {
        match (self.kind, self.modes) {
            (Kind::SI, [Some(mode), None]) => {
                Some((Self { modes: [Some(mode.at_unit_frequency()), None], ..*self }, mode.frequency()))
            }
            // another frequency would be another ratio to the ramp
            (Kind::ALSI, _) => Some((*self, 1.0)),
            (Kind::MultiModeSI, [Some(first), Some(second)]) => {
                let modes = [first, second].map(|mode| Some(mode.in_units_of(first.frequency())));
                Some((Self { modes, ..*self }, first.frequency()))
            }
            _ => None,
        }
    }

    fn limited(&self, vibration_limit: f64) -> Result<Design, SpecificationError> {
        let ramp = Ramp::new(self.velocity_limit, self.acceleration_limit)?;
        Ok(Design::alone(limited(self.only_mode()?, ramp, vibration_limit)?.shaper().clone()))
    }

    /// The design of one mode that `Convolved` is made of.
    fn base(&self, index: usize) -> Result<Design, SpecificationError> {
        let (mode, kind) = (self.mode(index)?, self.base_kinds[index]);
        if kind != Kind::SI && !Kind::OF_A_MODE.contains(&kind) {
            return Err(SpecificationError::BaseKind { kind, index });
        }
        let base = Self { kind, modes: [Some(mode), None], ..*self };
        base.design().map_err(|error| match error {
            SpecificationError::Design { error, .. } => SpecificationError::Design { error, mode: index },
            SpecificationError::Specified { error, .. } => SpecificationError::Specified { error, mode: index },
            error => error,
        })
    }

    fn mode(&self, index: usize) -> Result<Mode, SpecificationError> {
        self.modes[index].ok_or(SpecificationError::MissingMode { kind: self.kind, index })
    }

    fn only_mode(&self) -> Result<Mode, SpecificationError> {
        match self.modes[1] {
            Some(_) => Err(SpecificationError::UnusedMode { kind: self.kind }),
            None => self.mode(0),
        }
    }
}

/// What a [`SpecificationError`] is about; modes are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// [`Specification::kind`].
    Kind,
    /// The frequency of a mode of [`Specification::modes`].
    Frequency(usize),
    /// The damping ratio of a mode of [`Specification::modes`].
    DampingRatio(usize),
    /// [`Specification::vibration_limit`].
    VibrationLimit,
    /// [`Specification::insensitivity`].
    Insensitivity,
    /// [`Specification::acceleration_limit`].
    AccelerationLimit,
    /// [`Specification::velocity_limit`].
    VelocityLimit,
    /// [`Specification::acceleration_time_constant`].
    AccelerationTimeConstant,
    /// [`Specification::braking_time_constant`].
    BrakingTimeConstant,
    /// One of [`Specification::base_kinds`].
    BaseKind(usize),
    /// [`Specification::solution`].
    Solution,
}

/// Why a [`Specification`] has no design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpecificationError {
    /// The kind needs a mode that is not given.
    MissingMode {
        /// The kind asked for.
        kind: Kind,
        /// Which mode, from 0.
        index: usize,
    },
    /// A second mode is given to a kind that shapes one mode only.
    UnusedMode {
        /// The kind asked for.
        kind: Kind,
    },
    /// `Convolved` cannot be made of that kind.
    BaseKind {
        /// The kind asked for.
        kind: Kind,
        /// For which mode, from 0.
        index: usize,
    },
    /// The equations of the kind have no solution.
    Design {
        /// Why.
        error: DesignError,
        /// Of which mode, from 0.
        mode: usize,
    },
    /// There is no SI shaper.
    Specified {
        /// Why.
        error: SpecifiedError,
        /// Of which mode, from 0.
        mode: usize,
    },
    /// There is no such shaper for the acceleration limit.
    Limited(LimitedError),
    /// There is no UMZVc shaper.
    Compensated(CompensatedError),
    /// The two shapers have no train in series.
    Convolved(ShaperError),
    /// There is no such minimum-impulse shaper.
    MinimumImpulse(MinimumImpulseError),
}

impl SpecificationError {
    /// What to change.
    #[must_use]
    pub fn quantity(&self) -> Quantity {
        match self {
            Self::MissingMode { index, .. } => Quantity::Frequency(*index),
            Self::UnusedMode { .. } => Quantity::Frequency(1),
            Self::BaseKind { index, .. } => Quantity::BaseKind(*index),
            Self::Design { error, mode } => match error {
                DesignError::Kind { .. } => Quantity::Kind,
                DesignError::VibrationLimit { .. } => Quantity::VibrationLimit,
                DesignError::NoSolution { .. } => Quantity::DampingRatio(*mode),
            },
            Self::Limited(error) => match error {
                LimitedError::Range(error) => Self::from(*error).quantity(),
                LimitedError::Acceleration { .. } => Quantity::AccelerationLimit,
                LimitedError::Speed { .. } | LimitedError::TooSlow { .. } | LimitedError::NoPulses { .. } => {
                    Quantity::VelocityLimit
                }
                LimitedError::VibrationLimit { .. } | LimitedError::Damping { .. } => Quantity::VibrationLimit,
            },
            Self::Compensated(error) => match error {
                CompensatedError::Unity(_) => Quantity::DampingRatio(0),
                CompensatedError::TimeConstant { which, .. } | CompensatedError::Unequal { which, .. } => match which {
                    TimeConstant::Acceleration => Quantity::AccelerationTimeConstant,
                    TimeConstant::Braking => Quantity::BrakingTimeConstant,
                },
                // it is the longer one that asks too much
                CompensatedError::NotFound {
                    acceleration_time_constant: tau_a, braking_time_constant: tau_b, ..
                } => {
                    if tau_a > tau_b {
                        Quantity::AccelerationTimeConstant
                    } else {
                        Quantity::BrakingTimeConstant
                    }
                }
            },
            Self::Convolved(_) => Quantity::BaseKind(1),
            Self::MinimumImpulse(error) => match error {
                MinimumImpulseError::Apart { .. } => Quantity::Frequency(1),
                MinimumImpulseError::Solution { .. } => Quantity::Solution,
            },
            Self::Specified { error, mode } => match error {
                SpecifiedError::Mode(_) | SpecifiedError::Waiting => Quantity::DampingRatio(*mode),
                SpecifiedError::VibrationLimit { .. } => Quantity::VibrationLimit,
                SpecifiedError::NoRange
                | SpecifiedError::Reversed { .. }
                | SpecifiedError::Insensitivity { .. }
                | SpecifiedError::TooLong
                | SpecifiedError::TooManyImpulses { .. }
                | SpecifiedError::TooWide
                | SpecifiedError::NotFound => Quantity::Insensitivity,
                SpecifiedError::Apart { .. } => Quantity::Frequency(1),
            },
        }
    }
}

impl fmt::Display for SpecificationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::MissingMode { kind, index } => write!(f, "{kind} needs the frequency of mode {}", index + 1),
            Self::UnusedMode { kind } => write!(f, "{kind} shapes one mode only; leave the second out"),
            Self::BaseKind { kind, index } => {
                write!(f, "Convolved is made of kinds for one mode, and {kind}, for mode {}, is none", index + 1)
            }
            Self::Design { error, .. } => error.fmt(f),
            Self::Specified { error, .. } => error.fmt(f),
            Self::Limited(error) => error.fmt(f),
            Self::Compensated(error) => error.fmt(f),
            Self::Convolved(error) => write!(f, "{error}; convolve kinds with fewer impulses"),
            Self::MinimumImpulse(error) => error.fmt(f),
        }
    }
}

impl Error for SpecificationError {}

impl From<DesignError> for SpecificationError {
    fn from(error: DesignError) -> Self {
        Self::Design { error, mode: 0 }
    }
}

impl From<SpecifiedError> for SpecificationError {
    fn from(error: SpecifiedError) -> Self {
        Self::Specified { error, mode: 0 }
    }
}

impl From<LimitedError> for SpecificationError {
    fn from(error: LimitedError) -> Self {
        Self::Limited(error)
    }
}

impl From<CompensatedError> for SpecificationError {
    fn from(error: CompensatedError) -> Self {
        Self::Compensated(error)
    }
}

impl From<MinimumImpulseError> for SpecificationError {
    fn from(error: MinimumImpulseError) -> Self {
        Self::MinimumImpulse(error)
    }
}
