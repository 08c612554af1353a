//! What keeps a crane safe: limits of its axes, stops, interlocks, and the detection of faulty sensors.
//!
//! A [`Supervisor`] stands between whatever commands the axes of a crane and their drives. At each sample it takes commands
//! and measurements and gives out the velocities that are safe; [`Braking`] says how fast an axis may be where its room is
//! short, [`Sight`] what is known of a position whose sensor fails.
//!
//! ```
//! use swayless_supervision::{AXES, Limits, Observation, Settings, State, Supervisor, Times};
//!
//! let axis = Limits { position_min: 0.0, position_max: 10.0, velocity: 0.5, deceleration: 0.25 };
//! let settings = Settings { axes: [axis; AXES], ..Settings::default() };
//! let times = Times { now: 0.0, interval: 0.02 };
//! let mut supervisor = Supervisor::default();
//! let asked = Observation { command: [1.0, 0.2, 0.0, 0.0], position: [5.0; AXES], ..Observation::default() };
//! supervisor.sample(times, &settings, &asked);
//! assert_eq!((supervisor.velocities(), supervisor.state()), ([0.5, 0.2, 0.0, 0.0], State::Limited));
//! ```
//!
//! Units are those of the axis, and seconds. Nothing here allocates.

mod braking;
mod fault;
mod limits;
mod settings;
mod sight;
mod supervisor;

pub use braking::Braking;
pub use fault::{Fault, Finding};
pub use limits::Limits;
pub use settings::{AXES, Observation, Settings, State, Times};
pub use sight::{Reading, Sight, Tolerances, UNPHYSICAL};
pub use supervisor::Supervisor;
