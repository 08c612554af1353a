//! `BoomCrane` on a base at rest against the thesis's equations for small swing (2.15)–(2.16).

use crate::instance::{Instance, Set};
use crate::reference::Joint;

const GRAVITY: f64 = 9.81;
const BOOM: f64 = 12.0;
/// Communication step (s); the equations for small swing are integrated with the same.
const STEP: f64 = 2e-3;
const END: f64 = 9.0;

/// How slew, luff and hoist move.
struct Moves {
    slew: Joint,
    luff: Joint,
    hoist: Joint,
}

/// β̈ and φ̈ of (2.15) and (2.16), with their signs repaired: K = θ̇² + (r sin γ/l) γ̇² − (r cos γ/l) γ̈ − g/l;
///
/// β̈ = −2 (l̇/l) β̇ − 2 θ̇ φ̇ + K β − (2 θ̇ l̇/l + θ̈) φ − (r cos γ/l) θ̈ + (2 r sin γ/l) θ̇ γ̇,
/// φ̈ = −2 (l̇/l) φ̇ + 2 θ̇ β̇ + K φ + (2 θ̇ l̇/l + θ̈) β + (r cos γ/l)(θ̇² + γ̇²) + (r sin γ/l) γ̈.
fn change(moves: &Moves, t: f64, [beta, phi, beta_rate, phi_rate]: [f64; 4]) -> [f64; 4] {
    let ([slew, slewing], [luff, luffing]) = (moves.slew.rates(t), moves.luff.rates(t));
    let (l, hoist) = (moves.hoist.at(t), moves.hoist.rates(t)[0]);
    let (sin, cos) = moves.luff.at(t).sin_cos();
    let (up, out) = (BOOM * sin / l, BOOM * cos / l);
    let k = slew * slew + up * luff * luff - out * luffing - GRAVITY / l;
    let coupling = 2.0 * slew * hoist / l + slewing;
    [
        beta_rate,
        phi_rate,
        -2.0 * hoist / l * beta_rate - 2.0 * slew * phi_rate + k * beta - coupling * phi - out * slewing
            + 2.0 * up * slew * luff,
        -2.0 * hoist / l * phi_rate
            + 2.0 * slew * beta_rate
            + k * phi
            + coupling * beta
            + out * (slew * slew + luff * luff)
            + up * luffing,
    ]
}

/// One step of the classical Runge–Kutta method, whose error here is far below that of the held rates.
fn stepped(moves: &Moves, t: f64, x: [f64; 4]) -> [f64; 4] {
    let ahead = |x: [f64; 4], dx: [f64; 4], h: f64| std::array::from_fn(|i| x[i] + h * dx[i]);
    let a = change(moves, t, x);
    let b = change(moves, t + 0.5 * STEP, ahead(x, a, 0.5 * STEP));
    let c = change(moves, t + 0.5 * STEP, ahead(x, b, 0.5 * STEP));
    let d = change(moves, t + STEP, ahead(x, c, STEP));
    std::array::from_fn(|i| x[i] + STEP / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
}

/// The greatest swing, and the greatest difference of both models, for joints that slew and luff by so much.
fn compared(scale: f64) -> [f64; 2] {
    let moves = Moves {
        slew: Joint([0.5, 5.0, 0.0, 0.6 * scale]),
        luff: Joint([1.0, 6.0, 0.7, 0.7 + 0.3 * scale]),
        hoist: Joint([0.0, 8.0, 6.0, 9.0]),
    };
    let start = [0.05 * scale, -0.08 * scale, 0.0, 0.0];
    let mut crane = Instance::started(
        "BoomCrane",
        STEP,
        &[
            ("boom.length", Set::Real(BOOM)),
            ("luff.angle", Set::Real(0.7)),
            ("hoist.length", Set::Real(6.0)),
            ("swing.tangential_start", Set::Real(start[0])),
            ("swing.radial_start", Set::Real(start[1])),
        ],
    );
    let (mut x, mut swing, mut apart) = (start, 0.0_f64, 0.0_f64);
    while crane.time() < END {
        let (now, next) = (crane.time(), crane.time() + STEP);
        for (rate, joint) in [("slew.rate", &moves.slew), ("luff.rate", &moves.luff), ("hoist.rate", &moves.hoist)] {
            crane.set(rate, (joint.at(next) - joint.at(now)) / STEP).expect("a rate");
        }
        crane.step();
        x = stepped(&moves, now, x);
        let found = [crane.get("swing.tangential"), crane.get("swing.radial")];
        swing = swing.max(found[0].abs()).max(found[1].abs());
        apart = apart.max((found[0] - x[0]).abs()).max((found[1] - x[1]).abs());
    }
    [swing, apart]
}

/// What (2.15)–(2.16) leave out is of third order in swing and rates: a tenth of the motion leaves a thousandth of it.
#[test]
fn small_swing_follows_the_linearised_equations() {
    let [large, small] = [1.0, 0.1].map(compared);
    println!(
        "swing to {:.4} rad within {:.1e} rad, to {:.4} rad within {:.1e} rad",
        large[0], large[1], small[0], small[1]
    );
    assert!((0.1..0.5).contains(&large[0]), "{large:?}");
    assert!(small[1] < 2e-3 * large[1] && small[1] < 1e-3 * small[0], "{large:?} and {small:?}");
}
