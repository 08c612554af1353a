//! Calls that must be refused, with which status and what message; and what the instance is afterwards.

use swayless_export::abi::fmi3::{DISCARD, ERROR, FATAL, OK};
use swayless_export::{fmi2, fmi3};

use crate::ball::Ball;
use crate::host::Host;

#[test]
fn parameters_out_of_range_are_all_named_when_initialization_ends() {
    let ball = Host::co_simulation();
    assert_eq!(ball.set("gravity", -1.0), OK);
    assert_eq!(ball.set("restitution", 2.0), OK);
    assert_eq!(ball.enter_initialization(), OK);
    assert_eq!(ball.exit_initialization(), ERROR);
    let message = ball.last_message();
    assert!(message.contains("gravity is -1; it must be at least 0.1 m/s2"), "{message}");
    assert!(message.contains("restitution is 2; it must lie between 0 and 1"), "{message}");
    assert_eq!(ball.step(0.0, 0.1), ERROR);
    assert_eq!(ball.reset(), OK);
    ball.initialize();
    assert_eq!(ball.step(0.0, 0.1), OK);
}

#[test]
fn an_input_that_is_no_number_discards_the_step_and_changes_nothing() {
    let (ball, twin) = (Host::co_simulation(), Host::co_simulation());
    ball.initialize();
    twin.initialize();
    assert_eq!((ball.step(0.0, 0.1), twin.step(0.0, 0.1)), (OK, OK));
    for wrong in [f64::NAN, f64::INFINITY] {
        assert_eq!(ball.set("push", wrong), OK);
        assert_eq!(ball.step(0.1, 0.1), DISCARD);
        assert!(ball.last_message().contains("input push is"), "{}", ball.last_message());
        assert_eq!(ball.get("height").to_bits(), twin.get("height").to_bits());
    }
    assert_eq!(ball.set("push", 0.0), OK);
    assert_eq!((ball.step(0.1, 0.1), twin.step(0.1, 0.1)), (OK, OK));
    assert_eq!(ball.get("height").to_bits(), twin.get("height").to_bits());
}

#[test]
fn a_step_that_fails_gives_everything_back() {
    let (ball, twin) = (Host::co_simulation(), Host::co_simulation());
    for host in [&ball, &twin] {
        assert_eq!(host.set("tick", 100.0), OK);
        host.initialize();
    }
    // Up through ticks to where no number goes, after some 10⁴ s.
    assert_eq!(ball.set("push", 1e300), OK);
    assert_eq!(ball.step(0.0, 1e10), DISCARD, "{}", ball.last_message());
    assert!(ball.log.iter().filter(|(_, category, _)| category == "logEvents").count() > 100);
    assert_eq!(ball.integer("ticks"), 0);
    assert_eq!((ball.set("push", 0.0), ball.set("push", 0.0)), (OK, OK));
    for n in 0..10 {
        let t = f64::from(n) * 0.1;
        assert_eq!((ball.step(t, 0.1), twin.step(t, 0.1)), (OK, OK), "{:?}", ball.log);
        assert_eq!(ball.get("height").to_bits(), twin.get("height").to_bits());
        assert_eq!(ball.integer("bounces"), twin.integer("bounces"));
    }
    assert_eq!((ball.step(1.0, 249.5), twin.step(1.0, 249.5)), (OK, OK), "{:?}", ball.last_message());
    assert_eq!((ball.integer("ticks"), twin.integer("ticks")), (2, 2));
}

#[test]
fn fixed_and_tunable_parameters_differ_after_initialization() {
    let ball = Host::co_simulation();
    ball.initialize();
    assert_eq!(ball.set("restitution", 0.25), OK);
    assert_eq!(ball.set("restitution", 1.5), DISCARD);
    assert_eq!(ball.get("restitution"), 0.25);
    assert_eq!(ball.set("gravity", 1.0), ERROR);
    assert!(ball.last_message().contains("gravity cannot be set"), "{}", ball.last_message());
}

#[test]
fn the_communication_point_may_differ_in_its_last_bits_only() {
    let ball = Host::co_simulation();
    ball.initialize();
    assert_eq!(ball.step(0.0, 0.1), OK);
    assert_eq!(ball.step(0.1 + 1e-13, 0.1), OK);
    assert_eq!(ball.step(0.3, 0.1), ERROR);
    assert!(ball.last_message().contains("0.3"), "{}", ball.last_message());
}

#[test]
fn a_step_needs_a_begin_a_length_and_an_end() {
    for (t, h) in [0.0, -0.1, f64::NAN, f64::INFINITY].map(|h| (0.0, h)).into_iter().chain([(f64::INFINITY, 0.1)]) {
        let ball = Host::co_simulation();
        ball.initialize();
        assert_eq!(ball.step(t, h), ERROR);
    }
    let ball = Host::co_simulation();
    // SAFETY: an instance.
    let status = unsafe { fmi3::fmi3EnterInitializationMode::<Ball>(ball.instance, 0, 0.0, f64::MAX, 0, 0.0) };
    assert_eq!((status, ball.exit_initialization()), (OK, OK));
    assert_eq!(ball.step(f64::MAX, f64::MAX), ERROR);
}

/// Models rely on what has been checked: they are not asked before.
#[test]
fn outputs_of_wrong_start_values_are_discarded_until_they_are_right() {
    let ball = Host::co_simulation();
    let clearance = ball.reference("clearance");
    let read = |ball: &Host| {
        let mut value = f64::NAN;
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3GetFloat64::<Ball>(ball.instance, &clearance, 1, &mut value, 1) }
    };
    assert_eq!(ball.enter_initialization(), OK);
    assert_eq!((ball.set("gravity", -1.0), read(&ball)), (OK, DISCARD));
    assert!(ball.last_message().contains("gravity is -1"), "{}", ball.last_message());
    assert_eq!(ball.get("gravity"), -1.0, "what was set can be read all the same");
    assert_eq!((ball.set("gravity", 9.81), ball.set("push", f64::NAN), read(&ball)), (OK, OK, DISCARD));
    assert_eq!((ball.set("push", 0.0), read(&ball), ball.exit_initialization()), (OK, OK, OK));
}

#[test]
fn a_wrong_type_or_item_is_an_error() {
    let ball = Host::co_simulation();
    assert_eq!(ball.set("number", 1.0), ERROR);
    assert_eq!(ball.reset(), OK);
    assert_eq!(ball.set_item("ground", 3), ERROR);
    assert_eq!(ball.reset(), OK);
    assert_eq!(ball.set_item("ground", i64::MAX), ERROR);
    assert_eq!(ball.reset(), OK);
    assert_eq!(ball.set("clearance", 1.0), ERROR);
    assert!(ball.last_message().contains("calculated"), "{}", ball.last_message());
}

#[test]
fn a_panic_is_fatal_and_the_host_lives() {
    let ball = Host::co_simulation();
    assert_eq!(ball.set_boolean("panics", true), OK);
    ball.initialize();
    assert_eq!(ball.step(0.0, 1.0), FATAL);
    let (status, category, text) = ball.log.last().unwrap();
    assert_eq!((*status, category.as_str()), (FATAL, "logStatusFatal"));
    assert!(text.contains("the ball panics"), "{text}");
    assert_eq!(ball.reset(), ERROR);
}

#[test]
fn what_is_not_offered_is_refused() {
    let ball = Host::co_simulation();
    ball.initialize();
    // SAFETY: an instance.
    assert_eq!(unsafe { fmi3::fmi3EnterConfigurationMode::<Ball>(ball.instance) }, ERROR);
}

#[test]
fn errors_are_logged_even_when_logging_is_off() {
    let ball = Host::co_simulation();
    // SAFETY: an instance and no categories.
    assert_eq!(unsafe { fmi3::fmi3SetDebugLogging::<Ball>(ball.instance, 0, 0, std::ptr::null()) }, OK);
    ball.initialize();
    assert_eq!(ball.step(0.0, 0.5), OK);
    assert!(ball.log.is_empty());
    assert_eq!(ball.step(9.0, 0.5), ERROR);
    assert_eq!(ball.log.len(), 1);
    let unknown = c"logNonsense".as_ptr();
    // SAFETY: an instance and one category.
    assert_eq!(unsafe { fmi3::fmi3SetDebugLogging::<Ball>(ball.instance, 1, 1, &unknown) }, ERROR);
}

#[test]
fn after_a_failed_initialization_no_model_is_evaluated_with_what_it_refuses() {
    let ball = Host::co_simulation();
    assert_eq!(ball.enter_initialization(), OK);
    assert_eq!(ball.get("energy"), 9.81);
    assert_eq!(ball.set("gravity", -1.0), OK);
    assert_eq!(ball.exit_initialization(), ERROR);
    let (reference, mut value) = (ball.reference("energy"), 0.0);
    // SAFETY: one reference and one value.
    let status = unsafe { fmi3::fmi3GetFloat64::<Ball>(ball.instance, &reference, 1, &mut value, 1) };
    assert_eq!(status, ERROR);
    assert!(ball.last_message().contains("initialized"), "{}", ball.last_message());
    assert_eq!(ball.get("gravity"), -1.0, "what has been set can be seen");
}

#[test]
fn a_call_that_is_discarded_sets_nothing() {
    let ball = Host::co_simulation();
    ball.initialize();
    let references = [ball.reference("push"), ball.reference("restitution")];
    // SAFETY: an instance, which is the same in both versions, two references and two values.
    let statuses = unsafe {
        [
            fmi3::fmi3SetFloat64::<Ball>(ball.instance, references.as_ptr(), 2, [1.0, 7.0].as_ptr(), 2),
            fmi2::fmi2SetReal::<Ball>(ball.instance, references.as_ptr(), 2, [1.0, 7.0].as_ptr()),
        ]
    };
    assert_eq!(statuses, [DISCARD; 2]);
    assert!(ball.last_message().contains("restitution is 7"), "{}", ball.last_message());
    assert_eq!((ball.get("push"), ball.get("restitution")), (0.0, 0.5));
}
