//! A drive's response to its command: H(s) = ω²/(s² + 2ζωs + ω²) (thesis 6.1).

/// A drive that follows its command as H(s) does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// ω_H (rad/s).
    pub natural_frequency: f64,
    /// ζ_H.
    pub damping_ratio: f64,
}

/// How a trolley moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motion {
    /// x (m).
    pub position: f64,
    /// V (m/s).
    pub velocity: f64,
    /// V̇ (m/s²).
    pub acceleration: f64,
}

impl Drive {
    /// The motion after an interval (s) with this command (m/s), exactly.
    #[must_use]
    pub fn after(&self, motion: Motion, command: f64, interval: f64) -> Motion {
        let Self { natural_frequency: omega, damping_ratio } = *self;
        let decay = damping_ratio * omega;
        let square = omega * omega * (1.0 - damping_ratio) * (1.0 + damping_ratio);
        let root = square.abs().sqrt();
        // e^(−ζωt) times cos or cosh, and sin or sinh over the root; so close to critical damping both are t.
        let (cosine, sine) = if root * interval < 1e-6 {
            let fade = (-decay * interval).exp();
            (fade, fade * interval)
        } else if square > 0.0 {
            let (fade, (sin, cos)) = ((-decay * interval).exp(), (root * interval).sin_cos());
            (fade * cos, fade * sin / root)
        } else {
            let [slow, fast] = [root, -root].map(|root| ((root - decay) * interval).exp());
            (0.5 * (slow + fast), 0.5 * (slow - fast) / root)
        };
        let (lag, acceleration) = (motion.velocity - command, motion.acceleration);
        let after = lag * (cosine + decay * sine) + acceleration * sine;
        let after_acceleration = acceleration * (cosine - decay * sine) - lag * omega * omega * sine;
        // ∫ of the lag, from its own equation.
        let way = -((after_acceleration - acceleration) + 2.0 * decay * (after - lag)) / (omega * omega);
        Motion {
            position: motion.position + command * interval + way,
            velocity: command + after,
            acceleration: after_acceleration,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_response_solves_its_equation() {
        for damping_ratio in [0.3, 0.75, 1.0, 1.0 + 1e-14, 2.5] {
            let drive = Drive { natural_frequency: 3.7, damping_ratio };
            let start = Motion { position: 2.0, velocity: -0.3, acceleration: 0.4 };
            let (command, interval, count) = (0.6, 0.9, 20_000);
            let step = interval / f64::from(count);
            let mut motion = start;
            for _ in 0..count {
                let jerk = |m: Motion| 3.7 * 3.7 * (command - m.velocity) - 2.0 * damping_ratio * 3.7 * m.acceleration;
                let along = |m: Motion, by: Motion, h: f64| Motion {
                    position: m.position + h * by.velocity,
                    velocity: m.velocity + h * by.acceleration,
                    acceleration: m.acceleration + h * jerk(by),
                };
                let half = along(motion, motion, 0.5 * step);
                motion = along(motion, half, step);
            }
            let found = drive.after(start, command, interval);
            assert!((found.position - motion.position).abs() < 1e-8, "{found:?} for {motion:?}");
            assert!((found.velocity - motion.velocity).abs() < 1e-8, "{found:?} for {motion:?}");
            assert!((found.acceleration - motion.acceleration).abs() < 1e-7, "{found:?} for {motion:?}");
        }
    }

    #[test]
    fn extremes_stay_finite() {
        for natural_frequency in [0.1, 1e3] {
            for damping_ratio in [0.01, 1.0, 10.0] {
                let drive = Drive { natural_frequency, damping_ratio };
                let found = drive.after(Motion { position: 0.0, velocity: 1.0, acceleration: -1.0 }, 0.0, 1e4);
                assert!(found.position.is_finite() && found.velocity.is_finite() && found.acceleration.is_finite());
            }
        }
    }
}
