//! The recommendation, and why kinds are missing, in words.

use swayless::shapers::{Candidate, DriveStep, Figures, Recommendation, Refusal, UncertainMode, recommendation};
use swayless_shaping::{Drive, Kind, Quantity};

use super::request::{Given, Question};
use crate::cli::console::significant;

/// A share in percent.
pub fn percent(share: f64) -> String {
    // What is left of rounding is nothing.
    if share < 1e-9 { "0 %".to_owned() } else { format!("{} %", significant(100.0 * share, 3)) }
}

/// A time.
pub fn seconds(time: f64) -> String {
    format!("{} s", significant(time, 4))
}

/// What precedes the reasons why kinds are missing.
pub const REFUSED: &str = "Not to be had here";

/// The kinds that there is no shaper of, each with the reason.
pub fn refusals(candidates: &[Candidate]) -> Option<String> {
    let reasons: String = candidates.iter().filter_map(refusal).map(|reason| format!("\n  {reason}")).collect();
    (!reasons.is_empty()).then(|| format!("{REFUSED}:{reasons}"))
}

/// Why there is no shaper of a kind, and what to change.
pub fn refusal(candidate: &Candidate) -> Option<String> {
    let error = candidate.result.as_ref().err()?;
    let (kind, text) = (candidate.kind.name(), error.to_string());
    let option = match error {
        Refusal::NoAccelerationLimit => {
            return Some(format!("{kind} {text} (`--acceleration-limit` and `--velocity-limit`)"));
        }
        Refusal::NoTimeConstants => {
            return Some(format!("{kind} {text} (`--acceleration-time-constant` and `--braking-time-constant`)"));
        }
        Refusal::Specification(error) => option(error.quantity()),
    };
    let text = if text.starts_with(kind) { text } else { format!("{kind}: {text}") };
    Some(format!("{text} ({option})"))
}

/// The option to change.
fn option(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Kind => "`--kind`",
        Quantity::Frequency(0) => "`--length`, `--frequency` or `--hertz`",
        Quantity::Frequency(_) => "`--frequency` or `--hertz` given twice, or `--rigging-length` and `--mass-ratio`",
        Quantity::DampingRatio(_) => "`--damping`",
        Quantity::VibrationLimit => "`--vibration-limit`",
        Quantity::Insensitivity => "`--range` or `--insensitivity`",
        Quantity::AccelerationLimit => "`--acceleration-limit`",
        Quantity::VelocityLimit => "`--velocity-limit`",
        Quantity::AccelerationTimeConstant => "`--acceleration-time-constant`",
        Quantity::BrakingTimeConstant => "`--braking-time-constant`",
        Quantity::BaseKind(_) => "`--base-kind`",
        Quantity::Solution => "`--solution`",
    }
}

/// What to take and why.
pub fn recommendation(question: &Question, candidates: &[Candidate], found: Recommendation) -> String {
    let request = &question.request;
    let limit = percent(request.vibration_limit);
    let range = if request.modes.len() > 1 { "both ranges" } else { "the range" };
    let behind = if request.drive.is_some() { " behind the drive" } else { "" };
    let at = |place: usize| candidates[place].figures().map(|figures| (candidates[place].name(), figures));
    let Some((name, choice)) = at(found.choice) else {
        return String::new();
    };
    let (worst, cost) = (percent(choice.worst()), seconds(choice.delay));
    let bare = candidates[found.choice].kind == Kind::None;
    let mut sentences = match found.holds {
        true if bare => vec![format!(
            "No shaper is needed: the drive alone keeps the residual vibration at or below {limit} over {range} ({worst} \
             at most)."
        )],
        true => vec![format!(
            "Take {name}: it keeps the residual vibration{behind} at or below {limit} over {range} ({worst} at most) and delays \
             the command by {cost}."
        )],
        false => vec![
            format!("None of these keeps the residual vibration{behind} at or below {limit} over {range}."),
            format!("{name} comes closest: {worst} at most, for a delay of {cost}."),
            match candidates.len() < Kind::ALL.len() {
                true => "To hold the limit, raise it, narrow the range, or compare all kinds.".to_owned(),
                false => "To hold the limit, raise it or narrow the range.".to_owned(),
            },
        ],
    };
    if bare {
        return sentences.concat();
    }
    if !choice.design.adds_up() {
        sentences.push(format!(
            "It is exact for changes of the command that do not meet: {} apart or more.",
            seconds(choice.delay + ramp_time(question))
        ));
    }
    if choice.exceeds_command() {
        sentences.push(format!("It has {}.", negative(choice)));
    }
    if let Some((name, other)) = found.runner_up.and_then(at) {
        let longer = other.delay - choice.delay;
        let length = if longer.abs() <= recommendation::AS_LONG * choice.delay.max(other.delay) {
            "about as long".to_owned()
        } else if longer > 0.0 {
            format!("{} longer", seconds(longer))
        } else {
            format!("{} shorter", seconds(-longer))
        };
        let holds = recommendation::holds(other, request.vibration_limit);
        let but = if found.holds && !holds { "but" } else { "and" };
        let with = if other.exceeds_command() { format!(", with {}", negative(other)) } else { String::new() };
        sentences.push(format!("Runner-up: {name}, {length}, {but} leaves up to {}{with}.", percent(other.worst())));
    }
    if let Some((name, other)) = found.quicker.and_then(at) {
        let sooner = seconds(choice.delay - other.delay);
        sentences.push(format!("{name} holds the limit too, {sooner} sooner, but has {}.", negative(other)));
    }
    if let Some((name, other)) = found.quickest.and_then(at) {
        let (cost, worst) = (seconds(other.delay), percent(other.worst()));
        sentences.push(format!("{name} would delay the command by {cost} only, and leave up to {worst}."));
    }
    sentences.extend(otherwise(question, choice, found.holds));
    sentences.join(" ")
}

/// How long the drive takes for the bare step: three time constants where it never ends (5.24).
fn ramp_time(question: &Question) -> f64 {
    match question.request.drive {
        Some(DriveStep { drive: Drive::RateLimit { acceleration }, velocity }) => velocity / acceleration,
        Some(DriveStep {
            drive: Drive::FirstOrder { acceleration_time_constant: up, braking_time_constant: down },
            ..
        }) => 3.0 * up.max(down),
        _ => 0.0,
    }
}

/// A range of lengths that makes this share of the frequency is better followed than endured.
const WIDE: f64 = 0.4;

/// What else there is to do than to take a robust shaper.
fn otherwise(question: &Question, choice: &Figures, holds: bool) -> Vec<String> {
    let request = &question.request;
    let mut sentences = Vec::new();
    let wide = |one: &UncertainMode| one.range.end() - one.range.start() > WIDE * (1.0 + 1e-9) * one.mode.frequency();
    if matches!(question.given, Given::Length { .. }) && request.modes.iter().any(wide) {
        sentences.push(
            "Where the length is measured, InputShaper can follow it (frequency_source = Length), and the range is only what \
             remains unknown."
                .to_owned(),
        );
    }
    if request.modes.len() > 1 && !holds && request.base_kinds == [Kind::ZV; 2] {
        sentences.push("Convolved can be made of more robust kinds than ZV (`--base-kind SI`).".to_owned());
    }
    // e^(−ζωt) falls to the limit, slowest where ω is least.
    let alone = |one: &UncertainMode| -request.vibration_limit.ln() / (one.mode.damping_ratio() * one.range.start());
    let alone = request.modes.iter().map(alone).fold(0.0, f64::max);
    if request.drive.is_none() && alone < choice.delay {
        sentences.push(format!(
            "But damping alone brings the vibration down to {} in {}, sooner than that shaper is done.",
            percent(request.vibration_limit),
            seconds(alone)
        ));
    }
    sentences
}

fn negative(figures: &Figures) -> String {
    format!(
        "negative impulses: the shaped command may reach {} times the command’s range, and the drive has to follow",
        significant(figures.gain, 3)
    )
}
