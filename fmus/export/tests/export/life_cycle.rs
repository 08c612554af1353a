//! The life cycle: instantiation, model exchange, reset, independence of instances, and FMI 2.0 beside FMI 3.0.

use std::ffi::CString;
use std::ptr::{null, null_mut};

use swayless_export::abi::fmi2 as abi2;
use swayless_export::abi::fmi3::{ERROR, OK};
use swayless_export::{fmi2, fmi3};

use crate::ball::Ball;
use crate::host::Host;

#[test]
fn a_wrong_token_or_an_empty_name_makes_no_instance() {
    let token = CString::new(Host::co_simulation().description.instantiation_token.clone()).unwrap();
    // SAFETY: texts that end with a NUL, or NULL.
    unsafe {
        let make =
            |name, token| fmi3::fmi3InstantiateModelExchange::<Ball>(name, token, null(), 0, 0, null_mut(), None);
        assert!(make(c"ball".as_ptr(), c"{nonsense}".as_ptr()).is_null());
        assert!(make(c"ball".as_ptr(), null()).is_null());
        assert!(make(c"".as_ptr(), token.as_ptr()).is_null());
        assert!(make(null(), token.as_ptr()).is_null());
        let made = make(c"ball".as_ptr(), token.as_ptr());
        assert!(!made.is_null());
        fmi3::fmi3FreeInstance::<Ball>(made);
    }
}

/// Runs 1 s and returns what there is to see.
fn run(ball: &Host) -> Vec<u64> {
    ball.initialize();
    let mut seen = Vec::new();
    for n in 0..50 {
        assert_eq!(ball.step(f64::from(n) * 0.02, 0.02), OK, "{:?}", ball.log);
        seen.extend([ball.get("height").to_bits(), ball.get("energy").to_bits()]);
    }
    seen
}

#[test]
fn reset_is_like_new_also_after_an_error() {
    let ball = Host::co_simulation();
    assert_eq!(ball.set("height", 2.5), OK);
    let high = run(&ball);
    assert_eq!(ball.step(0.5, 0.1), ERROR);
    assert_eq!(ball.reset(), OK);
    let again = run(&ball);
    assert_ne!(high, again);
    assert_eq!(again, run(&Host::co_simulation()));
}

#[test]
fn instances_do_not_know_of_each_other() {
    let alone = run(&Host::co_simulation());
    let together: Vec<_> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..4).map(|_| scope.spawn(|| run(&Host::co_simulation()))).collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).collect()
    });
    assert!(together.iter().all(|seen| *seen == alone));
}

#[test]
fn model_exchange_goes_through_its_modes() {
    let ball = Host::model_exchange();
    ball.initialize();
    let mut flags = [9u8; 5];
    let mut next = f64::NAN;
    // SAFETY: an instance, and places of the sizes announced.
    unsafe {
        let [a, b, c, d, e] = &mut flags;
        let status = fmi3::fmi3UpdateDiscreteStates::<Ball>(ball.instance, a, b, c, d, e, &mut next);
        assert_eq!((status, flags), (OK, [0; 5]));
        let mut x = [0.0; 2];
        // Setting the states is for Continuous-Time Mode.
        assert_eq!(fmi3::fmi3EnterContinuousTimeMode::<Ball>(ball.instance), OK);
        assert_eq!(fmi3::fmi3GetContinuousStates::<Ball>(ball.instance, x.as_mut_ptr(), 2), OK);
        assert_eq!(x, [1.0, 0.0]);
        assert_eq!(fmi3::fmi3SetTime::<Ball>(ball.instance, 0.5), OK);
        assert_eq!(fmi3::fmi3SetContinuousStates::<Ball>(ball.instance, [-0.1, -3.0].as_ptr(), 2), OK);
        let mut dx = [0.0; 2];
        assert_eq!(fmi3::fmi3GetContinuousStateDerivatives::<Ball>(ball.instance, dx.as_mut_ptr(), 2), OK);
        assert_eq!(dx, [-3.0, -9.81]);
        let mut z = [0.0];
        assert_eq!(fmi3::fmi3GetEventIndicators::<Ball>(ball.instance, z.as_mut_ptr(), 1), OK);
        assert_eq!(z, [-0.1]);
        assert_eq!(fmi3::fmi3EnterEventMode::<Ball>(ball.instance), OK);
        let [a, b, c, d, e] = &mut flags;
        assert_eq!(fmi3::fmi3UpdateDiscreteStates::<Ball>(ball.instance, a, b, c, d, e, &mut next), OK);
        assert_eq!(flags, [0, 0, 0, 1, 0], "the states have jumped");
        assert_eq!(fmi3::fmi3GetContinuousStates::<Ball>(ball.instance, x.as_mut_ptr(), 2), OK);
        assert_eq!(x, [0.0, 1.5]);
        // A continuous input may change between events, a discrete one not.
        assert_eq!(fmi3::fmi3EnterContinuousTimeMode::<Ball>(ball.instance), OK);
        assert_eq!(ball.set("push", 1.0), OK);
        assert_eq!(ball.get("acceleration"), -8.81);
        assert_eq!(ball.set("floor", 1.0), OK, "importers apply all their signals while they integrate");
        assert_eq!(ball.get("floor"), 0.0);
        assert!(ball.last_message().contains("floor keeps its value"), "{}", ball.last_message());
    }
    // Co-simulation's call in model exchange.
    let ball = Host::model_exchange();
    ball.initialize();
    assert_eq!(ball.step(0.0, 0.1), ERROR);
}

#[test]
fn fmi2_gives_the_same_numbers() {
    let expected = run(&Host::co_simulation());
    let host = Host::co_simulation();
    let token = CString::new(host.description.instantiation_token.clone()).unwrap();
    let (height, energy) = (host.reference("height"), host.reference("energy"));
    let mut seen = Vec::new();
    // SAFETY: texts, an instance, and arrays of the sizes announced.
    unsafe {
        let resources = c"file:////nowhere/resources".as_ptr();
        let ball = fmi2::fmi2Instantiate::<Ball>(
            c"ball".as_ptr(),
            abi2::CO_SIMULATION,
            token.as_ptr(),
            resources,
            null(),
            1,
            1,
        );
        assert!(!ball.is_null());
        assert_eq!(fmi2::fmi2SetupExperiment::<Ball>(ball, 1, 1e-10, 0.0, 0, 0.0), OK);
        assert_eq!(fmi2::fmi2EnterInitializationMode::<Ball>(ball), OK);
        assert_eq!(fmi2::fmi2ExitInitializationMode::<Ball>(ball), OK);
        for n in 0..50 {
            assert_eq!(fmi2::fmi2DoStep::<Ball>(ball, f64::from(n) * 0.02, 0.02, 1), OK);
            let mut values = [0.0; 2];
            assert_eq!(fmi2::fmi2GetReal::<Ball>(ball, [height, energy].as_ptr(), 2, values.as_mut_ptr()), OK);
            seen.extend(values.map(f64::to_bits));
        }
        assert_eq!(fmi2::fmi2Terminate::<Ball>(ball), OK);
        assert_eq!(fmi2::fmi2DoStep::<Ball>(ball, 1.0, 0.02, 1), ERROR);
        fmi2::fmi2FreeInstance::<Ball>(ball);
    }
    assert_eq!(seen, expected);
}

#[test]
fn what_has_been_set_can_be_read_before_initialization() {
    // PyFMI's users do; FMI 3.0 has start values there.
    let ball = Host::co_simulation();
    assert_eq!((ball.get("gravity"), ball.get("push"), ball.get("height")), (9.81, 0.0, 1.0));
    assert_eq!((ball.set("gravity", 1.6), ball.set("height", 2.0)), (OK, OK));
    assert_eq!((ball.get("gravity"), ball.get("height")), (1.6, 2.0));
    ball.initialize();
    assert_eq!((ball.get("gravity"), ball.get("height")), (1.6, 2.0));
    assert_eq!(ball.reset(), OK);
    let (energy, mut value) = (ball.reference("energy"), 0.0);
    // SAFETY: one reference and one value.
    let status = unsafe { fmi3::fmi3GetFloat64::<Ball>(ball.instance, &energy, 1, &mut value, 1) };
    assert_eq!(status, ERROR, "what is calculated has no value yet");
}

#[test]
fn importers_of_fmi2_enter_event_mode_after_initialization_and_ask_for_nominals_before() {
    // OpenModelica does the first; FMI 2.0.5, 3.2.3, has both in its table of allowed calls.
    let ball = Host::model_exchange();
    let mut nominals = [0.0; 2];
    // SAFETY: an instance, which is the same in both versions, and room for two values.
    unsafe {
        let status = fmi2::fmi2GetNominalsOfContinuousStates::<Ball>(ball.instance, nominals.as_mut_ptr(), 2);
        assert_eq!((status, nominals), (OK, [1.0; 2]));
    }
    ball.initialize();
    // SAFETY: an instance.
    assert_eq!(unsafe { fmi2::fmi2EnterEventMode::<Ball>(ball.instance) }, OK, "{:?}", ball.log);
    assert_eq!(ball.update(), None);
}
