//! A shaper as values of the parameters of `InputShaper`.

use serde_json::{Value as Json, json};
use swayless::shapers::Candidate;
use swayless::shapers::candidate::{needs_acceleration_limit, needs_insensitivity, needs_vibration_limit};
use swayless_modeldesc::ssp::{Parameter, ParameterSet, SspVersion, Value, write_parameters};
use swayless_modeldesc::types::DataType;
use swayless_shaping::{Kind, Mode};

use crate::cli::Failure;

/// The parameters that the shaper depends on.
pub fn of(candidate: &Candidate) -> Vec<Parameter> {
    let wanted = &candidate.specification;
    let mut list = vec![item("kind", "The kind of shaper", candidate.kind)];
    let modes: Vec<&Mode> = wanted.modes.iter().flatten().filter(|_| candidate.kind != Kind::None).collect();
    for (place, mode) in modes.iter().enumerate() {
        let of = |name: &str| format!("mode.{name}[{}]", place + 1);
        list.push(real(
            &of("frequency"),
            "Undamped natural frequency that it is designed for",
            mode.frequency(),
            "rad/s",
        ));
        list.push(real(&of("damping_ratio"), "Damping ratio that it is designed for", mode.damping_ratio(), "1"));
    }
    let kind = candidate.kind;
    if needs_vibration_limit(kind) || kind == Kind::Convolved {
        list.push(real("vibration_limit", "Residual vibration that is allowed", wanted.vibration_limit, "1"));
    }
    let is_for_range = |kind: &Kind| needs_insensitivity(*kind);
    if is_for_range(&kind) || (kind == Kind::Convolved && wanted.base_kinds.iter().any(is_for_range)) {
        let what = "Full width of the range of frequencies, over the frequency";
        list.push(real("insensitivity", what, wanted.insensitivity, "1"));
    }
    if needs_acceleration_limit(kind) {
        list.push(real("acceleration_limit", "Acceleration limit of the drive", wanted.acceleration_limit, ""));
        list.push(real("velocity_limit", "Largest step of the command", wanted.velocity_limit, ""));
    }
    match kind {
        Kind::UMZVc => {
            let (up, down) = (wanted.acceleration_time_constant, wanted.braking_time_constant);
            list.push(real("acceleration_time_constant", "Time constant with which the drive speeds up", up, "s"));
            list.push(real("braking_time_constant", "Time constant with which the drive slows down", down, "s"));
        }
        Kind::Convolved => {
            for (place, kind) in wanted.base_kinds.into_iter().enumerate() {
                list.push(item(&format!("base_kind[{}]", place + 1), "The kind for this mode", kind));
            }
        }
        Kind::MinimumImpulse => list.push(Parameter {
            data_type: DataType::Int32,
            value: Value::Integer(vec![wanted.solution as i128]),
            ..item("solution", "Which of the solutions, the shortest first", candidate.kind)
        }),
        _ => {}
    }
    list
}

fn item(name: &str, description: &str, kind: Kind) -> Parameter {
    Parameter {
        name: name.to_owned(),
        description: Some(description.to_owned()),
        data_type: DataType::Enumeration,
        value: Value::Enumeration(vec![kind.name().to_owned()]),
        unit: None,
        enumeration: None,
        dimensions: Vec::new(),
        line: 0,
    }
}

/// A number; an empty unit is none.
fn real(name: &str, description: &str, value: f64, unit: &str) -> Parameter {
    Parameter {
        data_type: DataType::Float64,
        value: Value::Float(vec![value]),
        unit: (!unit.is_empty()).then(|| unit.to_owned()),
        ..item(name, description, Kind::None)
    }
}

/// In a line to be copied from.
pub fn line(candidate: &Candidate) -> String {
    let each = |parameter: &Parameter| format!("{} = {}", parameter.name, parameter.value);
    format!("InputShaper: {}", of(candidate).iter().map(each).collect::<Vec<_>>().join(", "))
}

/// One of them as JSON.
pub fn json(parameter: &Parameter) -> Json {
    match &parameter.value {
        Value::Float(values) => json!(values.first()),
        Value::Integer(values) => json!(values.first().map(|value| *value as i64)),
        other => json!(other.to_string()),
    }
}

/// As the text of a parameter set.
pub fn set(candidate: &Candidate) -> Result<String, Failure> {
    let set = ParameterSet {
        version: SspVersion::V1,
        name: candidate.kind.name().to_owned(),
        description: Some(format!("{} for an InputShaper", candidate.name())),
        parameters: of(candidate),
        enumerations: Vec::new(),
        units: Vec::new(),
    };
    Ok(write_parameters(&set)?)
}
