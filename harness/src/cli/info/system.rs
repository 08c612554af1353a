//! What a system consists of.

use serde_json::{Value as Json, json};
use swayless::System;

use super::super::{Failure, console};

/// Instances, connections and start values as tables.
pub fn print(system: &System) -> Result<(), Failure> {
    console::print(format_args!("{}\n", system.name))?;
    let mut table = console::table(["Instance", "Model", "FMU"], []);
    for instance in system.instances() {
        let path = instance.model.path().display().to_string();
        table.add_row([&instance.name, &instance.model.description().model_name, &path]);
    }
    console::print(format_args!("{}\n", table.trim_fmt()))?;
    let mut table = console::table(["From", "To"], []);
    for connection in system.connections() {
        table.add_row([&connection.from, &connection.to]);
    }
    console::print(format_args!("{}\n", table.trim_fmt()))?;
    let mut table = console::table(["Start value", "", "Unit"], [1]);
    for start in system.start_values() {
        table.add_row([&start.variable, &start.value, start.unit.as_deref().unwrap_or_default()]);
    }
    console::print(table.trim_fmt())
}

/// The same as JSON.
pub fn json(system: &System) -> Json {
    let instances: Vec<Json> = system
        .instances()
        .iter()
        .map(|i| json!({ "name": i.name, "model": i.model.description().model_name, "fmu": i.model.path() }))
        .collect();
    let connections: Vec<Json> = system
        .connections()
        .iter()
        .map(|c| json!({ "from": c.from, "to": c.to, "factor": c.factor, "offset": c.offset }))
        .collect();
    let starts: Vec<Json> = system
        .start_values()
        .iter()
        .map(|s| json!({ "variable": s.variable, "value": s.value, "unit": s.unit }))
        .collect();
    json!({ "name": system.name, "instances": instances, "connections": connections, "startValues": starts })
}
