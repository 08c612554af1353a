//! A reference run for each FMU, by which importers check themselves: the layered standard FMI-LS-REF.
//!
//! The run is computed by our own master with the library that is packaged. It is declared here for all FMUs alike: the
//! default experiment, with a tight tolerance, in which the first input moves from its start value to another.

use std::fmt::Write;
use std::path::Path;

use swayless_modeldesc::types::{Causality, DataType, ModelDescription, Start, Variable};

use super::Error;
use crate::{Column, CsvWriter, InputSignals, Observer, Options, System, Value, simulate};

/// Where the standard wants it.
const FOLDER: &str = "extra/org.fmi-standard.fmi-ls-ref";

/// The relative tolerance of the run: results that differ by much more differ by more than the integrators.
const TOLERANCE: f64 = 1e-8;

/// How far the input moves, in its own unit: 0.1 m/s or 0.1 rad/s is a common speed of an axis.
const MOVE: f64 = 0.1;

/// How many samples there are at most, but for the first: the files stay small.
const SAMPLES: u64 = 50;

/// When something is sampled or moves, in communication steps.
struct Schedule {
    stop: f64,
    step: f64,
    /// Steps between two samples.
    interval: u64,
}

/// The entries of the reference run of an FMU, which lies packed, without one, at this path. None if it has no
/// co-simulation or no outputs that are scalar numbers.
pub fn entries(fmu: &Path) -> Result<Vec<(String, Vec<u8>)>, Error> {
    let mut system = System::open(fmu).map_err(Error::fmu)?;
    let model = system.instances()[0].model.clone();
    let description = model.description();
    let outputs: Vec<String> = scalars(description, Causality::Output).map(|v| v.name.clone()).collect();
    if description.co_simulation.is_none() || outputs.is_empty() {
        return Ok(Vec::new());
    }
    let schedule = schedule(description);
    let input = scalars(description, Causality::Input).next().map(|input| stimulus(input, &schedule));
    if let Some(signals) = &input {
        system.set_input_signals(signals.clone());
    }
    let options = Options {
        start_time: Some(0.0),
        stop_time: Some(schedule.stop),
        step_size: Some(schedule.step),
        tolerance: Some(TOLERANCE),
        output_interval: Some(schedule.interval as f64 * schedule.step),
        output_variables: outputs,
        ..Options::default()
    };
    let mut results = PlainNames(CsvWriter::new("reference results", Vec::new()));
    simulate(&system, &options, &mut results).map_err(Error::fmu)?;
    let results = results.0.into_inner().map_err(Error::fmu)?;
    let mut files = vec![
        ("fmi-ls-manifest.xml", manifest(input.is_some()).into_bytes()),
        ("smoke-test.exp", experiment(&description.model_name, &schedule, input.is_some()).into_bytes()),
        ("smoke-test_ref.csv", results),
    ];
    files.extend(input.map(|signals| ("smoke-test_in.csv", csv(&signals).into_bytes())));
    Ok(files.into_iter().map(|(name, bytes)| (format!("{FOLDER}/{name}"), bytes)).collect())
}

/// Writes variables under the names that they have in the FMU: without the instance that they are of.
struct PlainNames(CsvWriter<Vec<u8>>);

impl Observer for PlainNames {
    fn begin(&mut self, columns: &[Column]) -> crate::Result<()> {
        let plain = |column: &Column| {
            let name = column.name.split_once('.').map_or(&*column.name, |(_, name)| name);
            Column { name: name.to_owned(), ..column.clone() }
        };
        self.0.begin(&columns.iter().map(plain).collect::<Vec<_>>())
    }

    fn sample(&mut self, time: f64, values: &[Value]) -> crate::Result<()> {
        self.0.sample(time, values)
    }

    fn end(&mut self) -> crate::Result<()> {
        self.0.end()
    }
}

/// Variables of one number.
fn scalars(description: &ModelDescription, causality: Causality) -> impl Iterator<Item = &Variable> {
    description.variables.iter().filter(move |v| {
        v.causality == causality && v.data_type == DataType::Float64 && v.dimensions.is_empty() && v.clocks.is_empty()
    })
}

/// The default experiment.
fn schedule(description: &ModelDescription) -> Schedule {
    let experiment = description.default_experiment.unwrap_or_default();
    let stop = experiment.stop_time.unwrap_or(1.0);
    let step = experiment.step_size.unwrap_or(stop / 1000.0);
    let steps = (stop / step).round() as u64;
    Schedule { stop, step, interval: steps.div_ceil(SAMPLES).max(1) }
}

/// The input is constant but for one communication step, at a tenth of the run, over which it moves: between two
/// communication points, so that whoever sets inputs at these points, held or interpolated, sets the same values.
fn stimulus(input: &Variable, schedule: &Schedule) -> InputSignals {
    let from = match &input.start {
        Some(Start::Float(values)) => values.first().copied().unwrap_or_default(),
        _ => 0.0,
    };
    let up = input.attributes.max.is_none_or(|max| from + MOVE <= max);
    let to = if up { from + MOVE } else { from - MOVE };
    let moves = (schedule.stop / schedule.step / 10.0).round();
    let times = vec![0.0, moves * schedule.step, (moves + 1.0) * schedule.step, schedule.stop];
    InputSignals {
        path: "smoke-test_in.csv".into(),
        names: vec![input.name.clone()],
        times,
        columns: vec![vec![from, from, to, to]],
    }
}

fn csv(signals: &InputSignals) -> String {
    let mut text = format!("time,{}\n", signals.names.join(","));
    for (index, time) in signals.times.iter().enumerate() {
        // Writing to a string does not fail.
        let _ = write!(text, "{time}");
        signals.columns.iter().for_each(|column| {
            let _ = write!(text, ",{}", column[index]);
        });
        text.push('\n');
    }
    text
}

/// `fmi-ls-manifest.xml` as FMI-LS-REF 1.0.0-alpha.1 lays it down.
fn manifest(has_input: bool) -> String {
    let mut related = vec![
        ("application/x-ma-hs-experiments", "smoke-test.exp", "experiment/smoke-test", "The default experiment"),
        ("text/csv", "smoke-test_ref.csv", "result", "Outputs of the experiment"),
    ];
    if has_input {
        related.push(("text/csv", "smoke-test_in.csv", "other", "Input of the experiment, linear between its points"));
    }
    let related: String = related
        .iter()
        .map(|(kind, source, role, description)| {
            format!("  <Related type=\"{kind}\" source=\"{source}\" role=\"{role}\" description=\"{description}\"/>\n")
        })
        .collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiReferences xmlns:fmi-ls=\"http://fmi-standard.org/fmi-ls-manifest\" \
         fmi-ls:fmi-ls-name=\"org.fmi-standard.fmi-ls-ref\" fmi-ls:fmi-ls-version=\"1.0.0-alpha.1\" \
         fmi-ls:fmi-ls-description=\"Layered Standard providing information on related files included in an FMU.\">\n\
         {related}</fmiReferences>\n"
    )
}

/// The experiment, in the Experiments Format of the Modelica Association.
fn experiment(name: &str, schedule: &Schedule, has_input: bool) -> String {
    let Schedule { stop, step, .. } = schedule;
    let stimuli = if has_input { "    <Stimuli source=\"smoke-test_in.csv\"/>\n" } else { "" };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <Experiments name=\"{name}\" description=\"Co-simulation with fixed communication steps\">\n  \
         <Experiment name=\"smoke-test\" startTime=\"0\" stopTime=\"{stop}\" stepSize=\"{step}\" \
         tolerance=\"{TOLERANCE:e}\">\n{stimuli}    <References source=\"smoke-test_ref.csv\"/>\n  </Experiment>\n\
         </Experiments>\n"
    )
}
