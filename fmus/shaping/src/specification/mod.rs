//! The one door to every kind of shaper: what is wanted, and the design that answers it.

mod error;

pub use error::{Quantity, SpecificationError};

use crate::{
    Band, CompensatedForm, Design, Kind, Mode, Ramp, SpecifiedError, compensated, convolve, design, limited,
    limited_insensitivity, minimum_impulse_solution, specified_insensitivity, specified_insensitivity_of,
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
