//! Hook and payload against Newton's laws with the cables' forces as unknowns, which share nothing with the equations
//! tested but the forces; and against conserved energy and the single payload.

#![allow(missing_docs, reason = "a test binary has no readers of its documentation")]

mod common;

use common::spread;
use swayless_mechanics::{DoublePayload, DoubleSuspension, Payload, Suspension, Swing, SwingFrame, Vector};

const GRAVITY: Vector<f64> = Vector::new(0.0, 0.0, -9.81);

fn across(u: Vector<f64>, n: Vector<f64>) -> Vector<f64> {
    u - n * n.dot(&u)
}

/// Two masses, and where pivot and upper cable are: value, rate and acceleration.
#[derive(Clone, Copy)]
struct Rig {
    masses: [f64; 2],
    rigging: f64,
    damping: f64,
    forces: [Vector<f64>; 2],
    pivot: [Vector<f64>; 3],
    length: [f64; 3],
}

impl Rig {
    fn suspension(&self) -> DoubleSuspension<f64> {
        let upper = Suspension { pivot: self.pivot[1], length: self.length[0], length_rate: self.length[1] };
        DoubleSuspension { upper, rigging: self.rigging, mass_ratio: self.masses[1] / self.masses[0] }
    }

    fn pull(&self) -> [Vector<f64>; 2] {
        let [f1, f2] = self.forces;
        [GRAVITY + (f1 + f2) / (self.masses[0] + self.masses[1]), GRAVITY + f2 / self.masses[1]]
    }

    /// Accelerations of the masses: m₁a₁ = m₁g + F₁ − T₁n₁ + T₂n₂, m₂a₂ = m₂g + F₂ − T₂n₂, with the tensions for which
    /// the second derivatives of both lengths are what they are.
    fn newton(&self, r: [Vector<f64>; 2], v: [Vector<f64>; 2]) -> [Vector<f64>; 2] {
        let [m1, m2] = self.masses;
        let [p, p_rate, p_acceleration] = self.pivot;
        let [l, l_rate, l_acceleration] = self.length;
        let (n1, n2) = ((r[0] - p) / l, (r[1] - r[0]) / self.rigging);
        let (u1, u2) = (v[0] - p_rate, v[1] - v[0]);
        let drag1 = across(u1, n1) * (self.damping * (m1 + m2));
        let drag2 = across(u2, n2) * (self.damping * m2);
        let free1 = GRAVITY + (self.forces[0] - drag1 + drag2) / m1;
        let free2 = GRAVITY + (self.forces[1] - drag2) / m2;
        let c1 = (l_rate * l_rate + l * l_acceleration - u1.norm_squared()) / l - n1.dot(&(free1 - p_acceleration));
        let c2 = -u2.norm_squared() / self.rigging - n2.dot(&(free2 - free1));
        // −T₁/m₁ + T₂ c/m₁ = c₁ and T₁ c/m₁ − T₂ (1/m₁ + 1/m₂) = c₂ with c = n₁·n₂.
        let c = n1.dot(&n2);
        let determinant = (1.0 / m1 + 1.0 / m2) / m1 - (c / m1).powi(2);
        let t1 = (-c1 * (1.0 / m1 + 1.0 / m2) - c2 * c / m1) / determinant;
        let t2 = (-c2 / m1 - c1 * c / m1) / determinant;
        [free1 - n1 * (t1 / m1) + n2 * (t2 / m1), free2 - n2 * (t2 / m2)]
    }

    /// The state that belongs to these velocities.
    fn state(&self, n: [Vector<f64>; 2], v: [Vector<f64>; 2]) -> DoublePayload<f64> {
        let [m1, m2] = self.masses;
        let mean = (v[0] * m1 + v[1] * m2) / (m1 + m2);
        DoublePayload {
            hook: Payload { direction: n[0], velocity: across(mean, n[0]) },
            payload: Payload { direction: n[1], velocity: across(v[1], n[1]) },
        }
    }

    /// Where the masses are and how fast they move.
    fn placed(&self, n: [Vector<f64>; 2], n_rate: [Vector<f64>; 2]) -> ([Vector<f64>; 2], [Vector<f64>; 2]) {
        let r1 = self.pivot[0] + n[0] * self.length[0];
        let v1 = self.pivot[1] + n[0] * self.length[1] + n_rate[0] * self.length[0];
        ([r1, r1 + n[1] * self.rigging], [v1, v1 + n_rate[1] * self.rigging])
    }
}

/// Directions and their rates.
fn directions(next: &mut impl FnMut() -> f64) -> ([Vector<f64>; 2], [Vector<f64>; 2]) {
    let frame = SwingFrame::new(0.0, 0.0);
    let mut one = || {
        let swing = Swing { radial: 1.4 * next(), tangential: 3.0 * next() };
        let rates = Swing { radial: next(), tangential: next() };
        (frame.direction(swing), frame.direction_rate(swing, rates))
    };
    let ((n1, n1_rate), (n2, n2_rate)) = (one(), one());
    ([n1, n2], [n1_rate, n2_rate])
}

fn vector(next: &mut impl FnMut() -> f64) -> Vector<f64> {
    Vector::new(next(), next(), next())
}

fn rig(next: &mut impl FnMut() -> f64) -> Rig {
    Rig {
        masses: [2.0 + next(), 5.0 * (1.001 + next())],
        rigging: 3.0 + next(),
        damping: 0.3 * (1.0 + next()),
        forces: [vector(next), vector(next)],
        pivot: [vector(next), vector(next), vector(next)],
        length: [6.0 + next(), next(), next()],
    }
}

#[test]
fn rates_agree_with_newton_at_any_state() {
    for i in 0..500 {
        let mut next = spread(i);
        let rig = rig(&mut next);
        let (n, n_rate) = directions(&mut next);
        let (r, v) = rig.placed(n, n_rate);
        let state = rig.state(n, v);
        let suspension = rig.suspension();

        let found = state.velocity(&suspension);
        let scale = 1.0 + v[1].norm();
        assert!((found.hook - v[0]).norm() + (found.payload - v[1]).norm() < 1e-12 * scale, "state {i}");
        let change = state.rates(&suspension, rig.pull(), rig.damping);
        for (found, wanted) in [(change.hook, n_rate[0]), (change.payload, n_rate[1])] {
            assert!((found.direction - wanted).norm() < 1e-12, "state {i}");
        }

        // d/dt (u − n (n·u)) of the velocities, whose own derivatives are Newton's.
        let a = rig.newton(r, v);
        let [m1, m2] = rig.masses;
        let mean = |u: [Vector<f64>; 2]| (u[0] * m1 + u[1] * m2) / (m1 + m2);
        let product = |u: Vector<f64>, u_rate: Vector<f64>, n: Vector<f64>, n_rate: Vector<f64>| {
            across(u_rate, n) - n_rate * n.dot(&u) - n * n_rate.dot(&u)
        };
        let hook = product(mean(v), mean(a), n[0], n_rate[0]);
        let payload = product(v[1], a[1], n[1], n_rate[1]);
        let error = (change.hook.velocity - hook).norm() + (change.payload.velocity - payload).norm();
        assert!(error < 1e-10 * (1.0 + hook.norm() + payload.norm()), "state {i}: {error:e}");
    }
}

/// One step of the classical Runge–Kutta method.
fn runge_kutta<const N: usize>(
    x: [Vector<f64>; N],
    t: f64,
    dt: f64,
    f: impl Fn(f64, [Vector<f64>; N]) -> [Vector<f64>; N],
) -> [Vector<f64>; N] {
    let moved = |k: [Vector<f64>; N], h: f64| std::array::from_fn(|i| x[i] + k[i] * h);
    let k1 = f(t, x);
    let k2 = f(t + 0.5 * dt, moved(k1, 0.5 * dt));
    let k3 = f(t + 0.5 * dt, moved(k2, 0.5 * dt));
    let k4 = f(t + dt, moved(k3, dt));
    std::array::from_fn(|i| x[i] + (k1[i] + (k2[i] + k3[i]) * 2.0 + k4[i]) * (dt / 6.0))
}

fn unpack(x: [Vector<f64>; 4]) -> DoublePayload<f64> {
    let [n1, w1, n2, w2] = x;
    DoublePayload { hook: Payload { direction: n1, velocity: w1 }, payload: Payload { direction: n2, velocity: w2 } }
}

fn pack(state: DoublePayload<f64>) -> [Vector<f64>; 4] {
    [state.hook.direction, state.hook.velocity, state.payload.direction, state.payload.velocity]
}

/// Steps over which the method's own error, (ω dt)⁴ of what swings, is below what is tested.
const DT: f64 = 2e-4;

#[test]
fn trajectories_agree_with_newton() {
    let mut next = spread(7);
    let fixed = rig(&mut next);
    // A pivot that goes round and a cable that is hoisted and lowered.
    let at = |t: f64| {
        let (sin, cos) = (1.3 * t).sin_cos();
        let pivot = [
            Vector::new(sin, -0.7 * cos, 0.2 * sin),
            Vector::new(cos, 0.7 * sin, 0.2 * cos) * 1.3,
            Vector::new(-sin, 0.7 * cos, -0.2 * sin) * 1.69,
        ];
        let length = [6.0 + 0.5 * (2.0 * t).sin(), (2.0 * t).cos(), -2.0 * (2.0 * t).sin()];
        Rig { pivot, length, ..fixed }
    };
    let (n, n_rate) = directions(&mut next);
    let (r, v) = at(0.0).placed(n, n_rate);
    let mut ours = pack(at(0.0).state(n, v));
    let mut theirs = [r[0], r[1], v[0], v[1]];
    let mut worst = 0.0_f64;
    for i in 0..20_000 {
        let t = f64::from(i) * DT;
        ours = runge_kutta(ours, t, DT, |t, x| {
            let rig = at(t);
            pack(unpack(x).rates(&rig.suspension(), rig.pull(), rig.damping))
        });
        theirs = runge_kutta(theirs, t, DT, |t, [r1, r2, v1, v2]| {
            let [a1, a2] = at(t).newton([r1, r2], [v1, v2]);
            [v1, v2, a1, a2]
        });
        let rig = at(f64::from(i + 1) * DT);
        let state = unpack(ours);
        let hook = rig.pivot[0] + state.hook.unit() * rig.length[0];
        let payload = hook + state.payload.unit() * rig.rigging;
        worst = worst.max((hook - theirs[0]).norm()).max((payload - theirs[1]).norm());
    }
    println!("within {worst:e} m");
    assert!(worst < 1e-10, "{worst:e} m");
}

#[test]
fn a_free_swing_keeps_energy_and_amplitude() {
    for i in 0..4 {
        let mut next = spread(i);
        let masses = [1.0, 1.1 + next()];
        let still = Rig {
            masses,
            damping: 0.0,
            forces: [Vector::zeros(); 2],
            pivot: [Vector::zeros(); 3],
            length: [2.0, 0.0, 0.0],
            ..rig(&mut next)
        };
        let suspension = still.suspension();
        let (n, n_rate) = directions(&mut next);
        let mut x = pack(DoublePayload::started(&suspension, n, n_rate));
        let energy = |x: [Vector<f64>; 4]| {
            let state = unpack(x);
            let v = state.velocity(&suspension);
            let (r1, lower) = (state.hook.unit() * still.length[0], state.payload.unit() * still.rigging);
            let kinetic = 0.5 * (masses[0] * v.hook.norm_squared() + masses[1] * v.payload.norm_squared());
            kinetic - masses[0] * GRAVITY.dot(&r1) - masses[1] * GRAVITY.dot(&(r1 + lower))
        };
        let hanging = (masses[0] + masses[1]) * 9.81 * still.length[0] + masses[1] * 9.81 * still.rigging;
        let start = energy(x);
        // (1 − cos A) of the greatest energy.
        let wanted = (1.0 - (start + hanging) / hanging).max(-1.0).acos();
        for k in 0..25_000 {
            x = runge_kutta(x, f64::from(k) * DT, DT, |_, x| pack(unpack(x).rates(&suspension, still.pull(), 0.0)));
            assert!((energy(x) - start).abs() < 1e-9 * hanging, "swing {i} at {} s", f64::from(k) * DT);
            let amplitude = unpack(x).amplitude(&suspension, 9.81);
            assert!((amplitude.cos() - wanted.cos()).abs() < 1e-9, "swing {i}: {amplitude} and {wanted}");
        }
    }
}

#[test]
fn without_payload_the_hook_is_a_payload() {
    for i in 0..100 {
        let mut next = spread(i);
        let rig = rig(&mut next);
        let (n, n_rate) = directions(&mut next);
        let mut suspension = rig.suspension();
        suspension.mass_ratio = 0.0;
        let (_, v) = rig.placed(n, n_rate);
        let hook = Payload { direction: n[0], velocity: across(v[0], n[0]) };
        let double = DoublePayload { hook, payload: Payload { direction: n[1], velocity: across(v[1], n[1]) } };
        let single = hook.rates(&suspension.upper, GRAVITY, rig.damping);
        let found = double.rates(&suspension, [GRAVITY; 2], rig.damping);
        let error = |found: DoublePayload<f64>| {
            (found.hook.direction - single.direction).norm() + (found.hook.velocity - single.velocity).norm()
        };
        assert!(error(found) < 1e-13);
        assert!((double.amplitude(&suspension, 9.81) - hook.amplitude(&suspension.upper, 9.81)).abs() < 1e-13);
        // A light payload moves the hook as much as it is heavy.
        let [small, large] = [1e-6, 1e-3].map(|ratio| {
            let light = Rig { masses: [1.0, ratio], ..rig };
            error(light.state(n, v).rates(&light.suspension(), [GRAVITY; 2], rig.damping)) / ratio
        });
        assert!(small < 50.0 && (small - large).abs() < 0.1 * (1.0 + small), "{small} {large}");
    }
}

#[test]
fn errors_of_the_constraints_do_not_feed_themselves() {
    for i in 0..100 {
        let mut next = spread(i);
        let mut rig = rig(&mut next);
        let (n, n_rate) = directions(&mut next);
        // Even with the pivot moving along the cable.
        rig.pivot[1] += n[0] * 20.0;
        let (_, v) = rig.placed(n, n_rate);
        let clean = rig.state(n, v);
        let mut soiled = clean;
        let (sizes, along) = ([1.0 + 0.1 * next(), 1.0 + 0.1 * next()], [next(), next()]);
        for (k, one) in [&mut soiled.hook, &mut soiled.payload].into_iter().enumerate() {
            one.direction *= sizes[k];
            one.velocity += n[k] * along[k];
        }
        let (suspension, pull) = (rig.suspension(), rig.pull());
        let expected = clean.rates(&suspension, pull, rig.damping);
        let found = soiled.rates(&suspension, pull, rig.damping);
        // Far above the rounding of numbers that are of the size of v².
        let close = 1e-13 * rig.pivot[1].norm_squared();
        let pairs = [(found.hook, expected.hook), (found.payload, expected.payload)];
        for (k, (found, expected)) in pairs.into_iter().enumerate() {
            let turning = found.direction / sizes[k];
            assert!(turning.dot(&n[k]).abs() < close && (turning - expected.direction).norm() < close, "state {i}");
            assert!((found.velocity - turning * along[k] - expected.velocity).norm() < close, "state {i}");
        }
        assert!((soiled.amplitude(&suspension, 9.81) - clean.amplitude(&suspension, 9.81)).abs() < 1e-12);
    }
}
