//! Directional and adjoint derivatives against derivatives by hand.

use swayless_export::abi::fmi2 as abi2;
use swayless_export::abi::fmi3::{ERROR, OK};
use swayless_export::{fmi2, fmi3};

use crate::ball::Ball;
use crate::host::Host;

type Function =
    unsafe fn(*mut std::ffi::c_void, *const u32, usize, *const u32, usize, *const f64, usize, *mut f64, usize) -> i32;

fn derivative(
    host: &Host,
    function: Function,
    unknowns: &[&str],
    knowns: &[&str],
    seed: &[f64],
    n: usize,
) -> Option<Vec<f64>> {
    let references = |names: &[&str]| names.iter().map(|name| host.reference(name)).collect::<Vec<_>>();
    let (unknowns, knowns) = (references(unknowns), references(knowns));
    let mut sensitivity = vec![f64::NAN; n];
    // SAFETY: an instance, and arrays of the sizes announced.
    let status = unsafe {
        function(
            host.instance,
            unknowns.as_ptr(),
            unknowns.len(),
            knowns.as_ptr(),
            knowns.len(),
            seed.as_ptr(),
            seed.len(),
            sensitivity.as_mut_ptr(),
            n,
        )
    };
    assert!(status == OK || status == ERROR);
    (status == OK).then_some(sensitivity)
}

/// A ball on its way down with 2 m/s at 3 m.
fn falling() -> Host {
    let ball = Host::co_simulation();
    assert_eq!((ball.set("height", 3.0), ball.set("velocity", -2.0), ball.set("gravity", 10.0)), (OK, OK, OK));
    ball.initialize();
    ball
}

#[test]
fn directional_derivatives_are_those_by_hand() {
    let ball = falling();
    let forward = fmi3::fmi3GetDirectionalDerivative::<Ball>;
    let unknowns = ["der(height)", "der(velocity)", "acceleration", "clearance", "energy", "height"];
    let of = |known: &str| derivative(&ball, forward, &unknowns, &[known], &[1.0], 6).unwrap();
    assert_eq!(of("height"), [0.0, 0.0, 0.0, 1.0, 10.0, 1.0]);
    assert_eq!(of("velocity"), [1.0, 0.0, 0.0, 0.0, -2.0, 0.0]);
    assert_eq!(of("push"), [0.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    assert_eq!(of("gravity"), [0.0, -1.0, -1.0, 0.0, 3.0, 0.0]);
    let both = derivative(&ball, forward, &["energy"], &["height", "velocity"], &[2.0, -1.0], 1);
    assert_eq!(both.unwrap(), [22.0]);
    // An array is as many knowns as it has elements.
    assert_eq!(derivative(&ball, forward, &["energy"], &["weights"], &[1.0, 1.0, 1.0], 1).unwrap(), [0.0]);
}

#[test]
fn adjoint_derivatives_are_the_transposed_ones() {
    let ball = falling();
    let backward = fmi3::fmi3GetAdjointDerivative::<Ball>;
    let found =
        derivative(&ball, backward, &["energy", "acceleration"], &["height", "velocity", "push"], &[1.0, 5.0], 3);
    assert_eq!(found.unwrap(), [10.0, -2.0, 5.0]);
}

#[test]
fn in_initialization_mode_start_values_are_known() {
    let ball = Host::co_simulation();
    assert_eq!((ball.enter_initialization(), ball.set("height", 3.0)), (OK, OK));
    let forward = fmi3::fmi3GetDirectionalDerivative::<Ball>;
    assert_eq!(derivative(&ball, forward, &["energy"], &["height"], &[1.0], 1).unwrap(), [9.81]);
}

#[test]
fn what_has_no_derivative_is_refused() {
    let forward = fmi3::fmi3GetDirectionalDerivative::<Ball>;
    for (unknowns, knowns, seed, n) in [
        (["surface"], ["height"], vec![1.0], 1),
        (["energy"], ["energy"], vec![1.0], 1),
        (["energy"], ["number"], vec![1.0], 1),
        (["energy"], ["weights"], vec![1.0], 1),
        (["energy"], ["height"], vec![1.0], 2),
    ] {
        let ball = falling();
        assert_eq!(derivative(&ball, forward, &unknowns, &knowns, &seed, n), None, "{unknowns:?} {knowns:?}");
        assert!(!ball.last_message().is_empty());
    }
}

#[test]
fn fmi2_gives_the_same() {
    let ball = falling();
    let (energy, height) = (ball.reference("energy"), ball.reference("height"));
    let mut found = 0.0;
    // SAFETY: an instance, which is the same in both versions, and arrays of the sizes announced.
    let status: abi2::Status =
        unsafe { fmi2::fmi2GetDirectionalDerivative::<Ball>(ball.instance, &energy, 1, &height, 1, &2.0, &mut found) };
    assert_eq!((status, found), (abi2::OK, 20.0));
}

#[test]
fn output_derivatives_are_those_over_time() {
    let ball = falling();
    assert_eq!((ball.set("push", 4.0), ball.step(0.0, 0.25)), (OK, OK));
    let names = ["height", "clearance", "energy", "acceleration"];
    let references = names.map(|name| ball.reference(name));
    let mut found = [f64::NAN; 4];
    let read = fmi3::fmi3GetOutputDerivatives::<Ball>;
    // SAFETY: an instance, and arrays of the sizes announced.
    unsafe {
        assert_eq!(read(ball.instance, references.as_ptr(), 4, [1; 4].as_ptr(), found.as_mut_ptr(), 4), OK);
        let velocity = ball.get("velocity");
        assert!((velocity + 2.0 + 6.0 * 0.25).abs() < 1e-13);
        // d(½v² + gh)/dt = v (v̇ + g), the power of the push.
        assert_eq!(found[..2], [velocity, velocity]);
        assert!((found[2] - 4.0 * velocity).abs() < 1e-12 && found[3] == 0.0, "{found:?}");
        assert_eq!(read(ball.instance, references.as_ptr(), 4, [2; 4].as_ptr(), found.as_mut_ptr(), 4), ERROR);
    }
}

/// Sets derivatives of the push by FMI 2.0; the instance is the same in both versions.
fn push_course(ball: &Host, orders: &[i32], values: &[f64]) -> i32 {
    let references = vec![ball.reference("push"); orders.len()];
    // SAFETY: an instance, and arrays of the sizes announced.
    unsafe {
        fmi2::fmi2SetRealInputDerivatives::<Ball>(
            ball.instance,
            references.as_ptr(),
            orders.len(),
            orders.as_ptr(),
            values.as_ptr(),
        )
    }
}

#[test]
fn inputs_move_within_a_step_as_their_derivatives_say() {
    let ball = falling();
    assert_eq!(ball.set("push", 4.0), OK);
    assert_eq!(push_course(&ball, &[1, 2], &[3.0, -12.0]), abi2::OK);
    assert_eq!(ball.step(0.0, 0.5), OK);
    // v̇ = −10 + 4 + 3t − 6t², so v = −2 − 6t + 1.5t² − 2t³ and h = 3 − 2t − 3t² + 0.5t³ − 0.5t⁴.
    let t: f64 = 0.5;
    assert!((ball.get("velocity") - (-2.0 - 6.0 * t + 1.5 * t * t - 2.0 * t.powi(3))).abs() < 1e-14);
    let height = 3.0 - 2.0 * t - 3.0 * t * t + 0.5 * t.powi(3) - 0.5 * t.powi(4);
    assert!((ball.get("height") - height).abs() < 1e-14);
    // The input is where it got to, and stays there.
    let push = 4.0 + 3.0 * t - 6.0 * t * t;
    assert!((ball.get("push") - push).abs() < 1e-15);
    let velocity = ball.get("velocity");
    assert_eq!(ball.step(0.5, 0.125), OK);
    assert!((ball.get("velocity") - (velocity + (push - 10.0) * 0.125)).abs() < 1e-14);
    assert!((ball.get("push") - push).abs() < 1e-15);
}

#[test]
fn only_continuous_inputs_have_derivatives_to_set() {
    let ball = falling();
    assert_eq!(push_course(&ball, &[1], &[f64::NAN]), abi2::DISCARD);
    let (floor, one) = (ball.reference("floor"), 1.0);
    // SAFETY: an instance, and one value each.
    let status = unsafe { fmi2::fmi2SetRealInputDerivatives::<Ball>(ball.instance, &floor, 1, &1, &one) };
    assert_eq!(status, abi2::ERROR);
    assert!(ball.last_message().contains("floor has no derivative"), "{}", ball.last_message());
    // Orders that no importer means would make a step take as long as they are high.
    for order in [0, -1, 21, i32::MAX] {
        let ball = falling();
        assert_eq!(push_course(&ball, &[order], &[1.0]), abi2::ERROR);
    }
}
