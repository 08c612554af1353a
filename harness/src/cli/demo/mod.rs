//! `swayless demo`. What the example's boom crane is called and measured by is known here and nowhere else in the
//! harness.

mod figures;
mod results;

use std::path::PathBuf;

use serde_json::json;
use swayless::package;
use swayless::report::{Report, html, svg};
use swayless::{CsvWriter, Observer, Options, Recording, Summary, System, simulate};
use swayless_modeldesc::types::FmiVersion;

use super::console::Progress;
use super::files::{write, write_failed};
use super::{Failure, Outcome, build, console};

/// Build the FMUs and let an operator drive the example's boom crane, with and without input shaping.
///
/// Runs examples/boom-crane once unshaped and once with each kind of shaper, in FMI 3.0 and in FMI 2.0. Writes one CSV
/// file per run and report.html with all curves, and prints what the shapers are worth.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// Where the CSV files and report.html are written
    #[arg(long, short, value_name = "DIR", default_value = "out")]
    output_dir: PathBuf,
    /// The communication step size (s)
    #[arg(long, value_name = "SECONDS", default_value_t = 0.01)]
    step_size: f64,
    /// Also draw the swing of all runs as SVG
    #[arg(long, value_name = "FILE")]
    picture: Option<PathBuf>,
    /// The workspace's folder or Cargo.toml [default: the one around the current folder]
    #[arg(long, value_name = "PATH")]
    workspace: Option<PathBuf>,
    /// Where cargo compiles the FMUs [default: cargo's own choice]
    #[arg(long, value_name = "DIR")]
    target_dir: Option<PathBuf>,
    /// Print the results as JSON
    #[arg(long)]
    json: bool,
}

/// The example, below the workspace.
const SYSTEM: &str = "examples/boom-crane/SystemStructure.ssd";

/// The kinds of shaper, and first none.
const KINDS: [&str; 6] = ["None", "ZV", "ZVD", "ZVDD", "EI", "UMZV"];

/// An axis that the operator drives: its name in the example and the unit of its rate.
struct Axis {
    name: &'static str,
    unit: &'static str,
}

const AXES: [Axis; 4] = [
    Axis { name: "slew", unit: "rad/s" },
    Axis { name: "luff", unit: "rad/s" },
    Axis { name: "hoist", unit: "m/s" },
    Axis { name: "base", unit: "m/s" },
];

/// What is recorded of each axis.
const AXIS_VARIABLES: [&str; 4] = ["command.command", "shaper.shaped", "shaper.duration", "drive.velocity"];

/// What is recorded of the crane.
const CRANE_VARIABLES: [&str; 11] = [
    "base.x",
    "slew.angle",
    "luff.angle",
    "hoist.length",
    "swing.radial",
    "swing.tangential",
    "swing.amplitude",
    "payload.x",
    "payload.y",
    "payload.z",
    "at_limit",
];

/// A run with one kind of shaper, in both versions.
struct Run {
    kind: &'static str,
    /// FMI 3.0's.
    recording: Recording,
    fmi3: Summary,
    fmi2: Summary,
    /// Whether FMI 2.0 gave the same bits.
    same: bool,
}

pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let options = package::Options {
        workspace: arguments.workspace.clone(),
        target_dir: arguments.target_dir.clone(),
        ..package::Options::default()
    };
    let built = build::build(options)?;
    let folder = &arguments.output_dir;
    std::fs::create_dir_all(folder).map_err(|source| write_failed(folder, source))?;
    let mut runs = Vec::new();
    for kind in KINDS {
        let (recording, fmi3) = simulate_once(arguments, &built, kind, FmiVersion::V3)?;
        let (other, fmi2) = simulate_once(arguments, &built, kind, FmiVersion::V2)?;
        let same = same_bits(&recording, &other);
        runs.push(Run { kind, recording, fmi3, fmi2, same });
    }
    let results = results::results(&runs);
    write_report(arguments, &runs, &results)?;
    if arguments.json {
        let rows: Vec<_> = results.rows.iter().map(results::Row::json).collect();
        console::print(format_args!("{:#}", json!({ "rest_from": results.rest_from, "runs": rows })))?;
    } else {
        console::print(results.table())?;
    }
    Ok(Outcome::Done)
}

fn simulate_once(
    arguments: &Arguments,
    built: &package::Built,
    kind: &str,
    version: FmiVersion,
) -> Result<(Recording, Summary), Failure> {
    let mut system = System::open_with_fmus(built.workspace.join(SYSTEM), &built.folder(version))?;
    let mut variables: Vec<String> = CRANE_VARIABLES.iter().map(|v| format!("crane.{v}")).collect();
    for Axis { name, .. } in AXES {
        system.set_start_value(format!("{name}_shaper.kind"), kind);
        variables.extend(AXIS_VARIABLES.iter().map(|v| format!("{name}_{v}")));
    }
    let file = match version {
        FmiVersion::V2 => format!("fmi2-{kind}.csv"),
        FmiVersion::V3 => format!("fmi3-{kind}.csv"),
    };
    let mut csv = CsvWriter::create(arguments.output_dir.join(&file))?;
    let mut recording = Recording::new();
    let mut progress = Progress::new(format!("{kind}, FMI {version}"));
    let options = Options { step_size: Some(arguments.step_size), output_variables: variables, ..Options::default() };
    let mut observers: Vec<&mut dyn Observer> = vec![&mut csv, &mut recording, &mut progress];
    let summary = simulate(&system, &options, &mut observers)?;
    drop(observers);
    summary.messages.iter().for_each(|m| console::note(format_args!("{kind}, FMI {version}: {}: {m}", m.instance)));
    Ok((recording, summary))
}

fn same_bits(one: &Recording, other: &Recording) -> bool {
    let bits = |values: &[f64]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
    one.names == other.names
        && bits(&one.times) == bits(&other.times)
        && one.columns.iter().zip(&other.columns).all(|(a, b)| bits(a) == bits(b))
}

fn write_report(arguments: &Arguments, runs: &[Run], results: &results::Results) -> Result<(), Failure> {
    let report = Report {
        title: "An operator drives a boom crane".to_owned(),
        introduction: vec![
            "One drive of about a minute, four axes, levers pressed, held and let go as a person would: once as it is, \
             and once through each kind of input shaper. Only the shapers differ between the runs."
                .to_owned(),
            "Drag over a plot to zoom, double-click to see all again, click a name to hide or show its curves.".to_owned(),
        ],
        tables: vec![results.report_table()],
        figures: figures::figures(runs, results),
    };
    let path = arguments.output_dir.join("report.html");
    write(&path, &html::page(&report))?;
    if let Some(path) = &arguments.picture {
        write(path, &svg::picture(&figures::picture(runs, results), 960, 640)?)?;
    }
    Ok(())
}
