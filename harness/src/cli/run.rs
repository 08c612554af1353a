//! `swayless run`.

use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use serde_json::json;
use swayless::{
    AlgorithmKind, Column, CsvWriter, InputSignals, Observer, Options, Recording, Summary, System, Value, simulate,
};

use super::console::Progress;
use super::files::write_failed;
use super::interrupt::Interrupt;
use super::statistics::Statistics;
use super::{Failure, Outcome, console};

/// Run a system of FMUs, or one FMU, by co-simulation.
///
/// FILE is a system description (.ssd), a system archive (.ssp) or an FMU (.fmu). What the options leave open is taken
/// from the system description, else from the FMUs' default experiments. Without --output-file and --json a table of
/// the recorded variables is printed.
#[derive(Debug, clap::Args)]
#[command(allow_negative_numbers = true)]
#[command(after_help = "Examples:\n  \
    swayless run examples/boom-crane/SystemStructure.ssd --step-size 0.01 -o result.csv --report report.html\n  \
    swayless run examples/boom-crane/SystemStructure.ssd --fmu-dir target/fmus/fmi2\n  \
    swayless run target/fmus/fmi3/BoomCrane.fmu --stop-time 20 --start-value swing.radial_start=0.1")]
pub struct Arguments {
    /// The .ssd, .ssp or .fmu to run
    file: PathBuf,
    /// Take each FMU of a system from this folder, by its file name, rather than from where the system description
    /// says; so one description serves FMI 2.0 and FMI 3.0
    #[arg(long, value_name = "DIR")]
    fmu_dir: Option<PathBuf>,
    /// When to start (s)
    #[arg(long, value_name = "SECONDS")]
    start_time: Option<f64>,
    /// When to stop (s)
    #[arg(long, value_name = "SECONDS")]
    stop_time: Option<f64>,
    /// The communication step size (s) [default: that of the system or its FMUs, else a thousandth of the run]
    #[arg(long, value_name = "SECONDS")]
    step_size: Option<f64>,
    /// How the master steps the FMUs: `jacobi` all at once, `gauss-seidel` one after the other in the order of signals
    #[arg(long, value_enum, default_value_t = Algorithm::GaussSeidel)]
    algorithm: Algorithm,
    /// Break algebraic loops rather than refuse them: the last connection of each loop passes its values a step late
    #[arg(long)]
    break_loops: bool,
    /// The relative tolerance of the FMUs' integrators
    #[arg(long, value_name = "NUMBER")]
    tolerance: Option<f64>,
    /// A file of start values (.ssv) that go before those of the system; may be given several times, the last one counts
    #[arg(long, value_name = "FILE")]
    parameter_set: Vec<PathBuf>,
    /// A start value; may be given several times, and goes before all others. In a system the name is `instance.variable`
    #[arg(long, value_name = "NAME=VALUE", value_parser = start_value)]
    start_value: Vec<(String, String)>,
    /// A CSV file with a time column and one for each input to drive
    #[arg(long, value_name = "FILE")]
    input_file: Option<PathBuf>,
    /// The time between two samples (s), a multiple of the step size [default: every step]
    #[arg(long, value_name = "SECONDS")]
    output_interval: Option<f64>,
    /// A variable to record; may be given several times [default: all outputs]
    #[arg(long, value_name = "NAME")]
    output_variable: Vec<String>,
    /// Write the recorded variables as CSV; `-` is stdout
    #[arg(long, short, value_name = "FILE")]
    output_file: Option<PathBuf>,
    /// Write a page with interactive curves of the recorded variables
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
    /// Print a summary as JSON
    #[arg(long)]
    json: bool,
    /// Ask the FMUs for debug messages
    #[arg(long)]
    debug_logging: bool,
}

#[derive(Debug, Clone, Copy, clap::ValueEnum)]
enum Algorithm {
    Jacobi,
    GaussSeidel,
}

pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut interrupt = Interrupt::watch();
    let system = system(arguments)?;
    let options = options(arguments);
    let to_stdout = arguments.output_file.as_deref() == Some(Path::new("-"));
    if to_stdout && arguments.json {
        return Err(swayless::Error::Option("`--output-file -` and `--json` both want stdout; give one".into()).into());
    }
    let mut progress = Progress::new(&system.name);
    let mut statistics = Statistics::default();
    let mut recording = arguments.report.as_ref().map(|_| Recording::new());
    let path = arguments.output_file.as_deref().filter(|_| !to_stdout);
    let mut file = path.map(|path| FileOfRun { path, writer: None });
    if let Some(folder) = arguments.report.as_deref().and_then(Path::parent)
        && !folder.as_os_str().is_empty()
        && !folder.is_dir()
    {
        return Err(write_failed(folder, std::io::ErrorKind::NotFound.into()).into());
    }
    let mut stdout = to_stdout.then(|| CsvWriter::new("stdout", BufWriter::new(std::io::stdout())));

    let mut observers: Vec<&mut dyn Observer> = vec![&mut progress, &mut interrupt, &mut statistics];
    observers.extend(recording.as_mut().map(|o| o as &mut dyn Observer));
    observers.extend(file.as_mut().map(|o| o as &mut dyn Observer));
    observers.extend(stdout.as_mut().map(|o| o as &mut dyn Observer));
    let summary = simulate(&system, &options, &mut observers)?;
    drop(observers);
    drop(progress);

    summary.messages.iter().for_each(|m| console::note(format_args!("{}: {m}", m.instance)));
    if let (Some(path), Some(recording)) = (&arguments.report, &recording) {
        let page = swayless::report::html::page(&swayless::report::run::report(&system.name, recording, &summary));
        std::fs::write(path, page).map_err(|source| write_failed(path, source))?;
    }
    tell(&system.name, &summary);
    if arguments.json {
        console::print(format_args!("{:#}", json(&system.name, &summary, &statistics)))?;
    } else if arguments.output_file.is_none() {
        console::print(statistics.table())?;
    }
    Ok(Outcome::Done)
}

/// A CSV file that is made, over one that may be there, when the run begins: a mistake in the arguments costs no results.
struct FileOfRun<'a> {
    path: &'a Path,
    writer: Option<CsvWriter<BufWriter<File>>>,
}

impl Observer for FileOfRun<'_> {
    fn begin(&mut self, columns: &[Column]) -> swayless::Result<()> {
        self.writer.insert(CsvWriter::create(self.path)?).begin(columns)
    }

    fn sample(&mut self, time: f64, values: &[Value]) -> swayless::Result<()> {
        self.writer.as_mut().map_or(Ok(()), |writer| writer.sample(time, values))
    }

    fn end(&mut self) -> swayless::Result<()> {
        self.writer.as_mut().map_or(Ok(()), CsvWriter::end)
    }
}

fn system(arguments: &Arguments) -> Result<System, Failure> {
    let mut system = match &arguments.fmu_dir {
        Some(_) if !is_system(&arguments.file) => {
            let text =
                "`--fmu-dir` says where the FMUs of a system are; a single FMU is run from the file that is named";
            return Err(swayless::Error::Option(text.to_owned()).into());
        }
        Some(folder) => System::open_with_fmus(&arguments.file, folder)?,
        None => System::open(&arguments.file)?,
    };
    for path in &arguments.parameter_set {
        system.add_parameter_set(path)?;
    }
    for (name, value) in &arguments.start_value {
        system.set_start_value(name, value);
    }
    if arguments.break_loops {
        system.set_break_loops(true);
        for late in system.late_connections()? {
            console::note(format_args!("a step late, to break an algebraic loop: {late}"));
        }
    }
    if let Some(path) = &arguments.input_file {
        system.set_input_signals(InputSignals::open(path)?);
    }
    Ok(system)
}

fn is_system(file: &Path) -> bool {
    file.extension().is_some_and(|e| e.eq_ignore_ascii_case("ssd") || e.eq_ignore_ascii_case("ssp"))
}

fn options(arguments: &Arguments) -> Options {
    Options {
        start_time: arguments.start_time,
        stop_time: arguments.stop_time,
        step_size: arguments.step_size,
        tolerance: arguments.tolerance,
        output_interval: arguments.output_interval,
        output_variables: arguments.output_variable.clone(),
        algorithm: match arguments.algorithm {
            Algorithm::Jacobi => AlgorithmKind::Jacobi,
            Algorithm::GaussSeidel => AlgorithmKind::GaussSeidel,
        },
        logging: arguments.debug_logging,
    }
}

fn tell(name: &str, summary: &Summary) {
    console::note(format_args!(
        "{name}: {} steps of {} s to t = {} s, at {:.0} times real time",
        summary.steps,
        summary.step_size,
        summary.stop_time,
        summary.real_time_factor(),
    ));
    if let Some(instance) = &summary.terminated_by {
        console::warn(format_args!("`{instance}` ended the run at t = {} s", summary.stop_time));
    }
}

fn json(name: &str, summary: &Summary, statistics: &Statistics) -> serde_json::Value {
    json!({
        "system": name,
        "start_time": summary.start_time,
        "stop_time": summary.stop_time,
        "step_size": summary.step_size,
        "steps": summary.steps,
        "terminated_by": summary.terminated_by,
        "wall_time": summary.wall_time.as_secs_f64(),
        "real_time_factor": summary.real_time_factor(),
        "messages": summary.messages.iter().map(|m| format!("{}: {m}", m.instance)).collect::<Vec<_>>(),
        "variables": statistics.json(),
    })
}

fn start_value(text: &str) -> Result<(String, String), String> {
    let (name, value) = text.split_once('=').ok_or("expected NAME=VALUE")?;
    if name.trim().is_empty() {
        return Err("expected a name before `=`".to_owned());
    }
    Ok((name.trim().to_owned(), value.trim().to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn start_values_are_split_at_the_first_equals_sign() {
        assert_eq!(start_value("a.b = x=1"), Ok(("a.b".into(), "x=1".into())));
        assert!(start_value("a.b").is_err() && start_value("=1").is_err());
    }
}
