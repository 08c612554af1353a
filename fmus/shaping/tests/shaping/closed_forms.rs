//! The closed forms as the literature prints them, written out.

use std::f64::consts::{PI, TAU};

use swayless_shaping::{Kind, Shaper, design, residual_vibration};

use crate::{designed, distance, mode, shaper};

/// Both sides are sums and products of a few rounded numbers.
const EXACT: f64 = 1e-14;

const DAMPING: [f64; 8] = [0.0, 1e-9, 0.01, 0.1, 0.2, 0.3, 0.7, 0.99];

#[test]
fn zero_vibration_shapers_with_damping() {
    for zeta in DAMPING {
        for omega in [1e-3, 0.7, 1.0, 1.759, 40.0] {
            let k = (-zeta * PI / (1.0 - zeta * zeta).sqrt()).exp();
            let td = TAU / (omega * (1.0 - zeta * zeta).sqrt());
            let (d2, d3) = ((1.0 + k).powi(2), (1.0 + k).powi(3));
            let expected: [(Kind, Shaper); 3] = [
                (Kind::ZV, shaper([(0.0, 1.0 / (1.0 + k)), (td / 2.0, k / (1.0 + k))])),
                (Kind::ZVD, shaper([(0.0, 1.0 / d2), (td / 2.0, 2.0 * k / d2), (td, k * k / d2)])),
                (
                    Kind::ZVDD,
                    shaper([
                        (0.0, 1.0 / d3),
                        (td / 2.0, 3.0 * k / d3),
                        (td, 3.0 * k * k / d3),
                        (1.5 * td, k.powi(3) / d3),
                    ]),
                ),
            ];
            for (kind, expected) in expected {
                let error = distance(&designed(kind, omega, zeta), &expected);
                assert!(error < EXACT, "{kind} at ζ = {zeta}, ω = {omega}: {error:e}");
            }
        }
    }
}

#[test]
fn undamped_extra_insensitive() {
    for v in [0.0, 1e-6, 0.05, 0.1, 0.5, 0.99] {
        let expected = shaper([(0.0, (1.0 + v) / 4.0), (PI, (1.0 - v) / 2.0), (TAU, (1.0 + v) / 4.0)]);
        assert!(distance(&design(Kind::EI, mode(1.0, 0.0), v).unwrap(), &expected) < EXACT, "V = {v}");
    }
}

#[test]
fn undamped_unity_magnitude() {
    let expected = shaper([(0.0, 1.0), (TAU / 6.0, -1.0), (TAU / 3.0, 1.0)]);
    assert!(distance(&designed(Kind::UMZV, 1.0, 0.0), &expected) < EXACT);
}

#[test]
fn unity_magnitude_with_damping_closes_its_triangle() {
    for zeta in [1e-9, 0.01, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99] {
        let shaper = designed(Kind::UMZV, 1.0, zeta);
        let [first, second, third] = *shaper.impulses() else { panic!("three impulses") };
        assert_eq!([first.amplitude, second.amplitude, third.amplitude], [1.0, -1.0, 1.0]);
        // 1 − e^{s̄t₂} + e^{s̄t₃}, scaled by e^{−ζωt₃} so that its terms stay of order one
        let damped = (1.0 - zeta * zeta).sqrt();
        let term = |time: f64| {
            let size = (zeta * (time - third.time)).exp();
            (size * (damped * time).cos(), size * (damped * time).sin())
        };
        let (one, two, three) = (term(0.0), term(second.time), term(third.time));
        let residual = (one.0 - two.0 + three.0).hypot(one.1 - two.1 + three.1);
        assert!(residual < 1e-14, "ζ = {zeta}: {residual:e}");
    }
}

#[test]
fn nothing_jumps_where_damping_begins() {
    for kind in Kind::OF_A_MODE {
        // the times and amplitudes change by at most 4ζ near ζ = 0
        let error = distance(&designed(kind, 1.0, 0.0), &designed(kind, 1.0, 1e-12));
        assert!(error < 1e-11, "{kind}: {error:e}");
    }
}

#[test]
fn no_shaping_is_one_impulse() {
    assert_eq!(designed(Kind::None, 3.0, 0.1), Shaper::unshaped());
    assert_eq!((Shaper::unshaped().duration(), Shaper::unshaped().sum()), (0.0, 1.0));
}

/// Without damping UMZV leaves V = |2cos(kπ/3) − 1| of the k-th multiple of its frequency: nothing where k is 6n ± 1, and three times
/// what no shaping leaves where it is an odd multiple of 3 — of the ninth, too, which thesis 5.3.3 has among those it cancels.
#[test]
fn harmonics_of_unity_magnitude() {
    let umzv = designed(Kind::UMZV, 1.3, 0.0);
    for multiple in 1..=27_u32 {
        let left = residual_vibration(&umzv, 1.3 * f64::from(multiple), 0.0);
        let expected = match multiple % 6 {
            1 | 5 => 0.0,
            3 => 3.0,
            2 | 4 => 2.0,
            _ => 1.0,
        };
        assert!((left - expected).abs() < 1e-12, "{multiple}: {left}");
    }
}
