//! The comparison as JSON; docs/shaper.md says what it holds.

use serde_json::{Map, Value as Json, json};
use swayless::shapers::{Candidate, DriveStep, Figures, OfMode, Recommendation, UncertainMode};
use swayless_shaping::{Drive, Shaper};

use super::request::Question;
use super::{parameters, table, words};

pub fn json(question: &Question, candidates: &[Candidate], found: Option<Recommendation>) -> Json {
    let request = &question.request;
    let shapers: Vec<Json> = candidates.iter().filter_map(|one| Some(shaper(one, one.figures()?))).collect();
    let refused = |one: &Candidate| Some(json!({ "kind": one.kind.name(), "reason": words::refusal(one)? }));
    json!({
        "modes": request.modes.iter().map(mode).collect::<Vec<_>>(),
        "vibration_limit": request.vibration_limit,
        "level": request.level,
        "drive": request.drive.map(drive),
        "shapers": shapers,
        "refused": candidates.iter().filter_map(refused).collect::<Vec<_>>(),
        "recommendation": found.map(|found| recommendation(question, candidates, found)),
    })
}

fn mode(UncertainMode { mode, range }: &UncertainMode) -> Json {
    json!({
        "frequency": mode.frequency(),
        "damping_ratio": mode.damping_ratio(),
        "period": mode.period(),
        "range": { "low": range.start(), "high": range.end() },
    })
}

fn drive(step: DriveStep) -> Json {
    match step.drive {
        Drive::RateLimit { acceleration } => {
            json!({ "acceleration_limit": acceleration, "velocity_limit": step.velocity })
        }
        Drive::FirstOrder { acceleration_time_constant, braking_time_constant } => json!({
            "acceleration_time_constant": acceleration_time_constant, "braking_time_constant": braking_time_constant,
        }),
        Drive::Ideal | Drive::SecondOrder { .. } => Json::Null,
    }
}

fn shaper(candidate: &Candidate, figures: &Figures) -> Json {
    let of_mode = |mode: &OfMode| -> Json {
        json!({
            "residual": mode.residual,
            "worst": { "frequency": mode.worst.frequency, "residual": mode.worst.vibration },
            // null where it has no end
            "insensitivity": mode.insensitivity,
        })
    };
    let parameters: Map<String, Json> = parameters::of(candidate)
        .into_iter()
        .map(|parameter| (parameter.name.clone(), parameters::json(&parameter)))
        .collect();
    json!({
        "kind": candidate.kind.name(),
        "name": candidate.name(),
        "duration": figures.design.duration(),
        "delay": figures.delay,
        "adds_up": figures.design.adds_up(),
        "impulses": impulses(figures.design.shaper()),
        "braking_impulses": figures.design.braking().map(impulses),
        "modes": figures.modes.iter().map(of_mode).collect::<Vec<_>>(),
        "without_drive": figures.without_drive.iter().map(of_mode).collect::<Vec<_>>(),
        "ramps": figures.ramps.map(table::ramps_name),
        "step": { "least": figures.step.start(), "greatest": figures.step.end() },
        "gain": figures.gain,
        "exceeds_command": figures.exceeds_command(),
        "parameters": parameters,
    })
}

fn impulses(shaper: &Shaper) -> Json {
    shaper.impulses().iter().map(|impulse| json!({ "time": impulse.time, "amplitude": impulse.amplitude })).collect()
}

fn recommendation(question: &Question, candidates: &[Candidate], found: Recommendation) -> Json {
    let name = |place: Option<usize>| place.map(|place| candidates[place].kind.name());
    json!({
        "choice": name(Some(found.choice)),
        "holds": found.holds,
        "runner_up": name(found.runner_up),
        "quicker": name(found.quicker),
        "quickest": name(found.quickest),
        "text": words::recommendation(question, candidates, found),
    })
}
