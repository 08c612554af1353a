//! Callbacks from which the importer calls back: intermediate updates of co-simulation and news of clocks in scheduled
//! execution. What they may do is done, and what they may not is tried; valgrind watches.

use std::cell::Cell;
use std::ffi::{CString, c_void};
use std::ptr::{null, null_mut};

use swayless_abi::fmi3::*;
use swayless_modeldesc::types::{Causality, DataType, IntervalVariability, Variability, Variable};

use super::library::Subject;

/// What the callbacks know.
struct Importer<'a> {
    f: &'a Functions,
    subject: &'a Subject,
    instance: Cell<Instance>,
    calls: Cell<u32>,
    /// From this call on they do what is forbidden.
    rude_from: u32,
}

impl Importer<'_> {
    fn references(&self, fits: impl Fn(&Variable) -> bool) -> Vec<ValueReference> {
        self.subject.description.variables.iter().filter(|v| fits(v)).map(|v| v.value_reference).collect()
    }

    fn floats(&self, causality: Causality) -> Vec<ValueReference> {
        let continuous = |v: &Variable| v.data_type == DataType::Float64 && v.variability == Variability::Continuous;
        self.references(|v| continuous(v) && v.causality == causality && v.dimensions.is_empty())
    }

    /// Everything that ends an instance, which a callback must not do.
    unsafe fn be_rude(&self) {
        let (f, i) = (self.f, self.instance.get());
        let mut state = null_mut();
        // SAFETY: an instance within its own callback; the places are locals.
        unsafe {
            assert_eq!(f.fmi3GetFMUState.expect("a function")(i, &mut state), ERROR);
            assert_eq!(f.fmi3ActivateModelPartition.expect("a function")(i, 0, 0.0), ERROR);
            f.fmi3FreeInstance.expect("a function")(i);
            assert_eq!(f.fmi3Reset.expect("a function")(i), OK);
        }
    }
}

unsafe extern "C" fn intermediate(
    environment: InstanceEnvironment,
    time: Float64,
    _set: Boolean,
    _get: Boolean,
    _finished: Boolean,
    may_return: Boolean,
    early: *mut Boolean,
    at: *mut Float64,
) {
    // SAFETY: the environment is an `Importer` that outlives the instance; the places are the FMU's.
    unsafe {
        let importer = &*environment.cast::<Importer<'_>>();
        let (f, i, call) = (importer.f, importer.instance.get(), importer.calls.get());
        importer.calls.set(call + 1);
        let outputs = importer.floats(Causality::Output);
        let mut values = vec![0.0; outputs.len()];
        let status = f.fmi3GetFloat64.expect("a function")(
            i,
            outputs.as_ptr(),
            outputs.len(),
            values.as_mut_ptr(),
            values.len(),
        );
        assert_eq!(status, OK);
        let inputs = importer.floats(Causality::Input);
        let moved = vec![1e-3 * (1.0 + f64::from(call % 3)); inputs.len()];
        let set = f.fmi3SetFloat64.expect("a function");
        assert_eq!(set(i, inputs.as_ptr(), inputs.len(), moved.as_ptr(), moved.len()), OK);
        if may_return != 0 && call % 5 == 4 {
            (*early, *at) = (1, time);
        }
        if call >= importer.rude_from {
            importer.be_rude();
        }
    }
}

unsafe extern "C" fn news(environment: InstanceEnvironment) {
    // SAFETY: the environment is an `Importer` that outlives the instance.
    unsafe {
        let importer = &*environment.cast::<Importer<'_>>();
        let (f, i, call) = (importer.f, importer.instance.get(), importer.calls.get());
        importer.calls.set(call + 1);
        let is = |v: &Variable, variability| v.clock.is_some_and(|clock| clock.interval_variability == variability);
        for clock in importer.references(|v| is(v, IntervalVariability::Triggered)) {
            assert_eq!(f.fmi3GetClock.expect("a function")(i, &clock, 1, &mut 0), OK);
        }
        for clock in importer.references(|v| is(v, IntervalVariability::Countdown)) {
            let get = f.fmi3GetIntervalDecimal.expect("a function");
            assert_eq!(get(i, &clock, 1, &mut 0.0, &mut 0), OK);
        }
        if call >= importer.rude_from {
            f.fmi3FreeInstance.expect("a function")(i);
        }
    }
}

/// Steps and partitions with callbacks; at the end the callbacks do what they must not.
pub fn play(subject: &Subject) {
    let Some(f) = subject.functions3() else { return };
    let token = CString::new(subject.description.instantiation_token.clone()).expect("no NUL");
    let clocked = subject.description.variables.iter().any(|v| v.clock.is_some());
    for rude_from in [u32::MAX, 7] {
        let importer = Importer { f, subject, instance: Cell::new(null_mut()), calls: Cell::new(0), rude_from };
        let environment: *mut c_void = (&raw const importer).cast_mut().cast();
        // SAFETY: texts that end with a NUL, and an importer that outlives the instance.
        let instance = unsafe {
            let (name, token) = (c"called back".as_ptr(), token.as_ptr());
            if clocked {
                let make = f.fmi3InstantiateScheduledExecution.expect("a function");
                make(name, token, null(), 0, 0, environment, None, Some(news), None, None)
            } else {
                let make = f.fmi3InstantiateCoSimulation.expect("a function");
                make(name, token, null(), 0, 0, 0, 1, null(), 0, environment, None, Some(intermediate))
            }
        };
        assert!(!instance.is_null());
        importer.instance.set(instance);
        // SAFETY: an instance until it is freed, and places that are locals.
        unsafe {
            assert_eq!(f.fmi3EnterInitializationMode.expect("a function")(instance, 0, 0.0, 0.0, 0, 0.0), OK);
            assert_eq!(f.fmi3ExitInitializationMode.expect("a function")(instance), OK);
            if clocked {
                partitions(&importer)
            } else {
                steps(&importer)
            }
            f.fmi3FreeInstance.expect("a function")(instance);
        }
    }
}

/// Steps to 1 s, or until one fails.
unsafe fn steps(importer: &Importer<'_>) {
    let step = importer.f.fmi3DoStep.expect("a function");
    let (mut time, mut event, mut end, mut early) = (0.0, 0, 0, 0);
    for _ in 0..100 {
        let from = time;
        // SAFETY: an instance, and places that are locals.
        let status =
            unsafe { step(importer.instance.get(), from, 0.1, 0, &mut event, &mut end, &mut early, &mut time) };
        if importer.calls.get() > importer.rude_from {
            assert_eq!(status, ERROR, "a callback did what it must not");
            return;
        }
        assert_eq!(status, OK);
        if time >= 1.0 {
            break;
        }
    }
    assert!(importer.calls.get() > 0 && importer.rude_from == u32::MAX);
}

/// Every partition, many times.
unsafe fn partitions(importer: &Importer<'_>) {
    let activate = importer.f.fmi3ActivateModelPartition.expect("a function");
    let clocks = importer.references(|v| v.data_type == DataType::Clock && v.causality == Causality::Input);
    let scalar = |v: &Variable| v.data_type == DataType::Float64 && v.dimensions.is_empty();
    let signals = importer.references(|v| scalar(v) && v.causality == Causality::Input);
    for k in 0..60_u32 {
        let values = vec![f64::from(k % 20) - 10.0; signals.len()];
        // SAFETY: an instance, and arrays that are as long as announced.
        unsafe {
            let set = importer.f.fmi3SetFloat64.expect("a function");
            assert_eq!(
                set(importer.instance.get(), signals.as_ptr(), signals.len(), values.as_ptr(), values.len()),
                OK
            );
            for clock in &clocks {
                assert_eq!(activate(importer.instance.get(), *clock, 0.05 * f64::from(k)), OK);
            }
        }
    }
    // There is news where the FMU ticks a clock itself, or says when it is due.
    let news =
        |clock: IntervalVariability| [IntervalVariability::Triggered, IntervalVariability::Countdown].contains(&clock);
    let has_news = !importer.references(|v| v.clock.is_some_and(|clock| news(clock.interval_variability))).is_empty();
    assert_eq!(importer.calls.get() > 1, has_news, "{} times news of clocks", importer.calls.get());
}
