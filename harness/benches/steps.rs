//! One `doStep` of 10 ms of every built FMU, in both FMI versions, with inputs held and with inputs that change.
//!
//! Run `swayless build` first. `SWAYLESS_FMUS` names another folder than `target/fmus`.

mod built;

use std::cell::RefCell;

use built::{Built, built};
use divan::Bencher;
use swayless::Fmu;
use swayless::slave::{Experiment, Model, Slave};
use swayless_modeldesc::types::{Causality, DataType};

const STEP_SIZE: f64 = 0.01;
/// A change every second, as an operator's hand may do.
const STEPS_PER_CHANGE: u32 = 100;

fn main() {
    divan::main();
}

/// An instance that is stepped on and on.
struct Stepped {
    slave: Box<dyn Slave>,
    inputs: Vec<u32>,
    values: Vec<f64>,
    step: u32,
}

impl Stepped {
    fn new(built: &Built) -> Self {
        let fmu = Fmu::open(&built.0).expect("an FMU of ours opens");
        let mut slave = fmu.instantiate("bench", false).expect("an FMU of ours has an instance");
        let experiment = Experiment { start_time: 0.0, stop_time: 1e9, tolerance: None };
        slave.enter_initialization_mode(&experiment).expect("initialization begins");
        slave.exit_initialization_mode().expect("initialization ends");
        let inputs: Vec<_> = fmu
            .description()
            .variables
            .iter()
            .filter(|v| v.causality == Causality::Input && v.data_type == DataType::Float64 && v.dimensions.is_empty())
            // Lengths are no commands: a hoist of 0 m is nothing to measure.
            // In FMI 2.0 the elements of an array stand for themselves.
            .filter(|v| {
                v.name.split('[').next().is_some_and(|name| name.ends_with("command") || name.ends_with("rate"))
            })
            .map(|v| v.value_reference)
            .collect();
        let values = vec![0.0; inputs.len()];
        Self { slave, inputs, values, step: 0 }
    }

    fn step(&mut self) {
        self.slave.do_step(f64::from(self.step) * STEP_SIZE, STEP_SIZE).expect("a step succeeds");
        self.step += 1;
    }

    fn step_with_changes(&mut self) {
        if self.step.is_multiple_of(STEPS_PER_CHANGE) {
            // Back and forth, so that nothing runs away.
            let sign = if (self.step / STEPS_PER_CHANGE).is_multiple_of(2) { 1.0 } else { -1.0 };
            self.values.fill(0.01 * sign);
        }
        self.slave.set_float(DataType::Float64, &self.inputs, &self.values).expect("inputs are set");
        self.step();
    }
}

#[divan::bench(args = built())]
fn held(bencher: Bencher, built: &Built) {
    let stepped = RefCell::new(Stepped::new(built));
    bencher.bench_local(|| stepped.borrow_mut().step());
}

#[divan::bench(args = built())]
fn changing(bencher: Bencher, built: &Built) {
    let stepped = RefCell::new(Stepped::new(built));
    bencher.bench_local(|| stepped.borrow_mut().step_with_changes());
}

/// A step of InputShaper, of a ramp whose every step is a change with a train of ZV: so many impulses are on their way, and one
/// falls due in each step; with none the command is held.
#[divan::bench(args = [0, 10, 100, 1000])]
fn shaping(bencher: Bencher, live: u32) {
    let built = built().into_iter().find(|built| built.to_string() == "fmi3/InputShaper").expect("it is built");
    let fmu = Fmu::open(&built.0).expect("an FMU of ours opens");
    let reference = |name: &str| {
        let variable = fmu.description().variables.iter().find(|v| v.name == name).expect("a variable");
        variable.value_reference
    };
    let mut slave = fmu.instantiate("bench", false).expect("an FMU of ours has an instance");
    // Half a period of ZV is as long as the steps whose second impulses are on their way.
    let frequency = std::f64::consts::PI / (STEP_SIZE * (f64::from(live) + 0.5));
    slave.set_float(DataType::Float64, &[reference("mode.frequency")], &[frequency, 0.0]).expect("a frequency");
    let experiment = Experiment { start_time: 0.0, stop_time: 1e9, tolerance: None };
    slave.enter_initialization_mode(&experiment).expect("initialization begins");
    slave.exit_initialization_mode().expect("initialization ends");
    let command = reference("command");
    let mut step = 0;
    let mut next = move || {
        if live > 0 {
            slave.set_float(DataType::Float64, &[command], &[1e-3 * f64::from(step)]).expect("a command");
        }
        slave.do_step(f64::from(step) * STEP_SIZE, STEP_SIZE).expect("a step succeeds");
        step += 1;
    };
    (0..2 * live).for_each(|_| next());
    bencher.bench_local(next);
}
