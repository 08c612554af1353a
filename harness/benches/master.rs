//! The master's overhead per FMU and step, and the real-time factor of the example.
//!
//! Run `swayless build` first; without built FMUs only the foreign one is measured. `SWAYLESS_FMUS` names another folder
//! than `target/fmus`.

mod bare;
#[path = "../tests/common/mod.rs"]
#[allow(clippy::unwrap_used, reason = "shared with the tests, which fail by panicking")]
mod common;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use bare::Bare;
use divan::Bencher;
use divan::counter::ItemsCount;
use swayless::{Fmu, Options, System, simulate};
use swayless_modeldesc::types::FmiVersion;

const STEPS: u32 = 2000;
const STEP_SIZE: f64 = 0.01;
const STOP_TIME: f64 = STEPS as f64 * STEP_SIZE;

fn main() {
    println!("master against a bare loop over the same C functions, time per FMU and step:");
    for (name, pair) in [("foreign FMU", foreign()), ("VectorDrive to BoomCrane", crane())] {
        let Some(pair) = pair else {
            println!("  {name}: not built");
            continue;
        };
        // The best of many is what the code takes; the rest is what else the machine does.
        let mut best = [Duration::MAX; 2];
        for _ in 0..40 {
            best = [best[0].min(pair.bare()), best[1].min(pair.master())];
        }
        let [bare, master] = best.map(|time| time.as_secs_f64() * 1e9 / f64::from(STEPS) / 2.0);
        println!("  {name}: bare {bare:.1} ns, master {master:.1} ns, ratio {:.3}", master / bare);
    }
    if let Some(factor) = real_time_factor() {
        println!("example at {STEP_SIZE} s steps without recording: {factor:.0} times real time");
    }
    divan::main();
}

/// Two FMUs in a row, the first one's outputs being the second one's inputs.
struct Pair {
    first: Arc<Fmu>,
    second: Arc<Fmu>,
    connections: Vec<(&'static str, &'static str)>,
    start_values: Vec<(&'static str, f64)>,
}

fn foreign() -> Option<Pair> {
    let fmu = Arc::new(Fmu::open(common::foreign(FmiVersion::V3)).ok()?);
    Some(Pair {
        first: fmu.clone(),
        second: fmu,
        connections: vec![("doubled", "rate")],
        start_values: vec![("rate", 0.25)],
    })
}

fn crane() -> Option<Pair> {
    Some(Pair {
        first: Arc::new(Fmu::open(fmus().join("fmi3/VectorDrive.fmu")).ok()?),
        second: Arc::new(Fmu::open(fmus().join("fmi3/BoomCrane.fmu")).ok()?),
        connections: vec![("velocity", "slew.rate")],
        start_values: vec![("command", 0.1)],
    })
}

fn workspace() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."))
}

fn fmus() -> PathBuf {
    std::env::var_os("SWAYLESS_FMUS").map_or_else(|| workspace().join("target/fmus"), PathBuf::from)
}

impl Pair {
    fn system(&self) -> System {
        let mut system = System::new("pair");
        system.add_model("first", self.first.clone());
        system.add_model("second", self.second.clone());
        for (from, to) in &self.connections {
            system.connect(format!("first.{from}"), format!("second.{to}"));
        }
        for (name, value) in &self.start_values {
            system.set_start_value(format!("first.{name}"), value.to_string());
        }
        system
    }

    fn master(&self) -> Duration {
        let options = Options { stop_time: Some(STOP_TIME), step_size: Some(STEP_SIZE), ..Options::default() };
        simulate(&self.system(), &options, &mut ()).expect("the pair runs").stepping_time
    }

    fn bare(&self) -> Duration {
        let reference = |fmu: &Fmu, name: &str| {
            let found = fmu.description().variables.iter().find(|variable| variable.name == name);
            found.expect("the variable exists").value_reference
        };
        let parameters: Vec<_> =
            self.start_values.iter().map(|&(name, value)| (reference(&self.first, name), value)).collect();
        let mut first = Bare::new(&self.first, &parameters, STOP_TIME);
        let mut second = Bare::new(&self.second, &[], STOP_TIME);
        let outputs: Vec<_> = self.connections.iter().map(|(from, _)| reference(&self.first, from)).collect();
        let inputs: Vec<_> = self.connections.iter().map(|(_, to)| reference(&self.second, to)).collect();
        let mut values = vec![0.0; outputs.len()];
        let begin = Instant::now();
        for step in 0..STEPS {
            let time = f64::from(step) * STEP_SIZE;
            first.step(time, STEP_SIZE);
            first.get(&outputs, &mut values);
            second.set(&inputs, &values);
            second.step(time, STEP_SIZE);
        }
        begin.elapsed()
    }
}

/// The example system with one kind of shaper, at 10 ms steps, without recording.
fn real_time_factor() -> Option<f64> {
    let file = workspace().join("examples/boom-crane/SystemStructure.ssd");
    let system = System::open_with_fmus(file, &fmus().join("fmi3"))
        .map_err(|error| println!("the example is not measured: {error}"))
        .ok()?;
    let options = Options { step_size: Some(STEP_SIZE), ..Options::default() };
    let factors = (0..5).map(|_| simulate(&system, &options, &mut ()).expect("the example runs").real_time_factor());
    factors.reduce(f64::max)
}

#[divan::bench]
fn foreign_pair_with_master(bencher: Bencher) {
    let Some(pair) = foreign() else { return };
    bencher.counter(ItemsCount::new(STEPS)).bench_local(|| pair.master());
}

#[divan::bench]
fn foreign_pair_bare(bencher: Bencher) {
    let Some(pair) = foreign() else { return };
    bencher.counter(ItemsCount::new(STEPS)).bench_local(|| pair.bare());
}

#[divan::bench]
fn crane_with_master(bencher: Bencher) {
    let Some(pair) = crane() else { return };
    bencher.counter(ItemsCount::new(STEPS)).bench_local(|| pair.master());
}

#[divan::bench]
fn crane_bare(bencher: Bencher) {
    let Some(pair) = crane() else { return };
    bencher.counter(ItemsCount::new(STEPS)).bench_local(|| pair.bare());
}
