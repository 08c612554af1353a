//! Shapers with humps: their conditions, checked from outside, what they tend to, and where they end.

use swayless_shaping::{DesignError, Kind, Sensitivity, Shaper, design, residual_vibration, sensitivity_curve};

use crate::extra_insensitive::minimum;
use crate::{LIMIT, designed, distance, mode, shaper};

/// Kinds with a limit, how many zeros they have, and what V is at the design frequency as a share of the limit.
const KINDS: [(Kind, usize, f64); 3] = [(Kind::TwoHumpEI, 3, 0.0), (Kind::ThreeHumpEI, 4, 1.0), (Kind::UMEI, 2, 1.0)];

/// Frequencies of the zeros of V, design frequency 1, from a fifth of it to twice.
fn zeros(shaper: &Shaper, zeta: f64) -> Vec<f64> {
    let curve: Vec<_> = sensitivity_curve(shaper, zeta, 0.2..=2.0, 1801).collect();
    let dips = curve.windows(3).filter(|v| v[1].vibration < v[0].vibration && v[1].vibration <= v[2].vibration);
    let refined = dips.map(|v| minimum(shaper, zeta, v[0].frequency, v[2].frequency));
    // V falls linearly to its zeros, so the search's 1e-13 of frequency leaves about that much vibration
    refined.filter(|(_, left)| *left < 1e-11).map(|(at, _)| at).collect()
}

/// The highest point between two zeros.
fn peak(shaper: &Shaper, zeta: f64, low: f64, high: f64) -> Sensitivity {
    let points = sensitivity_curve(shaper, zeta, low..=high, 2001);
    points.max_by(|a, b| a.vibration.total_cmp(&b.vibration)).expect("points")
}

#[test]
fn humps_peak_at_the_limit_between_zeros() {
    for (kind, count, share) in KINDS {
        for zeta in [0.0, 1e-6, 0.01, 0.05, 0.1, 0.15] {
            for limit in [0.001, 0.01, 0.05, 0.09] {
                let shaper = design(kind, mode(1.0, zeta), limit).unwrap();
                let what = format!("{kind}, ζ = {zeta}, V = {limit}");
                let zeros = zeros(&shaper, zeta);
                assert_eq!(zeros.len(), count, "{what}: {zeros:?}");
                for pair in zeros.windows(2) {
                    // of 2000 intervals, the nearest point is off the top by at most 3e-7 of the hump
                    let top = peak(&shaper, zeta, pair[0], pair[1]).vibration / limit;
                    assert!((top - 1.0).abs() < 1e-6, "{what}: {top}");
                }
                let at_design = residual_vibration(&shaper, 1.0, zeta);
                assert!((at_design - share * limit).abs() < 1e-12, "{what}: {at_design}");
                if share == 1.0 {
                    let [below, above] = [1.0 - 1e-5, 1.0 + 1e-5].map(|at| residual_vibration(&shaper, at, zeta));
                    assert!((above - below).abs() < 1e-12, "{what}: the hump of the design frequency peaks there");
                }
            }
        }
    }
}

#[test]
fn unity_magnitude_shaper_with_a_derivative_has_a_double_zero() {
    for zeta in [0.0, 1e-6, 0.01, 0.1, 0.3, 0.5, 0.7, 0.8] {
        let shaper = designed(Kind::UMZVD, 1.0, zeta);
        let beside = |step: f64| residual_vibration(&shaper, 1.0 + step, zeta);
        assert!(beside(0.0) < 1e-14, "ζ = {zeta}");
        for step in [1e-3, -1e-3] {
            let ratio = beside(2.0 * step) / beside(step);
            assert!((ratio - 4.0).abs() < 0.05, "ζ = {zeta}: V grows as the square, not {ratio}");
        }
    }
}

#[test]
fn small_limits_lead_to_the_shapers_without_vibration() {
    for zeta in [0.0, 0.01, 0.1, 0.3] {
        // amplitudes move with the square of the zeros' distance, V^(2/3) and V^(1/2); times and UMEI's with more
        for (kind, end, limit, change) in [
            (Kind::TwoHumpEI, Kind::ZVDD, 1e-12, 1e-7),
            (Kind::ThreeHumpEI, Kind::ZVDDD, 1e-12, 1e-5),
            (Kind::UMEI, Kind::UMZVD, 1e-12, 1e-11),
        ] {
            let end = designed(end, 1.0, zeta);
            let [none, little] = [0.0, limit].map(|limit| design(kind, mode(1.0, zeta), limit).unwrap());
            assert!(distance(&none, &end) < 1e-14, "{kind}, ζ = {zeta}");
            assert!(distance(&little, &end) < change, "{kind}, ζ = {zeta}: {}", distance(&little, &end));
        }
    }
}

#[test]
fn follow_damping_smoothly_as_far_as_they_go() {
    for (kind, limit, end) in [
        (Kind::TwoHumpEI, 0.05, 0.36),
        (Kind::TwoHumpEI, 0.1, 0.28),
        (Kind::ThreeHumpEI, 0.05, 0.26),
        (Kind::ThreeHumpEI, 0.1, 0.195),
        (Kind::UMZVD, 0.0, 0.8),
        (Kind::UMEI, 0.05, 0.6),
    ] {
        let mut before = design(kind, mode(1.0, 0.0), limit).unwrap();
        for step in 1..=100 {
            let zeta = end * f64::from(step) / 100.0;
            let here = design(kind, mode(1.0, zeta), limit).unwrap();
            let change = distance(&before, &here);
            assert!(change < 10.0 * end / 100.0, "{kind}, ζ = {zeta}: {change}");
            before = here;
        }
    }
}

#[test]
fn say_so_where_there_is_no_solution_and_where_the_last_one_is() {
    for (kind, limit, last) in [
        (Kind::TwoHumpEI, 0.05, 0.385),
        (Kind::TwoHumpEI, 0.1, 0.302),
        (Kind::ThreeHumpEI, 0.05, 0.273),
        (Kind::ThreeHumpEI, 0.1, 0.205),
        (Kind::UMZVD, 0.05, 0.871),
        (Kind::UMEI, 0.05, 0.713),
    ] {
        let error = design(kind, mode(1.0, 0.9), limit).unwrap_err();
        let DesignError::NoSolution { nearest_damping_ratio: Some(nearest), .. } = error else { panic!("{error}") };
        assert!((nearest / last - 1.0).abs() < 0.04, "{kind}: {nearest}");
        assert!(design(kind, mode(1.0, nearest), limit).is_ok(), "{kind}: {nearest}");
        let text = error.to_string();
        assert!(text.contains(kind.name()) && text.contains("0.9") && text.contains(&nearest.to_string()), "{text}");
        assert_eq!(text.contains("limit"), kind != Kind::UMZVD, "{text}");
    }
}

#[test]
fn published_fits_of_the_unity_magnitude_shapers_are_near() {
    let powers = |z: f64, c: [f64; 4]| c[0] + z * (c[1] + z * (c[2] + z * c[3]));
    let fits = [
        (
            Kind::UMZVD,
            [
                [0.08945, 0.28411, 0.23013, 0.16401],
                [0.36613, -0.08833, 0.24048, 0.17001],
                [0.64277, 0.29103, 0.23262, 0.43784],
                [0.73228, 0.00992, 0.49385, 0.38633],
            ],
        ),
        (
            Kind::UMEI,
            [
                [0.09374, 0.31903, 0.13582, 0.65274],
                [0.36798, -0.05894, 0.13641, 0.63266],
                [0.64256, 0.28595, 0.26334, 0.24999],
                [0.73664, 0.00162, 0.52749, 0.19208],
            ],
        ),
    ];
    for (kind, fit) in fits {
        for zeta in [0.0, 0.02, 0.05, 0.1, 0.2] {
            let time = |index: usize| mode(1.0, zeta).period() * powers(zeta, fit[index]);
            let fitted = shaper([(0.0, 1.0), (time(0), -1.0), (time(1), 1.0), (time(2), -1.0), (time(3), 1.0)]);
            let error = distance(&designed(kind, 1.0, zeta), &fitted);
            assert!(error < 1e-3, "{kind}, ζ = {zeta}: {error:e}, limit {LIMIT}");
        }
    }
}
