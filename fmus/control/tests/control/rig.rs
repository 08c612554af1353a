//! The crane with its sensors and its controller.

use std::collections::VecDeque;

use swayless_control::*;

use crate::plant::{DAMPING, FASTEST, FREQUENCY, Plant, STEEPEST};

/// Step of the simulation (s), and how many of them lie between two samples of camera, laser and controller.
const STEP: f64 = 0.005;
const CAMERA: usize = 8;
const OTHERS: usize = 4;
/// Time from one sample of the controller to the next (s).
pub const SAMPLE: f64 = STEP * OTHERS as f64;

/// What was at a sample.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    pub time: f64,
    pub trolley: f64,
    pub hook: f64,
    pub shown: Shown,
}

/// A crane with its controller.
pub struct Rig {
    pub plant: Plant,
    pub settings: Settings,
    /// What it is to do at a time.
    pub goal: fn(f64) -> Goal,
    /// When camera and laser fail.
    pub blind: [std::ops::Range<f64>; 2],
    /// Rate of the hoist at a time (m/s).
    pub hoisting: fn(f64) -> f64,
}

fn settings(form: Form) -> Settings {
    // As much as each form can have.
    let position_gain = if form == Form::InLoop { 1.5 } else { 0.14 };
    Settings {
        crane: Crane {
            pendulum: Pendulum { gravity: 9.81, hoist: 8.0, rigging: 3.0, mass_ratio: 0.5 },
            drive: Drive { natural_frequency: FREQUENCY, damping_ratio: DAMPING },
        },
        form,
        limits: Limits { velocity: FASTEST, acceleration: STEEPEST },
        feedback: Feedback { position_gain, sway_gain: 3.0, lead_time: 0.4 },
        correction_limit: 0.35,
        uncertainty: Uncertainty { noise: 0.003, disturbance: 0.02, wander: 0.001, start: 0.05, offset: 0.02 },
        hook_latency: 0.12,
        position_latency: 0.02,
        position_filter: 0.2,
        fade_time: 0.5,
        position_tolerance: 0.005,
        swing_tolerance: 0.01,
    }
}

/// Numbers between −1 and 1 with a triangular distribution, always the same ones.
struct Random(u64);

impl Random {
    fn draw(&mut self) -> f64 {
        let mut uniform = || {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 11) as f64 / (1_u64 << 53) as f64
        };
        uniform() - uniform()
    }

    /// Of this standard deviation.
    fn noise(&mut self, deviation: f64) -> f64 {
        deviation * 6.0_f64.sqrt() * self.draw()
    }
}

/// Rounded to what a sensor can tell apart.
fn round(value: f64, to: f64) -> f64 {
    (value / to).round() * to
}

impl Rig {
    /// At rest but for a swing (rad).
    pub fn new(form: Form, swing: f64) -> Self {
        Self {
            plant: Plant::new(swing),
            settings: settings(form),
            goal: |_| Goal::Position(1.25),
            blind: [-1.0..-1.0, -1.0..-1.0],
            hoisting: |_| 0.0,
        }
    }

    /// A run with a camera that is 0.1 s late, with 0.2 mrad of noise and pixels of 0.5 mrad, every 0.04 s; and a laser that
    /// is 12 ms late, with 1 mm of noise and resolution, every 0.02 s.
    pub fn run(mut self, until: f64) -> Vec<Row> {
        let mut random = Random(1);
        let (mut camera, mut laser) = (VecDeque::new(), VecDeque::new());
        let mut sensors = Measured { hook: None, position: None };
        let mut control = PositionControl::new();
        let mut rows = Vec::new();
        let mut command = 0.0;
        for i in 0..=(until / STEP).round() as usize {
            let time = i as f64 * STEP;
            if i % CAMERA == 0 {
                let image = round(self.plant.swing().tan() + random.noise(2e-4), 5e-4);
                camera.push_back((time + 0.1, image.atan().sin() * self.plant.hoist));
            }
            if i % OTHERS == 0 {
                laser.push_back((time + 0.012, round(self.plant.trolley() + random.noise(1e-3), 1e-3)));
            }
            while let Some((_, value)) = camera.pop_front_if(|(due, _)| *due <= time + 1e-9) {
                sensors.hook = Some(value);
            }
            while let Some((_, value)) = laser.pop_front_if(|(due, _)| *due <= time + 1e-9) {
                sensors.position = Some(value);
            }
            if i % OTHERS == 0 {
                let [no_camera, no_laser] = [0, 1].map(|sensor| self.blind[sensor].contains(&time));
                let measured = Measured {
                    hook: sensors.hook.filter(|_| !no_camera),
                    position: sensors.position.filter(|_| !no_laser),
                };
                let shown = control.step(time, SAMPLE, &self.settings, (self.goal)(time), measured);
                command = shown.velocity;
                rows.push(Row { time, trolley: self.plant.trolley(), hook: self.plant.hook(), shown });
            }
            let rate = (self.hoisting)(time);
            self.plant.hoist += rate * STEP;
            self.settings.crane.pendulum.hoist += rate * STEP;
            // 2 l̇ ȧ₁/l, which a hoist of constant length does not have.
            self.plant.state[6] -= 2.0 * rate / self.plant.hoist * self.plant.state[6] * STEP;
            self.plant.step(command, STEP);
        }
        rows
    }
}

/// The greatest of some rows.
pub fn greatest(rows: &[Row], of: impl Fn(&Row) -> f64) -> f64 {
    rows.iter().map(of).fold(f64::NEG_INFINITY, f64::max)
}

/// Those between two times.
pub fn between(rows: &[Row], from: f64, to: f64) -> &[Row] {
    let index = |time: f64| rows.partition_point(|row| row.time < time);
    &rows[index(from)..index(to)]
}

/// What a move was like (mm, s).
#[derive(Clone, Copy, Debug)]
pub struct Move {
    /// Distance to the target at the end.
    pub error: f64,
    /// The hook's swing in the last slow period.
    pub residual: f64,
    pub overshoot: f64,
    /// When trolley and hook are within 5 mm for good.
    pub settled: f64,
}

pub fn judge(rows: &[Row], target: f64) -> Move {
    let end = rows[rows.len() - 1];
    let away = |row: &Row| (row.trolley - target).abs().max(row.hook.abs());
    Move {
        error: 1e3 * (end.trolley - target).abs(),
        residual: 1e3 * greatest(between(rows, end.time - 6.2, end.time), |row| row.hook.abs()),
        overshoot: 1e3 * greatest(rows, |row| row.trolley - target).max(0.0),
        settled: rows.iter().rev().find(|row| away(row) > 0.005).map_or(0.0, |row| row.time),
    }
}

/// The hook's greatest displacement (mm) in the slow period that begins 10, 20 and 40 s after the start.
pub fn envelope(rows: &[Row]) -> [f64; 3] {
    [10.0, 20.0, 40.0].map(|time| 1e3 * greatest(between(rows, time, time + 6.11), |row| row.hook.abs()))
}
