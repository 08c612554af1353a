//! From the arguments to what shapers are compared for.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

use swayless::Error;
use swayless::shapers::{DriveStep, Request, UncertainMode};
use swayless_shaping::{Band, Drive, Kind, Mode, double_pendulum, pendulum};

use super::Arguments;
use super::check::Check;
use crate::cli::console::number;

/// What is asked, and the words it was asked in.
pub struct Question {
    pub request: Request,
    pub given: Given,
}

/// What the modes and their ranges were given as.
#[derive(Clone, Copy, PartialEq)]
pub enum Given {
    /// The length (m) of a cable under gravity (m/s²).
    Length { length: f64, gravity: f64 },
    /// rad/s.
    Frequency,
    /// Hz.
    Hertz,
}

/// What `InputShaper` takes as a vibration limit with any kind, and as an insensitivity at most.
const VIBRATION_LIMITS: RangeInclusive<f64> = 0.005..=0.5;
const WIDEST: f64 = 1.5;

/// Ranges may go so far from the mode's frequency, as a factor: where insensitivity stops looking, too.
const FARTHEST: f64 = 20.0;

/// A drive that takes so many periods does not make anything swing.
const SLOWEST: f64 = 100.0;

/// What swings with more damping than this hardly swings.
const HIGHEST_DAMPING: f64 = 0.99;

/// A range as it is written.
pub fn range(text: &str) -> Result<(f64, f64), String> {
    let (low, high) = text.split_once("..").ok_or("expected LOW..HIGH, such as 8..12")?;
    let number = |text: &str| text.trim().parse::<f64>().map_err(|_| format!("`{text}` is no number"));
    Ok((number(low)?, number(high)?))
}

impl Question {
    /// Checks all arguments; tells all that is wrong.
    pub fn of(arguments: &Arguments) -> Result<Self, Error> {
        let mut check = Check::default();
        let given = match arguments.length {
            Some(length) => Given::Length { length, gravity: arguments.gravity },
            None if arguments.hertz.is_empty() => Given::Frequency,
            None => Given::Hertz,
        };
        check.positive("--gravity", arguments.gravity, "m/s²");
        if !VIBRATION_LIMITS.contains(&arguments.vibration_limit) {
            let (least, most) = (VIBRATION_LIMITS.start(), VIBRATION_LIMITS.end());
            let text = format!("must be at least {least} and at most {most}; 0.05 is 5 %");
            check.wrong("--vibration-limit", arguments.vibration_limit, &text);
        }
        let level = arguments.level.unwrap_or(arguments.vibration_limit);
        arguments.level.iter().for_each(|level| check.share("--level", *level));
        if !(0.0..=WIDEST).contains(&arguments.insensitivity) {
            let text = format!("must be at least 0 and at most {WIDEST}; 0.4 is ±20 %");
            check.wrong("--insensitivity", arguments.insensitivity, &text);
        }
        for damping in &arguments.damping {
            if !(0.0..=HIGHEST_DAMPING).contains(damping) {
                let text =
                    format!("must be at least 0 and at most {HIGHEST_DAMPING}; a load on a cable has about 0.01");
                check.wrong("--damping", damping, &text);
            }
        }
        if arguments.base_kind.len() > 2 {
            let text = format!("is given {} times; a shaper is for one mode or two", arguments.base_kind.len());
            check.problem("--base-kind", &text);
        }
        let drive = drive(arguments, &mut check);
        let frequencies = frequencies(arguments, &mut check);
        check.all()?;
        let mut modes = Vec::new();
        if arguments.damping.len() > frequencies.len().max(1) {
            let text = format!(
                "is given {} times, for {} mode(s); give one for each",
                arguments.damping.len(),
                frequencies.len()
            );
            check.problem("--damping", &text);
        }
        for (place, (option, value, frequency)) in frequencies.iter().enumerate() {
            let damping = arguments.damping.get(place).or(arguments.damping.first()).copied().unwrap_or_default();
            match Mode::new(*frequency, damping) {
                Ok(mode) => modes.push(mode),
                Err(error) => {
                    let gravity = match given {
                        Given::Length { gravity, .. } => format!("` with `--gravity {gravity}"),
                        _ => String::new(),
                    };
                    check.wrong(option, format!("{value}{gravity}"), &error.to_string());
                }
            }
        }
        check.all()?;
        slowest(drive, &modes, &mut check);
        let modes = ranges(arguments, given, &modes, &mut check);
        check.all()?;
        let kinds = if arguments.kind.is_empty() { Kind::ALL.to_vec() } else { unique(&arguments.kind) };
        let base_kinds = match arguments.base_kind.as_slice() {
            [] => [Kind::ZV; 2],
            [both] => [*both; 2],
            [first, second, ..] => [*first, *second],
        };
        let solution = arguments.solution;
        let vibration_limit = arguments.vibration_limit;
        let request = Request { modes, vibration_limit, level, base_kinds, solution, drive, kinds };
        Ok(Self { request, given })
    }
}

fn drive(arguments: &Arguments, check: &mut Check) -> Option<DriveStep> {
    let constants = [arguments.acceleration_time_constant, arguments.braking_time_constant];
    match (arguments.acceleration_limit, arguments.velocity_limit, constants) {
        (Some(acceleration), Some(velocity), _) => {
            check.positive("--acceleration-limit", acceleration, "m/s²");
            check.positive("--velocity-limit", velocity, "m/s");
            Some(DriveStep { drive: Drive::RateLimit { acceleration }, velocity })
        }
        (_, _, [Some(acceleration_time_constant), Some(braking_time_constant)]) => {
            check.time("--acceleration-time-constant", acceleration_time_constant);
            check.time("--braking-time-constant", braking_time_constant);
            let drive = Drive::FirstOrder { acceleration_time_constant, braking_time_constant };
            Some(DriveStep { drive, velocity: 1.0 })
        }
        // One of a pair without the other is not let pass.
        _ => None,
    }
}

/// Checks that the drive has to do with the modes.
fn slowest(drive: Option<DriveStep>, modes: &[Mode], check: &mut Check) {
    let shortest = modes.iter().map(|mode| mode.period()).fold(f64::INFINITY, f64::min);
    let mut too_slow = |option: &str, value: f64, time: f64| {
        if time > SLOWEST * shortest {
            let text = format!("the drive takes {time} s, more than {SLOWEST} periods of the mode; make it quicker");
            check.wrong(option, value, &text);
        }
    };
    match drive {
        Some(DriveStep { drive: Drive::RateLimit { acceleration }, velocity }) => {
            too_slow("--acceleration-limit", acceleration, velocity / acceleration);
        }
        Some(DriveStep { drive: Drive::FirstOrder { acceleration_time_constant, braking_time_constant }, .. }) => {
            too_slow("--acceleration-time-constant", acceleration_time_constant, acceleration_time_constant);
            too_slow("--braking-time-constant", braking_time_constant, braking_time_constant);
        }
        _ => {}
    }
}

fn unique(kinds: &[Kind]) -> Vec<Kind> {
    let mut found = Vec::new();
    for kind in kinds {
        if !found.contains(kind) {
            found.push(*kind);
        }
    }
    found
}

/// The modes' frequencies in rad/s, each with the option and the value that it comes from.
fn frequencies(arguments: &Arguments, check: &mut Check) -> Vec<(&'static str, f64, f64)> {
    if let Some(length) = arguments.length {
        check.positive("--length", length, "m");
        if let (Some(rigging), Some(ratio)) = (arguments.rigging_length, arguments.mass_ratio) {
            check.positive("--rigging-length", rigging, "m");
            if !(ratio >= 0.0 && ratio.is_finite()) {
                check.wrong("--mass-ratio", ratio, "must be finite and at least 0");
            }
        }
        return of_length(arguments, length).into_iter().map(|frequency| ("--length", length, frequency)).collect();
    }
    let (option, unit, values) = match arguments.hertz.is_empty() {
        true => ("--frequency", "rad/s", &arguments.frequency),
        false => ("--hertz", "Hz", &arguments.hertz),
    };
    if values.len() > 2 {
        check.problem(option, &format!("is given {} times; a shaper is for one mode or two", values.len()));
    }
    values.iter().for_each(|value| check.positive(option, *value, unit));
    let factor = if option == "--hertz" { TAU } else { 1.0 };
    values.iter().map(|value| (option, *value, factor * value)).collect()
}

/// The frequencies of the modes at a length of the cable.
fn of_length(arguments: &Arguments, length: f64) -> Vec<f64> {
    match (arguments.rigging_length, arguments.mass_ratio) {
        // Nothing hangs below the hook where the payload has no mass, for InputShaper and BridgeCrane neither.
        (Some(rigging), Some(ratio)) if ratio != 0.0 => {
            double_pendulum(arguments.gravity, length, rigging, ratio).to_vec()
        }
        _ => vec![pendulum(arguments.gravity, length)],
    }
}

/// The modes with their ranges.
fn ranges(arguments: &Arguments, given: Given, modes: &[Mode], check: &mut Check) -> Vec<UncertainMode> {
    let needed = if matches!(given, Given::Length { .. }) { 1 } else { modes.len() };
    if !arguments.range.is_empty() && arguments.range.len() != needed {
        let text = format!(
            "is given {} time(s); it must be given {needed} time(s), in the order of the modes",
            arguments.range.len()
        );
        check.problem("--range", &text);
        return Vec::new();
    }
    for (low, high) in &arguments.range {
        if !(*low > 0.0 && low <= high && high.is_finite()) {
            check.wrong("--range", format!("{low}..{high}"), "must be greater than 0 and finite, the lower end first");
            return Vec::new();
        }
    }
    let mut uncertain = Vec::new();
    for (place, &mode) in modes.iter().enumerate() {
        let range = match (given, arguments.range.as_slice()) {
            (_, []) => around(mode, arguments.insensitivity),
            // The longer the slower.
            (Given::Length { .. }, [(low, high), ..]) => {
                of_length(arguments, *high)[place]..=of_length(arguments, *low)[place]
            }
            (Given::Frequency, all) => all[place].0..=all[place].1,
            (Given::Hertz, all) => TAU * all[place].0..=TAU * all[place].1,
        };
        let near = mode.frequency() / FARTHEST..=mode.frequency() * FARTHEST;
        let low = mode.frequency().min(*range.start());
        let is_near = [range.start(), range.end()].iter().all(|end| near.contains(end));
        let given_range = arguments.range.get(place.min(needed - 1));
        if let Some((low, high)) = given_range.filter(|_| !is_near) {
            let rate = number(mode.frequency());
            let text = format!("goes more than {FARTHEST} times from the mode's {rate} rad/s; bring it nearer");
            check.wrong("--range", format!("{low}..{high}"), &text);
        } else if let Some((low, high)) = given_range.filter(|_| place < needed && !range.contains(&mode.frequency())) {
            let what = if matches!(given, Given::Length { .. }) { "length" } else { "mode's frequency" };
            let text = format!(
                "does not hold the {what} itself, for which the shapers are designed; move the one or the other"
            );
            check.wrong("--range", format!("{low}..{high}"), &text);
        } else if let (Some((low, high)), true) =
            (given_range, 2.0 * (range.end() - range.start()) > WIDEST * (range.end() + range.start()))
        {
            let text = format!(
                "is wider than {WIDEST} times the frequency in its middle; no shaper is made for that: narrow it"
            );
            check.wrong("--range", format!("{low}..{high}"), &text);
        } else if Mode::new(low, mode.damping_ratio()).is_err() {
            check.wrong(
                "--insensitivity",
                arguments.insensitivity,
                "makes a range that ends at no usable frequency; lower it",
            );
        }
        uncertain.push(UncertainMode { mode, range });
    }
    uncertain
}

fn around(mode: Mode, insensitivity: f64) -> RangeInclusive<f64> {
    // The insensitivity has been checked.
    Band::around(mode.frequency(), insensitivity)
        .map_or(mode.frequency()..=mode.frequency(), |band| band.lower..=band.upper)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_split_at_two_dots() {
        assert_eq!(range("8..12"), Ok((8.0, 12.0)));
        assert_eq!(range(" 0.5 .. 1e1"), Ok((0.5, 10.0)));
        assert!(range("8-12").is_err() && range("8..x").is_err() && range("..").is_err());
    }
}
