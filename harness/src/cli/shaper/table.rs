//! The comparison as a table, for the terminal and for the page.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

use swayless::report::Table;
use swayless::shapers::{Candidate, DriveStep, Figures, Ramps, UncertainMode};
use swayless_shaping::{Drive, Shaper};

use super::request::{Given, Question};
use super::words::{percent, seconds};
use crate::cli::console::{self, number, significant};

/// What is compared for, a line for each mode.
pub fn heading(question: &Question) -> Vec<String> {
    let modes = &question.request.modes;
    let line = |(place, UncertainMode { mode, range }): (usize, &UncertainMode)| {
        let name = if modes.len() > 1 { format!("Mode {}", place + 1) } else { "Mode".to_owned() };
        let frequency = mode.frequency();
        format!(
            "{name}: {} rad/s ({} Hz, period {}), damping ratio {}; range {}",
            number(frequency),
            number(frequency / TAU),
            seconds(mode.period()),
            number(mode.damping_ratio()),
            shown(question.given, range),
        )
    };
    let mut lines: Vec<String> = modes.iter().enumerate().map(line).collect();
    if let Given::Length { length, gravity } = question.given {
        lines.insert(0, format!("A load on {} m of cable, gravity {} m/s²", number(length), number(gravity)));
    }
    lines.extend(question.request.drive.map(|DriveStep { drive, velocity }| match drive {
        Drive::RateLimit { acceleration } => format!(
            "Drive: steps of {} m/s with at most {} m/s², in {}",
            number(velocity),
            number(acceleration),
            seconds(velocity / acceleration)
        ),
        Drive::FirstOrder { acceleration_time_constant, braking_time_constant } => format!(
            "Drive: speeds up with a time constant of {}, slows down with {}",
            seconds(acceleration_time_constant),
            seconds(braking_time_constant)
        ),
        Drive::Ideal | Drive::SecondOrder { .. } => format!("Drive: {drive:?}"),
    }));
    lines
}

/// A range of frequencies (rad/s) as the user gives them; where they come from a length, in rad/s.
fn shown(given: Given, range: &RangeInclusive<f64>) -> String {
    let (factor, unit) = match given {
        Given::Hertz => (1.0 / TAU, "Hz"),
        Given::Length { .. } | Given::Frequency => (1.0, "rad/s"),
    };
    format!("{} to {} {unit}", number(factor * range.start()), number(factor * range.end()))
}

/// The columns' headings, the kind's first.
fn header(question: &Question) -> Vec<String> {
    let modes = question.request.modes.len();
    let each = |name: &str| -> Vec<String> {
        if modes > 1 { (1..=modes).map(|mode| format!("{name} {mode}")).collect() } else { vec![name.to_owned()] }
    };
    let mut header = ["Kind", "Delay", "Periods", "Impulses"].map(str::to_owned).to_vec();
    ["V", "Worst V", "Insensitivity"].iter().for_each(|name| header.extend(each(name)));
    header.extend(["Step", "Gain"].map(str::to_owned));
    header.extend(has_ramps(question).then(|| "Ramps".to_owned()));
    header
}

fn row(question: &Question, candidate: &Candidate, figures: &Figures) -> Vec<String> {
    let mut row = vec![
        candidate.name(),
        seconds(figures.delay),
        format!("{:.3}", figures.delay / question.request.modes[0].mode.period()),
        figures.design.shaper().impulses().len().to_string(),
    ];
    row.extend(figures.modes.iter().map(|mode| percent(mode.residual)));
    row.extend(figures.modes.iter().map(|mode| percent(mode.worst.vibration)));
    row.extend(figures.modes.iter().map(|mode| match mode.insensitivity.is_finite() {
        true => format!("{:.4}", mode.insensitivity),
        false => "∞".to_owned(),
    }));
    let (least, greatest) = (figures.step.start(), figures.step.end());
    row.push(format!("{} to {}", significant(*least, 3), significant(*greatest, 3)));
    row.push(significant(figures.gain, 3));
    row.extend(figures.ramps.map(|ramps| ramps_name(ramps).to_owned()));
    row
}

/// Whether the drive makes ramps.
fn has_ramps(question: &Question) -> bool {
    question.request.drive.is_some_and(|step| matches!(step.drive, Drive::RateLimit { .. }))
}

/// What becomes of ramps, in a word.
pub fn ramps_name(ramps: Ramps) -> &'static str {
    match ramps {
        Ramps::Exact => "exact",
        Ramps::Apart => "apart",
        Ramps::Meet => "meet",
    }
}

/// For the page.
pub fn report(question: &Question, candidates: &[Candidate]) -> Table {
    let row = |candidate: &Candidate| Some(row(question, candidate, candidate.figures()?));
    let level = percent(question.request.level);
    let mut notes = vec![
        "Delay: how much later the shaped command is complete. Periods: the same over the period of the (first) mode. V: \
         residual vibration, of what the unshaped command leaves, at the mode’s frequency; worst V: the highest over its range."
            .to_owned(),
        format!(
            "Insensitivity: how wide the range with at most {level} of residual vibration is, over the mode’s frequency. \
             Step: between what values a shaped unit step moves. Gain: how far the shaped command may exceed the range of \
             any command."
        ),
    ];
    if question.request.drive.is_some() {
        notes.push("V, worst V and insensitivity are those behind the drive.".to_owned());
    }
    if has_ramps(question) {
        notes.push(
            "Ramps, which the drive makes of the impulses: exact: alike and apart, so that nothing is lost (Theorem 1); \
             apart: each over before the next begins (5.13); meet: the drive lags behind."
                .to_owned(),
        );
    }
    Table {
        title: "The shapers".to_owned(),
        header: header(question),
        rows: candidates.iter().filter_map(row).collect(),
        notes,
    }
}

/// For a terminal.
pub fn text(question: &Question, candidates: &[Candidate]) -> String {
    let Table { header, rows, notes, .. } = report(question, candidates);
    let mut table = console::table(header.clone(), 1..header.len());
    table.add_rows(rows);
    format!(
        "{}\n\n{}",
        table.trim_fmt(),
        notes.iter().map(|note| console::paragraph(note)).collect::<Vec<_>>().join("\n")
    )
}

/// The impulses of a kind's trains.
pub fn impulses(candidate: &Candidate, figures: &Figures) -> String {
    let train = |what: &str, shaper: &Shaper| {
        let mut table = console::table([what, "Time (s)", "Amplitude"], 1..3);
        for (place, impulse) in shaper.impulses().iter().enumerate() {
            table.add_row([
                (place + 1).to_string(),
                format!("{:.6}", impulse.time),
                format!("{:.6}", impulse.amplitude),
            ]);
        }
        table.trim_fmt()
    };
    let name = candidate.name();
    match figures.design.braking() {
        None => train(&name, figures.design.shaper()),
        Some(braking) => [
            train(&format!("{name}, accelerating"), figures.design.shaper()),
            train(&format!("{name}, braking"), braking),
        ]
        .join("\n\n"),
    }
}
