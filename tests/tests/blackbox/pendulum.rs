//! A payload under a trolley that a drive moves, with small swing.

use crate::instance::Instance;

/// A payload under a trolley with the drive's velocity v: θ̈ + ω²θ = −v̇/L as θ̇ = p − v/L, ṗ = −ω²θ, where v may jump.
pub struct Pendulum {
    length: f64,
    squared: f64,
    angle: f64,
    momentum: f64,
}

impl Pendulum {
    /// At rest.
    pub fn new(length: f64, gravity: f64) -> Self {
        Self { length, squared: gravity / length, angle: 0.0, momentum: 0.0 }
    }

    /// A step of the classical fourth order, with v at its begin, middle and end.
    fn step(&mut self, h: f64, v: [f64; 3]) {
        let (mut slope, mut sum) = ((0.0, 0.0), (0.0, 0.0));
        for (part, weight, v) in [(0.0, 1.0, v[0]), (0.5, 2.0, v[1]), (0.5, 2.0, v[1]), (1.0, 1.0, v[2])] {
            let (angle, momentum) = (self.angle + part * h * slope.0, self.momentum + part * h * slope.1);
            slope = (momentum - v / self.length, -self.squared * angle);
            sum = (sum.0 + weight * slope.0, sum.1 + weight * slope.1);
        }
        self.angle += h / 6.0 * sum.0;
        self.momentum += h / 6.0 * sum.1;
    }

    /// With the drive from `begin` to `end`, over a velocity without corners.
    fn follow(&mut self, drive: &mut Instance, begin: f64, end: f64) {
        let rounds = ((end - begin) / 4e-3).ceil();
        let half = 0.5 * (end - begin) / rounds;
        let mut after = drive.get("velocity");
        for round in 0..rounds as u32 {
            let before = after;
            let [middle, end] = [0.0, 1.0].map(|part| {
                drive.slave.do_step(begin + half * (2.0 * f64::from(round) + part), half).expect("a step");
                drive.get("velocity")
            });
            self.step(2.0 * half, [before, middle, end]);
            after = end;
        }
    }

    /// The amplitude (m) that commands leave it with behind a drive that brakes with a time constant: their instants and values.
    pub fn residual(mut self, drive: &mut Instance, commands: &[(f64, f64)], braking: f64) -> f64 {
        let last = commands[commands.len() - 1].0 + 4.0;
        let ends = commands.iter().skip(1).map(|(time, _)| *time).chain([last]);
        for (&(begin, command), end) in commands.iter().zip(ends) {
            let v = drive.get("velocity");
            drive.set("command", command).expect("a command");
            let turn = if v * command < 0.0 { begin + braking * ((command - v) / command).ln() } else { begin };
            self.follow(drive, begin, turn.min(end));
            self.follow(drive, turn.min(end), end);
        }
        let rate = self.momentum - drive.get("velocity") / self.length;
        self.length * self.angle.hypot(rate / self.squared.sqrt())
    }
}
