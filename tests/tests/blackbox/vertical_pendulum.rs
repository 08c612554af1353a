//! `VerticalPendulum` against the closed forms of thesis 2.5 (corrected) and numbers computed independently.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, PI};

use serde_json::Value as Json;

use crate::instance::{Instance, Set};
use crate::packaged;

const GRAVITY: f64 = 9.81;
const LENGTH: f64 = 0.5;
/// Swing that is small: its square is what the linear equations leave out.
const SMALL: f64 = 1e-4;

/// A pendulum that is stepped by any size.
struct Pendulum {
    instance: Instance,
    time: f64,
}

impl Pendulum {
    fn started(values: &[(&str, Set<'_>)]) -> Self {
        Self { instance: Instance::started("VerticalPendulum", 1.0, values), time: 0.0 }
    }

    fn swung(swing: f64, rate: f64) -> Self {
        Self::started(&[("swing_start", swing.into()), ("swing.rate_start", rate.into())])
    }

    fn advance(&mut self, duration: f64) {
        self.instance.slave.do_step(self.time, duration).expect("a step");
        self.time += duration;
    }

    fn accelerate(&mut self, acceleration: f64) {
        self.instance.set("acceleration", acceleration).expect("an acceleration");
    }

    fn get(&mut self, name: &str) -> f64 {
        self.instance.get(name)
    }

    /// The next turning point of the swing: the top of a parabola through samples.
    fn turning_point(&mut self) -> f64 {
        let step = 0.002;
        let mut sample = || {
            self.advance(step);
            self.get("swing")
        };
        let [mut a, mut b, mut c] = [sample(), sample(), sample()];
        while (b - a) * (c - b) > 0.0 {
            [a, b, c] = [b, c, sample()];
        }
        (b - (c - a) * (c - a) / (8.0 * (c - 2.0 * b + a))).abs()
    }
}

#[track_caller]
fn close(found: f64, wanted: f64, tolerance: f64) {
    assert!((found - wanted).abs() <= tolerance, "{found}, wanted {wanted}");
}

fn rows(of: &str) -> Vec<Vec<f64>> {
    let data = packaged::data("vertical_pendulum.json");
    let numbers = |row: &Json| row.as_array().expect("a row").iter().map(|n| n.as_f64().expect("a number")).collect();
    data[of].as_array().expect("rows").iter().map(numbers).collect()
}

fn omega(acceleration: f64) -> f64 {
    ((GRAVITY + acceleration) / LENGTH).sqrt()
}

/// (2.37), and the energy of swing of any size.
#[test]
fn a_free_pendulum_follows_the_closed_form_and_keeps_its_energy() {
    let (swing, rate) = (SMALL, -2.0 * SMALL);
    let mut small = Pendulum::swung(swing, rate);
    let mut large = Pendulum::swung(2.5, 1.0);
    let amplitude = large.get("swing.amplitude");
    for _ in 0..100 {
        small.advance(0.1);
        large.advance(0.1);
        let (sin, cos) = (omega(0.0) * small.time).sin_cos();
        close(small.get("swing"), rate / omega(0.0) * sin + swing * cos, 1e-9);
        let half = (0.5 * large.get("swing")).sin();
        let kinetic = large.get("swing.rate").powi(2) * LENGTH / (4.0 * GRAVITY);
        close(half * half + kinetic, (0.5 * amplitude).sin().powi(2), 1e-8);
        close(large.get("swing.amplitude"), amplitude, 1e-7);
    }
}

/// d is 2ζω: the envelope falls with exp(−d t/2).
#[test]
fn damping_takes_the_swing_away() {
    let damping = 2.0 * 0.05 * omega(0.0);
    let mut pendulum = Pendulum::started(&[("swing_start", SMALL.into()), ("swing.damping", damping.into())]);
    let damped = omega(0.0) * (1.0_f64 - 0.05 * 0.05).sqrt();
    for _ in 0..50 {
        pendulum.advance(0.1);
        let (sin, cos) = (damped * pendulum.time).sin_cos();
        let envelope = SMALL * (-0.5 * damping * pendulum.time).exp();
        close(pendulum.get("swing"), envelope * (cos + 0.5 * damping / damped * sin), 1e-10);
    }
}

/// (2.36), fig. 2.21: three samples of a harmonic swing give its frequency, cos ωh = (y₀ + y₂)/(2 y₁).
#[test]
fn an_acceleration_changes_the_frequency_as_in_figure_2_21() {
    const STEP: f64 = 0.1;
    for row in rows("fig2.21: acceleration/g, frequency ratio") {
        let mut pendulum = Pendulum::swung(SMALL, 0.0);
        pendulum.accelerate(row[0] * GRAVITY);
        let [first, middle, last] = [(); 3].map(|()| {
            let swing = pendulum.get("swing");
            pendulum.advance(STEP);
            swing
        });
        let found = ((first + last) / (2.0 * middle)).acos() / STEP;
        close(found / omega(0.0), row[1], 1e-6);
    }
}

/// (2.41)–(2.45), fig. 2.22: half a g upwards from a time on, for small swing and for 30°.
#[test]
fn a_step_of_acceleration_shrinks_the_swing_as_in_figure_2_22() {
    let period_of = |swing: f64| {
        // The arithmetic-geometric mean: exact for a pendulum of any amplitude.
        let (mut a, mut b) = (1.0, (0.5 * swing).cos());
        for _ in 0..6 {
            (a, b) = (0.5 * (a + b), (a * b).sqrt());
        }
        2.0 * PI / (omega(0.0) * a)
    };
    for row in rows("fig2.22: step time/period, amplitude ratio small, amplitude ratio of pi/6") {
        for (swing, wanted) in [(SMALL, row[1]), (FRAC_PI_6, row[2])] {
            let mut pendulum = Pendulum::swung(swing, 0.0);
            if row[0] > 0.0 {
                pendulum.advance(row[0] * period_of(swing));
            }
            pendulum.accelerate(0.5 * GRAVITY);
            // The integrator's error of 1e-10 is 1e-6 of the small swing.
            close(pendulum.turning_point() / swing, wanted, 1e-7 + 1e-10 / swing);
        }
    }
}

/// (2.53)–(2.60): a pulse upwards of quarter periods from the lowest point, or downwards from the highest.
#[test]
fn a_pulse_of_acceleration_shrinks_the_swing_by_the_ratio_of_frequencies() {
    let natural = omega(0.0);
    for row in rows("2.58-2.60: acceleration/g, quarter periods, swing, rate, amplitude") {
        let acceleration = row[0] * GRAVITY;
        let mut pendulum =
            if acceleration > 0.0 { Pendulum::swung(0.0, SMALL * natural) } else { Pendulum::swung(SMALL, 0.0) };
        if row[1] > 0.0 {
            pendulum.accelerate(acceleration);
            pendulum.advance(row[1] * FRAC_PI_2 / omega(acceleration));
            pendulum.accelerate(0.0);
        }
        close(pendulum.get("swing") / SMALL, row[2], 1e-6);
        close(pendulum.get("swing.rate") / (SMALL * natural), row[3], 1e-6);
        close(pendulum.get("swing.amplitude") / SMALL, row[4], 1e-6);
        // (2.59) and (2.60) with their signs: the swing afterwards, from t₂ on.
        let (swing, rate) = (row[2] * SMALL, row[3] * SMALL * natural);
        let end = pendulum.time;
        for _ in 0..10 {
            pendulum.advance(0.07);
            let (sin, cos) = (natural * (pendulum.time - end)).sin_cos();
            close(pendulum.get("swing"), swing * cos + rate / natural * sin, 1e-6 * SMALL);
        }
    }
}

fn rig<'a>(more: &[(&'a str, f64)]) -> Vec<(&'a str, Set<'static>)> {
    let mut values = vec![("rig.enabled", Set::Switch(true))];
    values.extend(more.iter().map(|(name, value)| (*name, Set::Real(*value))));
    values
}

/// (2.39) and (2.40), and the closed form on the way.
#[test]
fn the_counterweight_raises_the_cart() {
    let data = packaged::data("vertical_pendulum.json");
    let number = |json: &Json| json.as_f64().expect("a number");
    let given = &data["2.39: M, m, b, t, z"];
    let [heavy, light, friction, time, height] = [0, 1, 2, 3, 4].map(|i| number(&given[i]));
    let values = [("rig.counterweight_mass", heavy), ("rig.mass", light), ("rig.friction", friction)];
    let mut cart = Pendulum::started(&rig(&values));
    // Without effect while the rig is on.
    cart.accelerate(5.0);
    let (a, d) = (friction / (heavy + light), (heavy - light) * GRAVITY / (heavy + light));
    for _ in 0..10 {
        cart.advance(0.1 * time);
        let t = cart.time;
        close(cart.get("cart.z"), d / (a * a) * ((-a * t).exp() + a * t - 1.0), 1e-9);
        close(cart.get("cart.acceleration"), d * (-a * t).exp(), 1e-9);
    }
    close(cart.get("cart.z"), height, 1e-9);
    close(cart.get("cart.velocity") / time, number(&data["2.40: average acceleration"]), 1e-9);
}

/// Without friction the masses alone decide: the relation behind Table 2.4.
#[test]
fn the_cart_accelerates_by_the_ratio_of_its_masses() {
    for row in rows("table 2.4, without friction: M/m, acceleration/g") {
        let values = [("rig.counterweight_mass", 2.5 * row[0]), ("rig.mass", 2.5), ("rig.friction", 0.0)];
        // Away from the ends of its travel, at which a cart that is pulled against them rests.
        let mut cart = Pendulum::started(&rig(&[&values[..], &[("cart.z", 0.6)]].concat()));
        close(cart.get("cart.acceleration"), row[1] * GRAVITY, 1e-14);
    }
}

/// At the end of its travel the cart stops dead, which is the limit of braking it ever faster.
#[test]
fn a_stop_is_the_limit_of_hard_braking() {
    const SWING: f64 = 0.6;
    // Without friction: z̈ = g/5 over 1.3 m.
    let start = [("rig.counterweight_mass", 3.0), ("rig.mass", 2.0), ("rig.friction", 0.0)];
    let lift = GRAVITY / 5.0;
    let arrival = (2.0 * 1.3 / lift).sqrt();
    let mut cart = Pendulum::started(&rig(&[&start[..], &[("swing_start", SWING)]].concat()));
    cart.advance(arrival - 1e-6);
    assert!(!cart.instance.get_switch("at_limit"));
    let before = cart.get("swing.rate");
    cart.advance(2e-6);
    assert!(cart.instance.get_switch("at_limit"));
    assert_eq!([cart.get("cart.z"), cart.get("cart.velocity"), cart.get("cart.acceleration")], [1.3, 0.0, 0.0]);
    let stopped = cart.get("swing.rate");
    assert!((stopped - before).abs() > 0.5, "the stop is felt: from {before} to {stopped} rad/s");

    // The same cart, braked by its input within a time that is ten times shorter from one to the next.
    let braked = [3e-2, 3e-3].map(|duration| {
        let mut cart = Pendulum::swung(SWING, 0.0);
        cart.accelerate(lift);
        cart.advance(arrival);
        cart.accelerate(-lift * arrival / duration);
        cart.advance(duration);
        close(cart.get("cart.velocity"), 0.0, 1e-9);
        (cart.get("swing.rate") - stopped).abs()
    });
    assert!(braked[0] < 0.3 && braked[1] < 0.12 * braked[0], "{braked:?} rad/s away");

    // It rests there, and the pendulum swings freely.
    let amplitude = cart.get("swing.amplitude");
    for _ in 0..30 {
        cart.advance(0.1);
        close(cart.get("swing.amplitude"), amplitude, 1e-8);
    }
    assert_eq!(cart.get("cart.z"), 1.3);
    assert!(cart.instance.get_switch("at_limit"));
}

/// A light counterweight leaves the cart below or lets it down; against it the cart can only be thrown.
#[test]
fn the_cart_rests_where_the_heavier_side_pulls_it() {
    let light = [("rig.counterweight_mass", 2.0), ("rig.friction", 0.0)];
    let mut below = Pendulum::started(&rig(&[&light[..], &[("swing_start", SMALL)]].concat()));
    assert!(below.instance.get_switch("at_limit"));
    below.advance(0.3);
    close(below.get("swing"), SMALL * (omega(0.0) * 0.3).cos(), 1e-10);
    assert_eq!(below.get("cart.z"), 0.0);

    let fall = GRAVITY * 0.5 / 4.5;
    let mut falling = Pendulum::started(&rig(&[&light[..], &[("cart.z", 1.3)]].concat()));
    falling.advance(1.0);
    close(falling.get("cart.z"), 1.3 - 0.5 * fall, 1e-10);
    falling.advance(1.0);
    assert_eq!([falling.get("cart.z"), falling.get("cart.velocity")], [0.0, 0.0]);

    // Thrown up to where it turns, then through to the stop above, from which it falls again.
    for (speed, top) in [(1.0, 0.5 / fall), (3.0, 1.3)] {
        let mut thrown = Pendulum::started(&rig(&[&light[..], &[("cart.velocity", speed)]].concat()));
        let mut highest = 0.0_f64;
        for _ in 0..2000 {
            thrown.advance(0.002);
            highest = highest.max(thrown.get("cart.z"));
        }
        close(highest, top, 1e-5);
        assert!(thrown.instance.get_switch("at_limit"));
        assert_eq!(thrown.get("cart.z"), 0.0);
    }
}

#[test]
fn what_is_beyond_physics_is_cut_and_told() {
    let mut pendulum = Pendulum::swung(0.3, 0.0);
    pendulum.accelerate(1e300);
    pendulum.advance(0.01);
    assert!(pendulum.instance.get_switch("at_limit"));
    close(pendulum.get("cart.velocity"), 10.0, 1e-9);
    pendulum.accelerate(0.0);
    pendulum.advance(0.01);
    assert!(!pendulum.instance.get_switch("at_limit"));
    let mut stuck = Pendulum::started(&rig(&[("rig.friction", 1e9)]));
    stuck.advance(1.0);
    assert!(stuck.instance.get_switch("at_limit"));
    assert!(stuck.get("cart.velocity").abs() < 1e-2);
}
