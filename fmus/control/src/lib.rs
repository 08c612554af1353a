//! Control theory for cranes: what their controllers are made of.
//!
//! A [`Crane`] is one axis as a controller knows it, a drive and a double pendulum behind it; [`closed_loop`] has its poles
//! with feedback; an [`Observer`] finds out from a late camera how hook and payload swing; [`Limits`] plan moves and
//! [`Shaped`] passes them through a shaper. [`PositionControl`] is all of that together, and [`SwayDamping`] is the plain
//! feedback of a swing angle.
//!
//! ```
//! use swayless_control::{Crane, Drive, Feedback, Pendulum, closed_loop};
//!
//! let pendulum = Pendulum { gravity: 9.81, hoist: 8.0, rigging: 3.0, mass_ratio: 0.5 };
//! let drive = Drive { natural_frequency: 3.7, damping_ratio: 0.75 };
//! let feedback = Feedback { sway_gain: 2.0, ..Feedback::default() };
//! let modes = closed_loop(&Crane { pendulum, drive }, feedback).unwrap().modes()?;
//! assert!((modes[0].unwrap().damping_ratio() - 0.093).abs() < 1e-4);
//! # Ok::<(), swayless_shaping::ModeError>(())
//! ```
//!
//! Units are SI. Equation numbers are those of J. Danielson, *Mobile Boom Cranes and Advanced Input Shaping Control*,
//! Georgia Institute of Technology, 2008. Nothing allocates once a controller is made.

mod crane;
mod drive;
mod observer;
mod pace;
mod pendulum;
mod poles;
mod position;
mod profile;
mod shaped;
mod shapers;
mod sway;

pub use crane::{Crane, State};
pub use drive::{Drive, Motion};
pub use observer::{Observer, Uncertainty};
pub use pace::Pace;
pub use pendulum::{Modes, Pendulum, Swing, Transition};
pub use poles::{ClosedLoop, Feedback, Pole, closed_loop};
pub use position::{Form, Goal, Measured, PositionControl, Settings, Shown};
pub use profile::Limits;
pub use shaped::Shaped;
pub use shapers::zero_vibration;
pub use sway::{Damping, SwayDamping};
