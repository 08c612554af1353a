//! Hook and payload on one axis as a double pendulum with small swing (thesis 6.1.1).

use nalgebra::{Matrix2, Vector2};

/// Hook and payload below a trolley, on one axis.
///
/// With the displacements u_h, u_p from the vertical through the trolley and M = m_p/m_h, p = (u_h, √M u_p) moves as
/// `p̈ = −S p − b a`, where a is the trolley's acceleration, b = (1, √M), and
/// `S = [(1 + M) g/L_h + M g/L_p, −√M g/L_p; −√M g/L_p, g/L_p]`. That is (6.2), made symmetric: without payload (M = 0) the
/// hook is a single pendulum, and the second coordinate neither moves nor matters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pendulum {
    /// Gravity (m/s²).
    pub gravity: f64,
    /// From trolley to hook, L_h (m).
    pub hoist: f64,
    /// From hook to payload, L_p (m).
    pub rigging: f64,
    /// Mass of the payload per mass of the hook, M.
    pub mass_ratio: f64,
}

/// The two modes of a pendulum, the slower one first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modes {
    /// ω₁ ≤ ω₂ (rad/s).
    pub frequency: [f64; 2],
    /// The modes' directions in p, as columns; orthonormal.
    pub direction: Matrix2<f64>,
}

/// p and ṗ.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Swing {
    /// p (m).
    pub place: Vector2<f64>,
    /// ṗ (m/s).
    pub rate: Vector2<f64>,
}

impl Pendulum {
    /// b: what the trolley's acceleration pushes.
    #[must_use]
    pub fn push(&self) -> Vector2<f64> {
        Vector2::new(1.0, self.mass_ratio.sqrt())
    }

    /// S (1/s²).
    #[must_use]
    pub fn stiffness(&self) -> Matrix2<f64> {
        let Self { gravity, hoist, rigging, mass_ratio } = *self;
        let (upper, lower) = ((1.0 + mass_ratio) * gravity / hoist, gravity / rigging);
        let coupling = -mass_ratio.sqrt() * lower;
        Matrix2::new(upper + mass_ratio * lower, coupling, coupling, lower)
    }

    /// Where p rests while the trolley accelerates by `a` (m/s²): both ropes lean by a/g.
    #[must_use]
    pub fn rest(&self, a: f64) -> Vector2<f64> {
        let lean = -a / self.gravity;
        Vector2::new(lean * self.hoist, lean * self.mass_ratio.sqrt() * (self.hoist + self.rigging))
    }

    /// Frequencies (rad/s) of the modes that are seen in the hook: what hangs below it without mass is not.
    #[must_use]
    pub fn seen(&self, modes: &Modes) -> [Option<f64>; 2] {
        if self.mass_ratio == 0.0 {
            [Some((self.gravity / self.hoist).sqrt()), None]
        } else {
            modes.frequency.map(Some)
        }
    }

    /// The modes, (6.3) and (6.4).
    #[must_use]
    pub fn modes(&self) -> Modes {
        let stiffness = self.stiffness();
        let (a, b, d) = (stiffness[(0, 0)], stiffness[(0, 1)], stiffness[(1, 1)]);
        let fast = 0.5 * (a + d + (a - d).hypot(2.0 * b));
        // det S = (1 + M) g²/(L_h L_p), with nothing cancelled.
        let slow = (1.0 + self.mass_ratio) * self.gravity / self.hoist * (self.gravity / self.rigging) / fast;
        let (sin, cos) = (0.5 * (2.0 * b).atan2(a - d)).sin_cos();
        Modes { frequency: [slow.sqrt(), fast.sqrt()], direction: Matrix2::new(-sin, cos, cos, sin) }
    }
}

/// What an interval without force does to a swing: p⁺ = C p + S₁ ṗ, ṗ⁺ = −S₂ p + C ṗ.
#[derive(Clone, Copy, Debug)]
pub struct Transition {
    /// cos √S t.
    pub cosine: Matrix2<f64>,
    /// sin(√S t)/√S.
    pub sine: Matrix2<f64>,
    /// √S sin √S t.
    pub force: Matrix2<f64>,
}

impl Modes {
    /// What an interval (s) does; one to come if positive, one that has passed if negative.
    #[must_use]
    pub fn transition(&self, interval: f64) -> Transition {
        let [slow, fast] = self.frequency.map(|frequency| (frequency, (frequency * interval).sin_cos()));
        let turn = |of: fn((f64, (f64, f64))) -> f64| {
            let diagonal = Matrix2::from_diagonal(&Vector2::new(of(slow), of(fast)));
            self.direction * diagonal * self.direction.transpose()
        };
        Transition {
            cosine: turn(|(_, (_, cos))| cos),
            sine: turn(|(frequency, (sin, _))| sin / frequency),
            force: turn(|(frequency, (sin, _))| sin * frequency),
        }
    }

    /// How far the hook swings to either side at most (m), if the trolley keeps its velocity.
    #[must_use]
    pub fn hook_amplitude(&self, swing: Swing) -> f64 {
        let place = self.direction.transpose() * swing.place;
        let rate = self.direction.transpose() * swing.rate;
        let of = |mode: usize| self.direction[(0, mode)].abs() * place[mode].hypot(rate[mode] / self.frequency[mode]);
        of(0) + of(1)
    }
}

impl Transition {
    /// The swing after the interval, of a pendulum whose trolley accelerates so that p would rest at `rest`.
    #[must_use]
    pub fn of(&self, swing: Swing, rest: Vector2<f64>) -> Swing {
        let place = swing.place - rest;
        Swing {
            place: rest + self.cosine * place + self.sine * swing.rate,
            rate: self.cosine * swing.rate - self.force * place,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed form of (6.3) and (6.4).
    fn thesis(Pendulum { gravity: g, hoist, rigging, mass_ratio }: Pendulum) -> [f64; 2] {
        let sum = (1.0 + mass_ratio) * (1.0 / hoist + 1.0 / rigging);
        let beta = (sum * sum - 4.0 * (1.0 + mass_ratio) / (hoist * rigging)).sqrt();
        [-beta, beta].map(|beta| (g / 2.0 * (sum + beta)).sqrt())
    }

    #[test]
    fn modes_are_those_of_the_thesis() {
        for (hoist, rigging, mass_ratio) in
            [(8.0, 3.0, 0.5), (6.0, 4.0, 2.0), (8.0, 3.0, 5.0), (4.0, 6.0, 1.0), (5.0, 2.0, 0.0)]
        {
            let pendulum = Pendulum { gravity: 9.81, hoist, rigging, mass_ratio };
            let Modes { frequency, direction } = pendulum.modes();
            for (found, wanted) in frequency.iter().zip(thesis(pendulum)) {
                assert!((found / wanted - 1.0).abs() < 1e-13, "{found} for {wanted}");
            }
            let diagonal = direction.transpose() * pendulum.stiffness() * direction;
            let wanted = Matrix2::from_diagonal(&Vector2::from(frequency.map(|f| f * f)));
            assert!((diagonal - wanted).abs().max() < 1e-13, "{diagonal}");
        }
    }

    /// Against small steps of the equation of motion itself.
    #[test]
    fn transitions_solve_the_equation_of_motion() {
        let pendulum = Pendulum { gravity: 9.81, hoist: 8.0, rigging: 3.0, mass_ratio: 0.5 };
        let start = Swing { place: Vector2::new(0.3, -0.2), rate: Vector2::new(-0.4, 0.5) };
        let (a, interval, count) = (0.4, 1.3, 26_000);
        let step = interval / f64::from(count);
        let mut swing = start;
        for _ in 0..count {
            // The mid-point rule: an error of 1e-9.
            let acceleration = |place: Vector2<f64>| -pendulum.stiffness() * place - pendulum.push() * a;
            let half = swing.place + swing.rate * (0.5 * step);
            let rate = swing.rate + acceleration(half) * step;
            swing = Swing { place: swing.place + (swing.rate + rate) * (0.5 * step), rate };
        }
        let modes = pendulum.modes();
        let found = modes.transition(interval).of(start, pendulum.rest(a));
        assert!((found.place - swing.place).amax() < 1e-8 && (found.rate - swing.rate).amax() < 1e-8);
        let back = modes.transition(-interval).of(found, pendulum.rest(a));
        assert!((back.place - start.place).amax() < 1e-14 && (back.rate - start.rate).amax() < 1e-14);
    }

    #[test]
    fn the_hook_swings_as_far_as_its_amplitude() {
        let modes = Pendulum { gravity: 9.81, hoist: 8.0, rigging: 3.0, mass_ratio: 0.5 }.modes();
        let swing = Swing { place: Vector2::new(0.3, -0.2), rate: Vector2::new(-0.4, 0.5) };
        let far =
            (0..200_000).map(|i| modes.transition(0.01 * f64::from(i)).of(swing, Vector2::zeros()).place[0].abs());
        let (far, amplitude) = (far.fold(0.0, f64::max), modes.hook_amplitude(swing));
        assert!(far <= amplitude && far > 0.999 * amplitude, "{far} of {amplitude}");
    }
}
