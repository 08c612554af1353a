//! A crane that is simulated: nonlinear double pendulum (thesis 6.1.1), drive with its limits (fig. 6.3).

/// An axis of a crane.
#[derive(Clone)]
pub struct Plant {
    /// L_h, L_p (m) and M.
    pub hoist: f64,
    pub rigging: f64,
    pub mass_ratio: f64,
    /// x, V, V̇, the rate limiter's reference, the angles of hook and payload from the vertical, and their rates.
    pub state: [f64; 8],
}

/// The drive's p (m/s), a_max (m/s²), X (m/s), ω_H (rad/s) and ζ_H.
pub const FASTEST: f64 = 0.75;
pub const STEEPEST: f64 = 0.63;
const REVERSAL: f64 = 0.05;
pub const FREQUENCY: f64 = 3.7;
pub const DAMPING: f64 = 0.75;

impl Plant {
    pub fn new(swing: f64) -> Self {
        Self { hoist: 8.0, rigging: 3.0, mass_ratio: 0.5, state: [0.0, 0.0, 0.0, 0.0, swing, swing, 0.0, 0.0] }
    }

    /// With the rate limiter running at `slope`.
    fn derivative(&self, [_, v, a, r, a1, a2, w1, w2]: [f64; 8], slope: f64) -> [f64; 8] {
        let (l1, l2, m, g) = (self.hoist, self.rigging, self.mass_ratio, 9.81);
        let jerk = FREQUENCY * FREQUENCY * (r - v) - 2.0 * DAMPING * FREQUENCY * a;
        let (sin, cos) = (a1 - a2).sin_cos();
        let upper = -m * l2 * sin * w2 * w2 - (1.0 + m) * (g * a1.sin() + a * a1.cos());
        let lower = l1 * sin * w1 * w1 - g * a2.sin() - a * a2.cos();
        let determinant = (1.0 + m) * l1 * l2 - m * l2 * cos * l1 * cos;
        let alpha1 = (upper * l2 - m * l2 * cos * lower) / determinant;
        let alpha2 = ((1.0 + m) * l1 * lower - l1 * cos * upper) / determinant;
        [v, a, jerk, slope, w1, w2, alpha1, alpha2]
    }

    /// How fast the rate limiter's reference moves in a time `h` (s) with this command (m/s).
    fn slope(&self, command: f64, h: f64) -> f64 {
        let limited = command.clamp(-FASTEST, FASTEST);
        let [velocity, reference] = [self.state[1], self.state[3]];
        let target = if limited * velocity >= 0.0 || velocity.abs() <= REVERSAL { limited } else { 0.0 };
        ((target - reference) / h).clamp(-STEEPEST, STEEPEST)
    }

    /// A time `h` (s) with this command (m/s), by Runge and Kutta.
    pub fn step(&mut self, command: f64, h: f64) {
        let (y, slope) = (self.state, self.slope(command, h));
        let along = |k: &[f64; 8], h: f64| std::array::from_fn(|i| y[i] + h * k[i]);
        let k1 = self.derivative(y, slope);
        let k2 = self.derivative(along(&k1, 0.5 * h), slope);
        let k3 = self.derivative(along(&k2, 0.5 * h), slope);
        let k4 = self.derivative(along(&k3, h), slope);
        self.state = std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }

    /// The same by the half-implicit Euler rule: a rate is taken after its own step.
    pub fn step_by_euler(&mut self, command: f64, h: f64) {
        self.state[3] += self.slope(command, h) * h;
        let rates = self.derivative(self.state, 0.0);
        for i in [2, 6, 7] {
            self.state[i] += h * rates[i];
        }
        for (i, rate) in [(1, 2), (0, 1), (4, 6), (5, 7)] {
            self.state[i] += h * self.state[rate];
        }
    }

    /// Position of the trolley (m).
    pub fn trolley(&self) -> f64 {
        self.state[0]
    }

    /// Angle of the hook (rad).
    pub fn swing(&self) -> f64 {
        self.state[4]
    }

    /// Displacement of the hook (m).
    pub fn hook(&self) -> f64 {
        self.hoist * self.swing().sin()
    }
}
