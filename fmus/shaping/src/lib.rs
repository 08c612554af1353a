//! Design and analysis of input shapers.
//!
//! An input shaper is a train of impulses. Convolved with a command, it leaves a lightly damped mode without the residual
//! vibration that the bare command would have excited. [`Specification`] says what is wanted and designs trains of every [`Kind`];
//! [`design`] is the short way to those for which a [`Mode`] says enough;
//! [`residual_vibration`], [`sensitivity_curve`], [`highest_vibration`] and [`insensitivity`] say how good it is when the mode is not quite what
//! was designed for; [`Trains`] shapes a command that changes at any time, with a [`Design`] that may change too.
//!
//! ```
//! use swayless_shaping::{Kind, Mode, design, insensitivity, residual_vibration};
//!
//! let load = Mode::new((9.81_f64 / 10.0).sqrt(), 0.01)?; // a load on 10 m of cable
//! let shaper = design(Kind::ZVD, load, 0.0)?;
//! assert!(residual_vibration(&shaper, load.frequency(), load.damping_ratio()) < 1e-15);
//! assert!(insensitivity(&shaper, load, 0.05) > 0.28); // ±14 % of frequency for 5 % of vibration
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Units are SI: seconds, rad/s. Amplitudes are shares of the command and sum to 1. Equation numbers are those of
//! J. Danielson, *Mobile Boom Cranes and Advanced Input Shaping Control*, Georgia Institute of Technology, 2008.
//! [`specified_insensitivity`] gives the shortest shaper for a whole range of frequencies, [`compensated`] the pair of trains for
//! a drive that accelerates and brakes with unequal time constants, and [`limited`] and [`limited_insensitivity`] trains for a drive with an acceleration limit.
//! [`predict`] says what remains behind a drive that a shaper was not designed for, [`ramped_vibration`] what an acceleration limit
//! does to it. For two modes, [`convolve`] puts a shaper for each in series, and [`minimum_impulse`] lists the trains of three
//! impulses that do with less.
//! Nothing in a [`design`] allocates: it may be renewed inside a simulation step.

mod analysis;
mod binomial;
mod compensated;
mod continuation;
mod convolution;
mod degradation;
mod design;
mod designed;
mod differences;
mod ei;
mod error;
mod even;
mod humps;
mod insensitivity;
mod limited;
mod minimum_impulse;
mod mode;
mod order;
mod pendulum;
mod prediction;
mod shaper;
mod specification;
mod specified;
mod train;
mod umzv;

pub use analysis::{Sensitivity, highest_vibration, residual_vibration, sensitivity_curve};
pub use compensated::{
    Compensated, CompensatedError, CompensatedForm, PulseLength, RampsComplete, TimeConstant, compensated,
    compensation_exists, pulse_length,
};
pub use convolution::convolve;
pub use degradation::{NotInterchangeable, command_duration, interchangeable, longest_ramp, ramped_vibration};
pub use design::{Kind, design};
pub use designed::{Design, Designer};
pub use error::{DesignError, ModeError, ShaperError};
pub use insensitivity::{Band, band, insensitivity};
pub use limited::{Limited, LimitedError, Ramp, limited, limited_insensitivity};
pub use minimum_impulse::{MinimumImpulse, MinimumImpulseError, minimum_impulse, minimum_impulse_solution};
pub use mode::Mode;
pub use pendulum::{double_pendulum, pendulum};
pub use prediction::{Drive, DriveError, Prediction, predict, residual_amplitude};
pub use shaper::{Impulse, MAX_IMPULSES, Shaper};
pub use specification::{Quantity, Specification, SpecificationError};
pub use specified::{SpecifiedError, specified_insensitivity, specified_insensitivity_of};
pub use train::{Pending, Trains};
