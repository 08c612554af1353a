//! Black-box tests: everything here goes through packaged FMUs, the `swayless` command, or the repository's files.

mod boom_crane;
mod boom_lift;
mod braking_drive;
mod bridge_crane;
mod cartesian_controller;
mod command_source;
mod crane_supervisor;
mod example_cartesian;
mod example_drives;
mod example_luffing;
mod examples;
mod flexible_modes;
mod fuzz;
mod instance;
mod libraries;
mod linearised;
mod loaded_drive;
mod luff_rigging;
mod mistakes;
mod mobile_base;
mod packaged;
mod platforms;
#[cfg(target_os = "linux")]
mod portable;
mod python;
mod range_sensor;
mod record;
mod reference;
mod repository;
mod reproducible;
mod thesis_figures;
mod tower_crane;
mod vector_drive;
mod vertical_pendulum;
mod vision_sensor;
