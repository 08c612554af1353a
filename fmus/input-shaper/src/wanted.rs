//! What the parameters ask for, and which of them to change where that has no design.

use swayless_export::Problem;
use swayless_shaping::{Mode, ModeError, Quantity, Specification, SpecificationError, double_pendulum, pendulum};

use crate::variables::{FrequencySource, Kind, Parameters};

/// Why there is no design.
#[derive(Debug, Clone, Copy)]
pub enum Refusal {
    /// A mode, counted from 0, is none.
    Mode(usize, ModeError),
    /// The vibration limit is less than SI is designed for.
    Limit(f64),
    /// The rest.
    Specification(SpecificationError),
}

/// The least vibration limit of SI: with less, a design may take seconds.
const LEAST_SPECIFIED: f64 = 0.005;

/// What is wanted at a suspension length.
pub fn wanted(p: &Parameters<f64>, length: f64) -> Result<Specification, Refusal> {
    let mut modes = [None; 2];
    if p.kind != Kind::None {
        let frequencies = frequencies(p, length);
        for (i, mode) in modes.iter_mut().enumerate() {
            if i == 0 || frequencies[i] != 0.0 {
                let found = Mode::new(frequencies[i], p.mode.damping_ratio[i]);
                *mode = Some(found.map_err(|error| Refusal::Mode(i, error))?);
            }
        }
    }
    let specified = matches!(p.kind, Kind::SI | Kind::ALSI | Kind::MultiModeSI)
        || (p.kind == Kind::Convolved && p.base_kind.contains(&Kind::SI));
    if specified && p.vibration_limit < LEAST_SPECIFIED {
        return Err(Refusal::Limit(p.vibration_limit));
    }
    Ok(Specification {
        kind: kind(if modes[1].is_none() { for_one_mode(p) } else { p.kind }),
        modes,
        vibration_limit: p.vibration_limit,
        insensitivity: p.insensitivity,
        acceleration_limit: p.acceleration_limit,
        velocity_limit: p.velocity_limit,
        acceleration_time_constant: p.acceleration_time_constant,
        braking_time_constant: p.braking_time_constant,
        base_kinds: p.base_kind.map(kind),
        // the least is 1
        solution: p.solution.unsigned_abs() as usize,
    })
}

/// What is wanted for a change of the command, where a kind is designed for each.
pub fn wanted_for(p: &Parameters<f64>, wanted: &Specification, change: f64) -> Option<Specification> {
    let limited =
        matches!(p.kind, Kind::ALZVD | Kind::ALEI | Kind::ALSI) && p.redesign && change.abs() < p.velocity_limit;
    limited.then(|| Specification { velocity_limit: change.abs(), ..*wanted })
}

/// The kind, and what that of two modes is where there is but one.
fn for_one_mode(p: &Parameters<f64>) -> Kind {
    match p.kind {
        Kind::Convolved if !has_two_modes(p.base_kind[0]) => p.base_kind[0],
        Kind::MinimumImpulse => Kind::ZV,
        Kind::MultiModeSI => Kind::SI,
        kind => kind,
    }
}

/// Whether the kind is for two modes.
fn has_two_modes(kind: Kind) -> bool {
    matches!(kind, Kind::Convolved | Kind::MinimumImpulse | Kind::MultiModeSI)
}

/// ω of both modes (rad/s); 0 where there is none.
fn frequencies(p: &Parameters<f64>, length: f64) -> [f64; 2] {
    match p.frequency_source {
        FrequencySource::Parameter => p.mode.frequency,
        FrequencySource::Length if p.rigging.length > 0.0 && p.mass_ratio > 0.0 => {
            let [slow, fast] = double_pendulum(p.gravity, length, p.rigging.length, p.mass_ratio);
            [slow, if has_two_modes(p.kind) { fast } else { 0.0 }]
        }
        FrequencySource::Length => [pendulum(p.gravity, length), 0.0],
    }
}

fn kind(kind: Kind) -> swayless_shaping::Kind {
    match kind {
        Kind::None => swayless_shaping::Kind::None,
        Kind::ZV => swayless_shaping::Kind::ZV,
        Kind::ZVD => swayless_shaping::Kind::ZVD,
        Kind::ZVDD => swayless_shaping::Kind::ZVDD,
        Kind::ZVDDD => swayless_shaping::Kind::ZVDDD,
        Kind::EI => swayless_shaping::Kind::EI,
        Kind::TwoHumpEI => swayless_shaping::Kind::TwoHumpEI,
        Kind::ThreeHumpEI => swayless_shaping::Kind::ThreeHumpEI,
        Kind::SI => swayless_shaping::Kind::SI,
        Kind::UMZV => swayless_shaping::Kind::UMZV,
        Kind::UMZVD => swayless_shaping::Kind::UMZVD,
        Kind::UMEI => swayless_shaping::Kind::UMEI,
        Kind::UMZVc => swayless_shaping::Kind::UMZVc,
        Kind::ALZVD => swayless_shaping::Kind::ALZVD,
        Kind::ALEI => swayless_shaping::Kind::ALEI,
        Kind::ALSI => swayless_shaping::Kind::ALSI,
        Kind::Convolved => swayless_shaping::Kind::Convolved,
        Kind::MinimumImpulse => swayless_shaping::Kind::MinimumImpulse,
        Kind::MultiModeSI => swayless_shaping::Kind::MultiModeSI,
    }
}

/// A length to ask at for frequencies that follow it (m): what it is in the run is not known before.
const SOME_LENGTH: f64 = 10.0;

/// What is wrong with the parameters.
pub fn check(p: &Parameters<f64>) -> Vec<Problem> {
    let mut problems = Vec::new();
    if p.sample_time > 0.0 && p.sample_time < SHORTEST {
        let message = format!("is {} s; it must be 0 or at least {SHORTEST} s", p.sample_time);
        problems.push(Problem::new("sample_time", message));
    }
    let wanted = wanted(p, SOME_LENGTH);
    let has_second = wanted.map_or(true, |wanted| wanted.modes[1].is_some());
    if !has_second && p.mode.damping_ratio[1] != 0.0 {
        let message = format!("is {}, but there is no second mode; it must be 0", p.mode.damping_ratio[1]);
        problems.push(Problem::new("mode.damping_ratio[2]", message));
    }
    if let Err(refusal) = wanted.and_then(|wanted| wanted.design().map_err(Refusal::Specification)) {
        problems.extend(refusal.problem(p));
    }
    problems
}

/// No command is looked at more often (s): a second of it still takes but a moment to compute.
const SHORTEST: f64 = 1e-5;

impl Refusal {
    /// The problem; none where another length may have a design.
    fn problem(&self, p: &Parameters<f64>) -> Option<Problem> {
        let follows = p.frequency_source == FrequencySource::Length;
        let (quantity, reason) = match self {
            Self::Mode(mode, error) => match error {
                ModeError::Frequency { .. } => (Quantity::Frequency(*mode), error.to_string()),
                ModeError::DampingRatio { .. } => (Quantity::DampingRatio(*mode), error.to_string()),
            },
            Self::Limit(limit) => {
                let reason = format!("it is {limit}; for SI it must be at least {LEAST_SPECIFIED}");
                (Quantity::VibrationLimit, reason)
            }
            Self::Specification(error) => (error.quantity(), error.to_string()),
        };
        let depends_on_frequency = match quantity {
            Quantity::Frequency(_) => !matches!(self, Self::Specification(SpecificationError::MissingMode { .. })),
            Quantity::AccelerationLimit
            | Quantity::VelocityLimit
            | Quantity::AccelerationTimeConstant
            | Quantity::BrakingTimeConstant
            | Quantity::Solution => true,
            _ => false,
        };
        let name = match quantity {
            Quantity::Kind => "kind".to_owned(),
            Quantity::Frequency(_) if follows => "rigging.length".to_owned(),
            Quantity::Frequency(mode) => format!("mode.frequency[{}]", mode + 1),
            Quantity::DampingRatio(mode) => format!("mode.damping_ratio[{}]", mode + 1),
            Quantity::VibrationLimit => "vibration_limit".to_owned(),
            Quantity::Insensitivity => "insensitivity".to_owned(),
            Quantity::AccelerationLimit => "acceleration_limit".to_owned(),
            Quantity::VelocityLimit => "velocity_limit".to_owned(),
            Quantity::AccelerationTimeConstant => "acceleration_time_constant".to_owned(),
            Quantity::BrakingTimeConstant => "braking_time_constant".to_owned(),
            Quantity::BaseKind(mode) => format!("base_kind[{}]", mode + 1),
            Quantity::Solution => "solution".to_owned(),
        };
        let possible = follows && depends_on_frequency;
        (!possible).then(|| Problem::new(name, format!("cannot be used: {reason}")))
    }
}
