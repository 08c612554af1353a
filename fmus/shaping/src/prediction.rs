//! What a drive makes of a shaped step: the vibration that remains behind a drive that is not ideal.
//!
//! A load answers the velocity v of what carries it with ÿ + 2ζωẏ + ω²y = −v̇. When v is at rest it swings with the amplitude
//! |∫v̇ e^{σ(t−t_e)}dt|/ω_d, σ = ζω + jω_d, as seen from the time t_e. For each drive that integral is a sum over stretches of time
//! that end at changes of the command and where the drive itself changes its ways; nothing is stepped.

use std::error::Error;
use std::fmt;

use nalgebra::Complex;

use crate::even::Even;
use crate::{Mode, ModeError, Shaper};

/// How a drive follows its command u with the velocity v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive {
    /// At once.
    Ideal,
    /// With at most so much acceleration, in m/s² (5.1).
    RateLimit {
        /// The limit a.
        acceleration: f64,
    },
    /// v̇ = (u − v)/τ, with one τ while |v| grows and another while it falls, in seconds (5.2). A reversal brakes to standstill first.
    FirstOrder {
        /// τ_a.
        acceleration_time_constant: f64,
        /// τ_b.
        braking_time_constant: f64,
    },
    /// v̈ + 2ζ_Hω_H v̇ + ω_H² v = ω_H² u (6.1).
    SecondOrder {
        /// ω_H in rad/s.
        frequency: f64,
        /// ζ_H.
        damping_ratio: f64,
    },
}

/// Why there is no such drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DriveError {
    /// The acceleration limit is not greater than 0.
    Acceleration {
        /// What was given, in m/s².
        value: f64,
    },
    /// A time constant is negative or not finite.
    TimeConstant {
        /// What was given, in seconds.
        value: f64,
    },
    /// The frequency or damping ratio of the drive is none.
    SecondOrder(ModeError),
}

impl fmt::Display for DriveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Acceleration { value } => {
                write!(f, "the drive's acceleration limit is {value} m/s²; it must be greater than 0")
            }
            Self::TimeConstant { value } => {
                write!(f, "a time constant of the drive is {value} s; it must be at least 0 and finite")
            }
            Self::SecondOrder(error) => write!(f, "of the drive taken as a mode: {error}"),
        }
    }
}

impl Error for DriveError {}

/// What remains of the vibration behind a drive, and what the bare command would have left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prediction {
    /// Amplitude of the load's displacement, in m for a step in m/s, behind the shaper and the drive.
    pub shaped: f64,
    /// The same for the bare step through the same drive.
    pub bare: f64,
}

impl Prediction {
    /// `shaped` as a share of `bare`; infinite where the bare step leaves nothing.
    #[must_use]
    pub fn ratio(self) -> f64 {
        self.shaped / self.bare
    }
}

/// Predicts what remains after a velocity step in m/s from standstill, shaped and bare, each seen from its own end.
///
/// # Errors
/// [`DriveError`] for a drive that is none.
pub fn predict(shaper: &Shaper, mode: Mode, drive: Drive, step: f64) -> Result<Prediction, DriveError> {
    let after = |shaper: &Shaper| {
        residual_amplitude(
            shaper.impulses().iter().map(|impulse| (impulse.time, step * impulse.amplitude)),
            mode,
            drive,
            0.0,
        )
    };
    Ok(Prediction { shaped: after(shaper)?, bare: after(&Shaper::unshaped())? })
}

/// The amplitude (in m) that remains when a drive at a steady velocity has followed changes of its command, given as (time in s, by
/// how much in m/s) in ascending order of time. It is seen from the end: that of the last ramp behind an acceleration limit, else
/// the last change, what the drive's own decay still excites included.
///
/// # Errors
/// [`DriveError`] for a drive that is none.
pub fn residual_amplitude(
    changes: impl IntoIterator<Item = (f64, f64)>,
    mode: Mode,
    drive: Drive,
    velocity: f64,
) -> Result<f64, DriveError> {
    drive.check()?;
    let sigma = Complex::new(mode.damping_ratio() * mode.frequency(), mode.damped_frequency());
    let mut answer = Answer { sigma, sum: Complex::ZERO, end: 0.0 };
    let mut stretch = Stretch { velocity, command: velocity, start: f64::NEG_INFINITY };
    for (time, change) in changes {
        if stretch.start.is_finite() {
            stretch.run(&mut answer, drive, time);
        }
        answer.carry_to(time);
        stretch.start = time;
        stretch.command += change;
    }
    if stretch.start.is_finite() {
        let last = answer.end;
        stretch.run(&mut answer, drive, f64::INFINITY);
        if !matches!(drive, Drive::RateLimit { .. }) {
            answer.carry_to(last);
        }
    }
    let gain = match drive {
        Drive::SecondOrder { frequency, damping_ratio } => {
            let square = frequency * frequency;
            square / (sigma * sigma - sigma * (2.0 * damping_ratio * frequency) + square).norm()
        }
        _ => 1.0,
    };
    Ok(gain * answer.sum.norm() / mode.damped_frequency())
}

impl Drive {
    fn check(self) -> Result<(), DriveError> {
        match self {
            Self::Ideal => Ok(()),
            Self::RateLimit { acceleration } if acceleration > 0.0 => Ok(()),
            Self::RateLimit { acceleration } => Err(DriveError::Acceleration { value: acceleration }),
            Self::FirstOrder { acceleration_time_constant, braking_time_constant } => {
                let mut constants = [acceleration_time_constant, braking_time_constant].into_iter();
                let bad = constants.find(|value| !(*value >= 0.0 && value.is_finite()));
                bad.map_or(Ok(()), |value| Err(DriveError::TimeConstant { value }))
            }
            Self::SecondOrder { frequency, damping_ratio } => {
                // an overdamped drive is a drive, too
                let damping_ratio = if damping_ratio >= 1.0 { 0.0 } else { damping_ratio };
                Mode::new(frequency, damping_ratio).map(|_| ()).map_err(DriveError::SecondOrder)
            }
        }
    }
}

/// The integral, seen from a time `end`.
struct Answer {
    sigma: Complex<f64>,
    sum: Complex<f64>,
    end: f64,
}

impl Answer {
    fn carry_to(&mut self, time: f64) {
        if self.sum != Complex::ZERO {
            self.sum *= (self.sigma * (self.end - time)).exp();
        }
        self.end = time;
    }

    /// A jump of the velocity now.
    fn jump(&mut self, by: f64) {
        self.sum += by;
    }

    /// A velocity that changes at a constant rate from now on for a while.
    fn ramp(&mut self, by: f64, time: f64) {
        self.carry_to(self.end + time);
        self.sum += mean_of_ramp(-self.sigma * time) * by;
    }

    /// A velocity that decays towards a value `by` away, from now on for a while (which may be for ever).
    fn decay(&mut self, by: f64, constant: f64, time: f64) {
        // ∫₀ᵈ e^{σt−t/τ}dt/τ = (1 − e^{σd−d/τ})/(1 − τσ)
        let whole = Complex::from(by) / (Complex::<f64>::ONE - self.sigma * constant);
        self.sum += whole;
        if time.is_finite() {
            self.carry_to(self.end + time);
            self.sum -= whole * (-time / constant).exp();
        }
    }
}

/// ∫₀¹ e^{zx}dx = (e^z − 1)/z = e^{z/2} sinh(z/2)/(z/2), regular at 0.
pub(crate) fn mean_of_ramp(z: Complex<f64>) -> Complex<f64> {
    let half = z * 0.5;
    half.exp() * Even::at(half * half).sinhc
}

/// The drive from one change of the command to the next.
struct Stretch {
    velocity: f64,
    command: f64,
    start: f64,
}

impl Stretch {
    fn run(&mut self, answer: &mut Answer, drive: Drive, until: f64) {
        match drive {
            Drive::Ideal | Drive::SecondOrder { .. } => {
                answer.jump(self.command - self.velocity);
                self.velocity = self.command;
            }
            Drive::RateLimit { acceleration } => {
                let missing = self.command - self.velocity;
                let time = (missing.abs() / acceleration).min(until - self.start);
                let by =
                    if time < missing.abs() / acceleration { missing.signum() * acceleration * time } else { missing };
                answer.ramp(by, time);
                self.velocity = if by == missing { self.command } else { self.velocity + by };
            }
            Drive::FirstOrder { acceleration_time_constant, braking_time_constant } => {
                if self.velocity * self.command < 0.0 && braking_time_constant == 0.0 {
                    answer.jump(-self.velocity);
                    self.velocity = 0.0;
                } else if self.velocity * self.command < 0.0 {
                    let whole = braking_time_constant * (self.velocity / self.command).abs().ln_1p();
                    let time = whole.min(until - self.start);
                    self.relax(answer, braking_time_constant, time);
                    if time < whole {
                        return;
                    }
                    self.velocity = 0.0;
                }
                let grows = self.command.abs() >= self.velocity.abs();
                let constant = if grows { acceleration_time_constant } else { braking_time_constant };
                self.relax(answer, constant, until - self.start);
            }
        }
    }

    fn relax(&mut self, answer: &mut Answer, constant: f64, time: f64) {
        let missing = self.command - self.velocity;
        if constant > 0.0 {
            answer.decay(missing, constant, time);
            self.velocity = self.command - missing * (-time / constant).exp();
        } else if time > 0.0 {
            answer.jump(missing);
            self.velocity = self.command;
        }
        self.start += time;
    }
}
