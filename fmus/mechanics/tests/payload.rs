//! The payload's rates against the thesis's equations of motion, a conserved quantity and a closed form.

#![allow(missing_docs, reason = "a test binary has no readers of its documentation")]

mod common;

use common::spread;
use swayless_mechanics::{Boom, BoomAccelerations, BoomRates, Payload, Suspension, Swing, SwingFrame, Vector};

const G: f64 = 9.81;

/// Joints, their rates and accelerations at one time.
struct Pose {
    boom: Boom<f64>,
    rates: BoomRates<f64>,
    accelerations: BoomAccelerations<f64>,
    /// ℓ, ℓ̇, ℓ̈.
    length: [f64; 3],
}

fn moving(next: &mut impl FnMut() -> f64, turning: f64) -> BoomRates<f64> {
    let base = [next(), next()];
    BoomRates { base, yaw: turning * next(), slew: turning * next(), luff: turning * next(), length: next() }
}

fn pose(next: &mut impl FnMut() -> f64) -> Pose {
    Pose {
        boom: Boom {
            base: [next(), next()],
            yaw: 3.0 * next(),
            slew: 3.0 * next(),
            luff: 0.7 + 0.6 * next(),
            length: 10.0,
            offset: 0.8,
            height: 1.5,
        },
        rates: moving(next, 0.5),
        accelerations: moving(next, 1.0),
        length: [5.0 + next(), next(), next()],
    }
}

/// The tip's acceleration in the turning frame (thesis 2.1; derived there from the reach R = r cos γ).
fn tip_acceleration(pose: &Pose) -> [f64; 3] {
    let (r, a) = (pose.boom.length, pose.boom.offset);
    let (theta, q) = (pose.boom.slew, pose.boom.yaw + pose.boom.slew);
    let BoomRates { yaw: psi_rate, luff: luff_rate, length: r_rate, .. } = pose.rates;
    let BoomAccelerations {
        base: [x, y], yaw: psi_acceleration, luff: luff_acceleration, length: r_acceleration, ..
    } = pose.accelerations;
    let omega = pose.rates.yaw + pose.rates.slew;
    let omega_rate = pose.accelerations.yaw + pose.accelerations.slew;
    let (sin_luff, cos_luff) = pose.boom.luff.sin_cos();
    let reach = r * cos_luff;
    let reach_rate = r_rate * cos_luff - r * luff_rate * sin_luff;
    let reach_acceleration = r_acceleration * cos_luff
        - 2.0 * r_rate * luff_rate * sin_luff
        - r * luff_acceleration * sin_luff
        - r * luff_rate.powi(2) * cos_luff;
    let a_r = x * q.cos() + y * q.sin() - a * psi_rate.powi(2) * theta.cos()
        + a * psi_acceleration * theta.sin()
        + reach_acceleration
        - reach * omega.powi(2);
    let a_t = -x * q.sin()
        + y * q.cos()
        + a * psi_rate.powi(2) * theta.sin()
        + a * psi_acceleration * theta.cos()
        + reach * omega_rate
        + 2.0 * reach_rate * omega;
    let a_z = r_acceleration * sin_luff + 2.0 * r_rate * luff_rate * cos_luff + r * luff_acceleration * cos_luff
        - r * luff_rate.powi(2) * sin_luff;
    [a_r, a_t, a_z]
}

/// β̈ and φ̈ of the full nonlinear equations (2.13)–(2.14), in the order β, then φ (thesis 2.1; derived by Lagrange and
/// by projection).
fn thesis(pose: &Pose, swing: Swing<f64>, rates: Swing<f64>) -> Swing<f64> {
    let [a_r, a_t, a_z] = tip_acceleration(pose);
    let omega = pose.rates.yaw + pose.rates.slew;
    let omega_rate = pose.accelerations.yaw + pose.accelerations.slew;
    let [l, l_rate, _] = pose.length;
    let ((sin_b, cos_b), (sin_p, cos_p)) = (swing.tangential.sin_cos(), swing.radial.sin_cos());
    let (b, p) = (rates.tangential, rates.radial);
    let kappa = 2.0 * omega * l_rate / l + omega_rate;
    Swing {
        tangential: -a_t * cos_b / (l * cos_p) - (G + a_z) * sin_b / (l * cos_p) + omega.powi(2) * sin_b * cos_b
            - 2.0 * omega * p * cos_b
            - kappa * cos_b * sin_p / cos_p
            + 2.0 * b * p * sin_p / cos_p
            - 2.0 * l_rate / l * b,
        radial: -a_r * cos_p / l + a_t * sin_b * sin_p / l - (G + a_z) * cos_b * sin_p / l
            + omega.powi(2) * sin_p * cos_p * cos_b.powi(2)
            + 2.0 * omega * b * cos_b * cos_p.powi(2)
            + kappa * sin_b
            - b.powi(2) * sin_p * cos_p
            - 2.0 * l_rate / l * p,
    }
}

/// The pose a moment later.
fn later(pose: &Pose, dt: f64) -> (Boom<f64>, BoomRates<f64>) {
    let mut boom = pose.boom;
    let mut rates = pose.rates;
    for i in 0..2 {
        boom.base[i] += dt * pose.rates.base[i];
        rates.base[i] += dt * pose.accelerations.base[i];
    }
    boom.yaw += dt * (pose.rates.yaw + 0.5 * dt * pose.accelerations.yaw);
    boom.slew += dt * (pose.rates.slew + 0.5 * dt * pose.accelerations.slew);
    boom.luff += dt * (pose.rates.luff + 0.5 * dt * pose.accelerations.luff);
    boom.length += dt * (pose.rates.length + 0.5 * dt * pose.accelerations.length);
    rates.length += dt * pose.accelerations.length;
    rates.yaw += dt * pose.accelerations.yaw;
    rates.slew += dt * pose.accelerations.slew;
    rates.luff += dt * pose.accelerations.luff;
    (boom, rates)
}

#[test]
fn rates_agree_with_the_thesis_at_any_state() {
    for i in 0..500 {
        let mut next = spread(i);
        let pose = pose(&mut next);
        let swing = Swing { radial: 0.9 * next(), tangential: 0.9 * next() };
        let rates = Swing { radial: next(), tangential: next() };
        let frame = pose.boom.swing_frame(&pose.rates);
        let omega = pose.rates.yaw + pose.rates.slew;
        let up = Vector::new(0.0, 0.0, 1.0);
        let n = frame.direction(swing);
        let n_rate = frame.direction_rate(swing, rates) + up.cross(&n) * omega;

        // Our rates, for the momentum that belongs to this motion.
        let pivot = pose.boom.tip_velocity(&frame, &pose.rates);
        let [length, length_rate, _] = pose.length;
        let suspension = Suspension { pivot, length, length_rate };
        let across = |u: Vector<f64>| u - n * n.dot(&u);
        let payload = Payload { direction: n, velocity: n_rate * length + across(pivot) };
        let found = payload.rates(&suspension, -up * G, 0.0);
        assert!((found.direction - n_rate).norm() < 1e-14);

        // The payload's acceleration by the thesis: angles of the frame, carried to the world by central differences of
        // exact expressions.
        let angles = thesis(&pose, swing, rates);
        let dt = 1e-4;
        let velocity = |s: f64| {
            let (boom, boom_rates) = later(&pose, s);
            let frame = boom.swing_frame(&boom_rates);
            let omega = boom_rates.yaw + boom_rates.slew;
            let at = |angle: f64, rate: f64, second: f64| angle + s * (rate + 0.5 * s * second);
            let swing = Swing {
                radial: at(swing.radial, rates.radial, angles.radial),
                tangential: at(swing.tangential, rates.tangential, angles.tangential),
            };
            let rates = Swing {
                radial: rates.radial + s * angles.radial,
                tangential: rates.tangential + s * angles.tangential,
            };
            let n = frame.direction(swing);
            let n_rate = frame.direction_rate(swing, rates) + up.cross(&n) * omega;
            // Whatever ℓ̈ is: the rate that is tested knows no acceleration.
            boom.tip_velocity(&frame, &boom_rates) + n * length_rate + n_rate * (length + s * length_rate)
        };
        // Fourth order, so that its error is far below what is tested.
        let acceleration =
            (velocity(-2.0 * dt) - velocity(2.0 * dt) + (velocity(dt) - velocity(-dt)) * 8.0) / (12.0 * dt);
        let v = velocity(0.0);
        let expected = across(acceleration) - n_rate * n.dot(&v) - n * n_rate.dot(&v);
        let error = (found.velocity - expected).norm();
        assert!(error < 1e-10 * (1.0 + expected.norm()), "state {i}: {error}");
    }
}

/// T/m by the thesis's angles (order β, then φ), from the projection of Newton's law on the cable.
#[test]
fn tension_agrees_with_the_thesis_at_any_state() {
    for i in 0..500 {
        let mut next = spread(i);
        let pose = pose(&mut next);
        let swing = Swing { radial: 0.9 * next(), tangential: 0.9 * next() };
        let rates = Swing { radial: next(), tangential: next() };
        let frame = pose.boom.swing_frame(&pose.rates);
        let omega = pose.rates.yaw + pose.rates.slew;
        let up = Vector::new(0.0, 0.0, 1.0);
        let n = frame.direction(swing);
        let n_rate = frame.direction_rate(swing, rates) + up.cross(&n) * omega;
        let pivot = pose.boom.tip_velocity(&frame, &pose.rates);
        let [length, length_rate, length_acceleration] = pose.length;
        let suspension = Suspension { pivot, length, length_rate };
        let payload = Payload { direction: n, velocity: n_rate * length + pivot - n * n.dot(&pivot) };
        let acceleration = pose.boom.tip_acceleration(&frame, &pose.rates, &pose.accelerations);
        let found = payload.tension(&suspension, -up * G, acceleration, length_acceleration);

        let [a_r, a_t, a_z] = tip_acceleration(&pose);
        let ((sin_b, cos_b), (sin_p, cos_p)) = (swing.tangential.sin_cos(), swing.radial.sin_cos());
        let (b, p) = (rates.tangential, rates.radial);
        let expected = -a_r * sin_p - a_t * cos_p * sin_b + (G + a_z) * cos_p * cos_b - length_acceleration
            + length * (p.powi(2) + b.powi(2) * cos_p.powi(2))
            + length * omega.powi(2) * (sin_p.powi(2) + cos_p.powi(2) * sin_b.powi(2))
            + 2.0 * omega * length * (b * cos_b * cos_p * sin_p - p * sin_b);
        assert!((found - expected).abs() < 1e-12 * (1.0 + expected.abs()), "state {i}: {found} and {expected}");
    }
}

#[test]
fn a_free_payload_keeps_its_energy() {
    // dE/dt = w·ẇ + g ℓ ṅ_z is zero without damping, wind and moving pivot, wherever the payload is.
    for i in 0..100 {
        let mut next = spread(i);
        let frame = SwingFrame::new(next(), 0.0);
        let (swing, rates) =
            (Swing { radial: 1.5 * next(), tangential: 3.0 * next() }, Swing { radial: next(), tangential: next() });
        let length = 6.0 + 5.0 * next();
        let payload = Payload::started(frame.direction(swing), frame.direction_rate(swing, rates), length);
        let still = Suspension { pivot: Vector::zeros(), length, length_rate: 0.0 };
        let change = payload.rates(&still, Vector::new(0.0, 0.0, -G), 0.0);
        let power = payload.velocity.dot(&change.velocity) + G * length * change.direction.z;
        assert!(power.abs() < 1e-12 * G * length, "{power}");
        // And the cable keeps its length.
        assert!(payload.direction.dot(&change.direction).abs() < 1e-14);
    }
}

#[test]
fn errors_of_the_constraints_do_not_feed_themselves() {
    // Integration leaves |n| ≠ 1 and w·n ≠ 0. Whatever they are, n does not grow, even with the pivot moving along it.
    for i in 0..100 {
        let mut next = spread(i);
        let n = SwingFrame::new(next(), 0.0).direction(Swing { radial: next(), tangential: next() });
        let velocity = Vector::new(next(), next(), next());
        let payload = Payload { direction: n * (1.0 + 0.1 * next()), velocity };
        let suspension = Suspension { pivot: n * 50.0 + velocity * 0.3, length: 7.0, length_rate: next() };
        let change = payload.rates(&suspension, Vector::new(0.0, 0.0, -G), 0.0);
        assert!(change.direction.dot(&n).abs() < 1e-14 * suspension.pivot.norm());
        // What matters moves as it would without the errors: n/|n|, and w⊥ = w − s n/|n| with s as it is.
        let size = payload.direction.norm();
        let s = n.dot(&velocity);
        let clean = Payload { direction: n, velocity: velocity - n * s };
        let expected = clean.rates(&suspension, Vector::new(0.0, 0.0, -G), 0.0);
        let turning = change.direction / size;
        assert!((turning - expected.direction).norm() < 1e-12 * suspension.pivot.norm());
        let across = change.velocity - turning * s;
        assert!((across - expected.velocity).norm() < 1e-12 * suspension.pivot.norm_squared());
    }
}

#[test]
fn the_amplitude_is_that_of_the_swing_to_come() {
    // At the turning point it is the angle; at the bottom ½ w² = g ℓ (1 − cos A).
    let frame = SwingFrame::new(0.3, 0.0);
    let rest = Swing { radial: 0.0, tangential: 0.0 };
    let still = Suspension { pivot: Vector::zeros(), length: 4.0, length_rate: 0.0 };
    for angle in [1e-9, 1e-3, 0.4, 1.2] {
        let swing = Swing { radial: angle, tangential: 0.0 };
        let turning = Payload::started(frame.direction(swing), Vector::zeros(), 4.0);
        assert!((turning.amplitude(&still, G) / angle - 1.0).abs() < 1e-12);
        let speed = 2.0 * (G / 4.0).sqrt() * (0.5 * angle).sin();
        let rate = frame.direction_rate(rest, Swing { radial: 0.0, tangential: speed });
        let bottom = Payload::started(frame.direction(rest), rate, 4.0);
        assert!((bottom.amplitude(&still, G) / angle - 1.0).abs() < 1e-12);
    }
    assert_eq!(Payload::started(frame.direction(rest), Vector::zeros(), 4.0).amplitude(&still, G), 0.0);
}

#[test]
fn angles_and_directions_are_each_others_inverse() {
    for i in 0..100 {
        let mut next = spread(i);
        let frame = SwingFrame::new(3.0 * next(), next());
        let swing = Swing { radial: 1.5 * next(), tangential: 3.1 * next() };
        let rates = Swing { radial: next(), tangential: next() };
        let n = frame.direction(swing);
        let back = frame.angles(n);
        assert!((back.radial - swing.radial).abs() < 1e-13 && (back.tangential - swing.tangential).abs() < 1e-13);
        let still = SwingFrame::new(0.2, 0.0);
        let found = still.rates(still.direction(swing), still.direction_rate(swing, rates));
        assert!((found.radial - rates.radial).abs() < 1e-12 && (found.tangential - rates.tangential).abs() < 1e-11);
    }
}
