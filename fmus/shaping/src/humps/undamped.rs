//! The trains without damping, in closed form where there is one.

use std::f64::consts::{PI, TAU};

use super::{Design, Form, IMPULSES};
use crate::Kind;

/// The angle, in half turns, whose cosine is that much less than 1.
fn angle(one_less_cosine: f64) -> f64 {
    2.0 * (0.5 * one_less_cosine).sqrt().asin() / PI
}

fn half_periods(amplitudes: [f64; IMPULSES]) -> Design {
    Design { phases: std::array::from_fn(|k| k as f64 * PI), amplitudes, ..Design::default() }
}

/// a, ½ − a, ½ − a, a with a = (3X² + 2X + 3V²)/(16X), X = (V²(√(1 − V²) + 1))^⅓.
pub(super) fn two_hump(v: f64) -> Option<Design> {
    let x = (v * v * ((1.0 - v * v).sqrt() + 1.0)).cbrt();
    let over = 3.0 * (x * x + v * v) / (4.0 * x); // 4a − ½
    let a = (over + 0.5) / 4.0;
    let s = v.cbrt();
    let (zero, peak) = (angle(over / (2.0 * a)) / s, angle(over / (6.0 * a)) / s);
    let train = half_periods([a, 0.5 - a, 0.5 - a, a, 0.0]);
    Some(Design { zeros: [-zero, 0.0, zero, 0.0], peaks: [-peak, peak, 0.0], ..train })
}

/// a, b, 1 − 2a − 2b, b, a with a = (1 + 3V + 2√(2(V² + V)))/16, b = (1 − V)/4.
pub(super) fn three_hump(v: f64) -> Option<Design> {
    let root = (0.5 * (v * v + v)).sqrt();
    let a = (1.0 + 3.0 * v + 4.0 * root) / 16.0;
    let b = (1.0 - v) / 4.0;
    let s = v.sqrt().sqrt();
    let at = |offset: f64| angle((v + root + offset * (a * v).sqrt()) / (4.0 * a)) / s;
    let (inner, peak, outer) = (at(-2.0), at(0.0), at(2.0));
    let train = half_periods([a, b, 1.0 - 2.0 * (a + b), b, a]);
    Some(Design { zeros: [-outer, -inner, inner, outer], peaks: [-peak, 0.0, peak], ..train })
}

/// Follows the solution from V = 0, where its times are known well enough for Newton's method.
pub(super) fn unity(v: f64) -> Option<Design> {
    let form = Form { kind: Kind::UMEI, impulses: 5, unity: true, zeros: 2 };
    let start = Design {
        phases: [0.0, 0.0895, 0.3662, 0.6430, 0.7325].map(|share| share * TAU),
        amplitudes: [1.0, -1.0, 1.0, -1.0, 1.0],
        zeros: [-0.5, 0.5, 0.0, 0.0],
        ..Design::default()
    };
    let start = form.newton(&form.pack(&start), 0.0, 0.0)?;
    form.follow(form.unpack(&start), v, |limit| (0.0, limit)).ok()
}
