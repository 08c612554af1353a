//! `swayless shaper`.

mod check;
mod json;
mod parameters;
mod plot;
mod request;
mod table;
mod words;

use std::path::PathBuf;

use clap::ArgGroup;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use swayless::shapers::{Candidate, Recommendation, recommend};
use swayless_shaping::Kind;

use super::{Failure, Outcome, console, files};
use request::Question;

/// Compare the kinds of input shaper for a load that swings, and recommend one.
///
/// Prints what each kind costs in time, what it leaves at the frequency it is designed for and at the worst place of a range
/// of frequencies, and what it asks of the drive; then which one to take and why.
#[derive(Debug, clap::Args)]
#[command(allow_negative_numbers = true)]
#[command(group(ArgGroup::new("mode").required(true).args(["length", "frequency", "hertz"])))]
#[command(after_help = more_help())]
pub struct Arguments {
    /// Length of the cable that the load hangs on (m)
    #[arg(long, value_name = "M")]
    length: Option<f64>,
    /// Length of the rigging below the hook (m), for the second mode of hook and payload
    #[arg(long, value_name = "M", requires = "length", requires = "mass_ratio", conflicts_with_all = ["frequency", "hertz"])]
    rigging_length: Option<f64>,
    /// Mass of the payload over that of the hook
    #[arg(long, value_name = "RATIO", requires = "length", requires = "rigging_length", conflicts_with_all = ["frequency", "hertz"])]
    mass_ratio: Option<f64>,
    /// Gravity (m/s²)
    #[arg(long, value_name = "M/S²", default_value_t = 9.81, conflicts_with_all = ["frequency", "hertz"])]
    gravity: f64,
    /// Undamped natural frequency (rad/s) instead of a length; given twice, the frequencies of two modes
    #[arg(long, value_name = "RAD/S")]
    frequency: Vec<f64>,
    /// The same in Hz
    #[arg(long, value_name = "HZ")]
    hertz: Vec<f64>,
    /// Damping ratio of the mode; given twice, of each mode
    #[arg(long, value_name = "RATIO", default_value = "0")]
    damping: Vec<f64>,
    /// What the length, or the mode's frequency, may be, in the same unit; for two frequencies given twice
    #[arg(long, value_name = "LOW..HIGH", value_parser = request::range, conflicts_with = "insensitivity", allow_hyphen_values = true)]
    range: Vec<(f64, f64)>,
    /// Instead of a range: the full width of each mode's range of frequencies, over its frequency
    #[arg(long, value_name = "WIDTH", default_value_t = 0.4)]
    insensitivity: f64,
    /// Residual vibration that is allowed, as a share of the unshaped one
    #[arg(long, value_name = "SHARE", default_value_t = 0.05)]
    vibration_limit: f64,
    /// Residual vibration at which insensitivity is measured [default: the vibration limit]
    #[arg(long, value_name = "SHARE")]
    level: Option<f64>,
    /// Acceleration limit of the drive (m/s², or what the axis is measured in), for what remains behind it
    #[arg(long, value_name = "M/S²", requires = "velocity_limit", conflicts_with_all = ["acceleration_time_constant", "braking_time_constant"])]
    acceleration_limit: Option<f64>,
    /// The largest step of the command, with --acceleration-limit (m/s)
    #[arg(long, value_name = "M/S", requires = "acceleration_limit")]
    velocity_limit: Option<f64>,
    /// Time constant with which the drive speeds up (s), for what remains behind it
    #[arg(long, value_name = "SECONDS", requires = "braking_time_constant")]
    acceleration_time_constant: Option<f64>,
    /// Time constant with which the drive slows down (s)
    #[arg(long, value_name = "SECONDS", requires = "acceleration_time_constant")]
    braking_time_constant: Option<f64>,
    /// The kind for each mode that `Convolved` is made of; given twice, one for each mode [default: ZV]
    #[arg(long, value_name = "KIND", ignore_case = true, hide_possible_values = true, value_parser = kinds())]
    base_kind: Vec<Kind>,
    /// Which of the solutions of `MinimumImpulse`, from 1, the shortest
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    solution: usize,
    /// A kind to compare; may be given several times [default: all]
    #[arg(long, ignore_case = true, hide_possible_values = true, value_parser = kinds())]
    kind: Vec<Kind>,
    /// Also print the impulses, of the kinds named by --kind, else of the recommended one
    #[arg(long)]
    impulses: bool,
    /// Draw the sensitivity curves: as a picture (.svg), or as a page (.html) together with the shaped steps
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Write the recommended shaper as a parameter set (.ssv) for InputShaper
    #[arg(long, value_name = "FILE")]
    ssv: Option<PathBuf>,
    /// Print as JSON
    #[arg(long)]
    json: bool,
}

/// What follows the options.
fn more_help() -> String {
    let names: Vec<&str> = Kind::ALL.into_iter().map(Kind::name).collect();
    format!(
        "Kinds: {}.\nWhat each is for: fmus/input-shaper/README.md.\n\n\
         Examples:\n  \
         swayless shaper --length 10 --damping 0.01 --range 8..13\n  \
         swayless shaper --hertz 0.28 --kind ZVD --kind EI --impulses\n  \
         swayless shaper --hertz 0.28 --acceleration-limit 0.12 --velocity-limit 0.358\n  \
         swayless shaper --length 8 --rigging-length 3 --mass-ratio 0.5 --plot sensitivity.html\n\n\
         The rules of the recommendation and what the JSON holds: docs/shaper.md.",
        names.join(", ")
    )
}

fn kinds() -> impl TypedValueParser<Value = Kind> {
    PossibleValuesParser::new(Kind::ALL.map(Kind::name)).map(|name| {
        // The parser lets only names of kinds pass.
        let named = |kind: &Kind| kind.name().eq_ignore_ascii_case(&name);
        Kind::ALL.into_iter().find(named).unwrap_or(Kind::None)
    })
}

pub fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let question = Question::of(arguments)?;
    let format = arguments.plot.as_deref().map(plot::Format::of).transpose()?;
    let candidates = question.request.candidates();
    let found = recommend(&candidates, question.request.vibration_limit);
    // Files first: who reads stdout may have seen enough before its end.
    if let (Some(path), Some(format)) = (&arguments.plot, format) {
        files::write(path, &plot::draw(format, &question, &candidates, found)?)?;
    }
    if let (Some(path), Some(found)) = (&arguments.ssv, found) {
        files::write(path, &parameters::set(&candidates[found.choice])?)?;
    }
    if arguments.json {
        console::print(format_args!("{:#}", json::json(&question, &candidates, found)))?;
    } else {
        print(arguments, &question, &candidates, found)?;
    }
    if found.is_none() {
        let text = "there is no shaper to recommend among the kinds asked for (`--kind`); take others, or change what they need";
        return Err(swayless::Error::Option(text.to_owned()).into());
    }
    Ok(Outcome::Done)
}

fn print(
    arguments: &Arguments,
    question: &Question,
    candidates: &[Candidate],
    found: Option<Recommendation>,
) -> Result<(), Failure> {
    let mut parts = vec![table::heading(question).join("\n")];
    parts.extend(candidates.iter().any(|one| one.figures().is_some()).then(|| table::text(question, candidates)));
    let listed = |place: usize| !arguments.kind.is_empty() || found.is_some_and(|found| found.choice == place);
    for (_, candidate) in candidates.iter().enumerate().filter(|(place, _)| arguments.impulses && listed(*place)) {
        parts.extend(candidate.figures().map(|figures| table::impulses(candidate, figures)));
    }
    parts.extend(words::refusals(candidates));
    if let Some(found) = found {
        parts.push(console::paragraph(&words::recommendation(question, candidates, found)));
        parts.push(console::paragraph(&parameters::line(&candidates[found.choice])));
    }
    console::print(parts.join("\n\n"))
}
