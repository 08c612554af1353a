//! Structural parameters: arrays and states of another length, before and while the simulation runs.

use std::ptr::null_mut;

use swayless_export::abi::fmi3::{DISCARD, ERROR, OK};
use swayless_export::{fmi2, fmi3};

use crate::chain::Chain;
use crate::host::{CO_SIMULATION, Host, Interface, Wish};

impl Host<Chain> {
    fn enter_configuration(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3EnterConfigurationMode::<Chain>(self.instance) }
    }

    fn exit_configuration(&self) -> i32 {
        // SAFETY: an instance.
        unsafe { fmi3::fmi3ExitConfigurationMode::<Chain>(self.instance) }
    }

    fn set_count(&self, count: u64) -> i32 {
        // SAFETY: one reference and one value.
        unsafe { fmi3::fmi3SetUInt64::<Chain>(self.instance, &self.reference("count"), 1, &count, 1) }
    }

    fn resize(&self, count: u64) {
        assert_eq!(self.enter_configuration(), OK, "{:?}", self.log);
        assert_eq!(self.set_count(count), OK, "{:?}", self.log);
        assert_eq!(self.exit_configuration(), OK, "{:?}", self.log);
    }

    fn levels<const N: usize>(&self) -> (i32, [f64; N]) {
        let mut levels = [f64::NAN; N];
        let level = self.reference("level");
        // SAFETY: one reference and room for as many values as are announced.
        let status = unsafe { fmi3::fmi3GetFloat64::<Chain>(self.instance, &level, 1, levels.as_mut_ptr(), N) };
        (status, levels)
    }

    fn state_count(&self) -> usize {
        let mut n = usize::MAX;
        // SAFETY: an instance and a place.
        assert_eq!(unsafe { fmi3::fmi3GetNumberOfContinuousStates::<Chain>(self.instance, &mut n) }, OK);
        n
    }
}

fn is_near<const N: usize>(found: (i32, [f64; N]), expected: [f64; N]) {
    assert_eq!(found.0, OK);
    let near = found.1.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9);
    assert!(near, "{found:?} for {expected:?}");
}

#[test]
fn states_come_and_go_while_the_simulation_runs() {
    let host = Host::<Chain>::new(CO_SIMULATION);
    host.initialize();
    assert_eq!(host.step(0.0, 0.5), OK);
    is_near(host.levels(), [0.5, 9.0]);
    // One that comes begins with its start value; the others go on.
    host.resize(3);
    is_near(host.levels(), [0.5, 9.0, 100.0]);
    assert_eq!(host.step(0.5, 0.25), OK);
    is_near(host.levels(), [0.25, 8.5, 99.0]);
    host.resize(1);
    is_near(host.levels(), [0.25]);
    assert_eq!(host.step(0.75, 0.125), OK);
    host.resize(2);
    is_near(host.levels(), [0.125, 10.0]);
    assert_eq!(host.levels::<3>().0, ERROR);
}

#[test]
fn model_exchange_counts_its_states_anew() {
    let host = Host::<Chain>::new(Wish { interface: Interface::ModelExchange, ..CO_SIMULATION });
    assert_eq!(host.state_count(), 2);
    host.resize(1);
    assert_eq!(host.state_count(), 1);
    host.initialize();
    host.update();
    host.resize(3);
    assert_eq!(host.state_count(), 3);
    let (mut x, mut dx) = ([0.0; 3], [0.0; 3]);
    // SAFETY: an instance and room for three values.
    unsafe {
        assert_eq!(fmi3::fmi3GetContinuousStates::<Chain>(host.instance, x.as_mut_ptr(), 3), OK);
        assert_eq!(fmi3::fmi3GetContinuousStateDerivatives::<Chain>(host.instance, dx.as_mut_ptr(), 3), OK);
    }
    assert_eq!((x, dx), ([1.0, 10.0, 100.0], [-1.0, -2.0, -4.0]));
}

#[test]
fn lengths_stay_within_their_room() {
    for wrong in [0, 4, u64::MAX] {
        let host = Host::<Chain>::new(CO_SIMULATION);
        assert_eq!(host.enter_configuration(), OK);
        assert_eq!(host.set_count(wrong), DISCARD);
        assert!(host.last_message().contains("count"), "{}", host.last_message());
        assert_eq!(host.exit_configuration(), OK);
        host.initialize();
        is_near(host.levels(), [1.0, 10.0]);
    }
}

#[test]
fn a_state_taken_in_reconfiguration_goes_on_to_the_same() {
    let host = Host::<Chain>::new(CO_SIMULATION);
    host.initialize();
    assert_eq!(host.step(0.0, 0.5), OK);
    host.resize(1);
    assert_eq!(host.enter_configuration(), OK);
    assert_eq!(host.set_count(2), OK);
    let mut state = null_mut();
    // SAFETY: an instance and a place.
    assert_eq!(unsafe { fmi3::fmi3GetFMUState::<Chain>(host.instance, &mut state) }, OK);
    assert_eq!(host.exit_configuration(), OK);
    is_near(host.levels(), [0.5, 10.0]);
    // SAFETY: a state of this instance.
    assert_eq!(unsafe { fmi3::fmi3SetFMUState::<Chain>(host.instance, state) }, OK);
    assert_eq!(host.exit_configuration(), OK);
    is_near(host.levels(), [0.5, 10.0]);
    // SAFETY: a state of this instance, not used again.
    assert_eq!(unsafe { fmi3::fmi3FreeFMUState::<Chain>(host.instance, &mut state) }, OK);
    // A simulation may end in Reconfiguration Mode.
    assert_eq!(host.enter_configuration(), OK);
    // SAFETY: an instance.
    assert_eq!(unsafe { fmi3::fmi3Terminate::<Chain>(host.instance) }, OK);
    is_near(host.levels(), [0.5, 10.0]);
}

#[test]
fn elements_that_are_not_there_have_no_derivatives_in_fmi2() {
    let host = Host::<Chain>::new(CO_SIMULATION);
    host.initialize();
    let (level, inflow, mut answer) = (host.reference("der(level)"), host.reference("inflow"), 0.0);
    // SAFETY: an instance, which is the same in both versions, and one value each.
    let mut ask = |element: u32| unsafe {
        let unknown = level + element;
        fmi2::fmi2GetDirectionalDerivative::<Chain>(host.instance, &unknown, 1, &inflow, 1, &1.0, &mut answer)
    };
    assert_eq!([ask(0), ask(1), ask(2)], [OK, OK, ERROR]);
}
