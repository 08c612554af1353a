//! Axes that do exactly as they are told, under a supervisor.

use swayless_supervision::{AXES, Limits, Observation, Settings, Supervisor, Times, Tolerances};

/// The time from one sample to the next (s).
pub const INTERVAL: f64 = 0.02;

/// Axes of different reach and speed.
pub fn settings() -> Settings {
    let axis = |position_min, position_max, velocity, deceleration| Limits {
        position_min,
        position_max,
        velocity,
        deceleration,
    };
    Settings {
        axes: [
            axis(0.0, 10.0, 0.75, 0.5),
            axis(-1.0, 1.0, 0.3, 2.0),
            axis(-0.5, 2.5, 1.0, 0.13),
            axis(4.0, 4.5, 0.07, 40.0),
        ],
        slow_zone: 0.3,
        within: Tolerances { fault_time: 0.5, jump_time: 0.5, frozen_time: 2.0 },
        ..Settings::default()
    }
}

/// A supervisor with the axes under it.
pub struct Plant {
    pub settings: Settings,
    pub supervisor: Supervisor,
    pub position: [f64; AXES],
    pub samples: u32,
}

impl Plant {
    pub fn new(settings: Settings) -> Self {
        let position = settings.axes.map(|axis| 0.5 * (axis.position_min + axis.position_max));
        Self { settings, supervisor: Supervisor::default(), position, samples: 0 }
    }

    /// Takes a sample with what is seen, the positions apart, and lets the axes go until the next. Returns the velocities
    /// before and after the sample.
    pub fn step(&mut self, seen: Observation) -> [[f64; AXES]; 2] {
        let before = self.supervisor.velocities();
        let times = Times { now: f64::from(self.samples) * INTERVAL, interval: INTERVAL };
        self.supervisor.sample(times, &self.settings, &Observation { position: self.position, ..seen });
        self.samples += 1;
        let after = self.supervisor.velocities();
        for (position, velocity) in self.position.iter_mut().zip(after) {
            *position += velocity * INTERVAL;
        }
        [before, after]
    }

    /// Steps for so long (s) with a command of the first axis.
    pub fn run(&mut self, command: f64, time: f64) {
        for _ in 0..(time / INTERVAL).round() as u32 {
            self.step(asked(command));
        }
    }

    /// The velocity of the first axis.
    pub fn velocity(&self) -> f64 {
        self.supervisor.velocities()[0]
    }
}

/// A command of the first axis, where all is well.
pub fn asked(command: f64) -> Observation {
    Observation { command: [command, 0.0, 0.0, 0.0], ..Observation::default() }
}
