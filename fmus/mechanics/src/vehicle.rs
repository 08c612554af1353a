//! Kinematics of a car-like base: steered in front, driven at the rear, without slip (thesis 4.1).

use swayless_scalar::Scalar;

/// A base on wheels. Its reference point is the centre of the rear axle, which moves straight ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vehicle<R: Scalar> {
    /// L, from the rear axle to the front axle (m).
    pub wheelbase: R,
    /// ψ, where it points to (rad).
    pub yaw: R,
}

/// What a driver does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Driving<R: Scalar> {
    /// v, speed of the rear axle (m/s).
    pub speed: R,
    /// v̇ (m/s²).
    pub acceleration: R,
    /// δ, angle of the front wheels, positive to the left (rad).
    pub steering: R,
    /// δ̇ (rad/s).
    pub steering_rate: R,
}

/// How a base moves on the ground: its rates, or their time derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VehicleRates<R: Scalar> {
    /// Of the reference point, x and y in the world (m/s, m/s²).
    pub along: [R; 2],
    /// Of the yaw (rad/s, rad/s²).
    pub yaw: R,
}

impl<R: Scalar> Vehicle<R> {
    /// ẋ = v cos ψ, ẏ = v sin ψ, ψ̇ = v tan δ/L: the axes of all wheels meet in one point, L/tan δ beside the rear axle.
    pub fn rates(&self, driving: &Driving<R>) -> VehicleRates<R> {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let speed = driving.speed;
        VehicleRates { along: [speed * cos_yaw, speed * sin_yaw], yaw: speed * self.curvature(driving) }
    }

    /// Their time derivatives: v̇ ahead and v ψ̇ to the left, ψ̈ = (v̇ tan δ + v δ̇/cos² δ)/L.
    pub fn accelerations(&self, driving: &Driving<R>) -> VehicleRates<R> {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let cos = driving.steering.cos();
        let (ahead, curvature) = (driving.acceleration, self.curvature(driving));
        let left = driving.speed * driving.speed * curvature;
        VehicleRates {
            along: [ahead * cos_yaw - left * sin_yaw, ahead * sin_yaw + left * cos_yaw],
            yaw: ahead * curvature + driving.speed * driving.steering_rate / (cos * cos * self.wheelbase),
        }
    }

    /// tan δ/L, of the path of the reference point (1/m).
    fn curvature(&self, driving: &Driving<R>) -> R {
        let (sin, cos) = driving.steering.sin_cos();
        sin / (cos * self.wheelbase)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn driving(speed: f64, steering: f64) -> Driving<f64> {
        Driving { speed, acceleration: 0.7, steering, steering_rate: -0.4 }
    }

    const CASES: [(f64, f64, f64); 4] = [(0.0, 1.5, 0.3), (2.1, -0.7, 0.9), (-0.4, 3.0, -1.2), (1.0, 2.0, 0.0)];

    /// Rolling without slip: the front wheels move where they point to.
    #[test]
    fn no_wheel_slips() {
        for (yaw, speed, steering) in CASES {
            let vehicle = Vehicle { wheelbase: 2.5, yaw };
            let rates = vehicle.rates(&driving(speed, steering));
            let [x, y] = rates.along;
            let turning = vehicle.wheelbase * rates.yaw;
            let front = [x - turning * yaw.sin(), y + turning * yaw.cos()];
            let heading = yaw + steering;
            let across = front[1] * heading.cos() - front[0] * heading.sin();
            assert!(across.abs() < 1e-14, "the front axle slips by {across} m/s");
            // Nor does the rear axle, and along its own direction it has the speed.
            assert!((y * yaw.cos() - x * yaw.sin()).abs() < 1e-15);
            assert!((x * yaw.cos() + y * yaw.sin() - speed).abs() < 1e-15);
        }
    }

    #[test]
    fn accelerations_are_the_time_derivatives_of_the_rates() {
        for (yaw, speed, steering) in CASES {
            let now = driving(speed, steering);
            let vehicle = Vehicle { wheelbase: 2.5, yaw };
            let turning = vehicle.rates(&now).yaw;
            let rates = |dt: f64| {
                let then = Driving {
                    speed: speed + dt * now.acceleration,
                    steering: steering + dt * now.steering_rate,
                    ..now
                };
                let VehicleRates { along: [x, y], yaw } = Vehicle { yaw: yaw + dt * turning, ..vehicle }.rates(&then);
                [x, y, yaw]
            };
            let (before, after) = (rates(-1e-5), rates(1e-5));
            let VehicleRates { along: [x, y], yaw } = vehicle.accelerations(&now);
            for (i, found) in [x, y, yaw].into_iter().enumerate() {
                // A central difference: dt² times a third derivative, and 1e-16/dt of rounding.
                let wanted = (after[i] - before[i]) / 2e-5;
                assert!((found - wanted).abs() < 1e-7 * (1.0 + wanted.abs()), "{i}: {found} and {wanted}");
            }
        }
    }
}
