//! Gets the recorded variables at a communication point and hands them to the observer.

use std::collections::HashSet;

use super::layout::{Slots, batches, declared_start, whole};
use super::store::{Batch, Store};
use super::{Run, failed};
use crate::error::{Error, Result};
use crate::recorder::{Column, Observer, Value};
use crate::system::{Kind, Names, Port, System, Wiring};

/// The recorded variables.
pub(crate) struct Sampler {
    columns: Vec<Column>,
    cells: Vec<Cell>,
    batches: Vec<(usize, Batch)>,
    got: Store,
    row: Vec<Value>,
}

/// Where a column's value is found.
struct Cell {
    kind: Kind,
    slot: usize,
    /// Among the inputs of the run rather than among the values got for the sampler: what an input is at this point is
    /// known before the FMU is told.
    is_input: bool,
}

impl Sampler {
    /// For variables by name, or all outputs when none is named.
    pub(crate) fn new(system: &System, wiring: &Wiring, run: &Run, variables: &[String]) -> Result<Self> {
        let names = &wiring.names;
        let mut errors = Vec::new();
        let mut ports = Vec::new();
        let behind = |name: &String| system.connectors.get(name).cloned().unwrap_or_else(|| vec![name.clone()]);
        for name in variables.iter().flat_map(behind) {
            match names.find(&name, "output variables") {
                Ok(port) if Kind::of(names.variable(port).data_type).is_none() => {
                    let data_type = names.variable(port).data_type;
                    errors.push(Error::Option(format!(
                        "output variables: `{name}` is {data_type:?}, which is not recorded"
                    )));
                }
                Ok(port) => ports.push(port),
                Err(error) => errors.push(error),
            }
        }
        Error::all(errors)?;
        if variables.is_empty() {
            ports = names.outputs();
        }
        let is_input = |port: Port| run.input_slot(&names.name(port));

        let (mut got, mut slots) = (Store::default(), Slots::default());
        let mut all = Vec::new();
        for instance in 0..run.count() {
            let variables = whole(instance, ports.iter().copied());
            let of_instance = batches(names, &variables, &mut got, &mut slots, |port| declared_start(names, port));
            all.extend(of_instance.into_iter().map(|batch| (instance, batch)));
        }
        // What is named twice, or as an array and as its element, is one column.
        let mut seen = HashSet::new();
        let scalars: Vec<Port> =
            ports.iter().flat_map(|&port| scalars(names, port)).filter(|&port| seen.insert(port)).collect();
        let cells: Vec<Cell> = scalars
            .iter()
            .filter_map(|&port| {
                let kind = Kind::of(names.variable(port).data_type)?;
                Some(match is_input(port) {
                    Some(slot) => Cell { kind, slot, is_input: true },
                    None => Cell { kind, slot: slots.of(port), is_input: false },
                })
            })
            .collect();
        let columns = scalars.iter().map(|&port| column(names, port)).collect();
        let row = cells
            .iter()
            .map(|cell| match cell.kind {
                Kind::Float => Value::Float(0.0),
                Kind::Integer => Value::Integer(0),
                Kind::Boolean => Value::Boolean(false),
                Kind::String => Value::String(String::new()),
            })
            .collect();
        Ok(Self { columns, cells, batches: all, got, row })
    }

    /// The columns, in the order of the values of a sample.
    pub(crate) fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Takes a sample, with the inputs that follow from the present outputs.
    pub(crate) fn sample(&mut self, run: &mut Run, time: f64, observer: &mut dyn Observer) -> Result<()> {
        run.take_signals(time);
        (0..run.count()).try_for_each(|instance| run.transfer(instance, time))?;
        for (instance, batch) in &self.batches {
            let instance = &mut run.instances[*instance];
            let got = batch.get(&mut *instance.slave, &mut self.got);
            got.map_err(|failure| failed(&instance.name, Some(time), failure))?;
        }
        for (value, cell) in self.row.iter_mut().zip(&self.cells) {
            let store = if cell.is_input { &run.inputs } else { &self.got };
            match value {
                Value::Float(value) => *value = store.floats[cell.slot],
                Value::Integer(value) => *value = store.integers[cell.slot],
                Value::Boolean(value) => *value = store.booleans[cell.slot],
                Value::String(value) => value.clone_from(&store.strings[cell.slot]),
            }
        }
        observer.sample(time, &self.row)
    }
}

fn scalars(names: &Names, port: Port) -> Vec<Port> {
    if port.element.is_some() || names.dimensions(port.instance, port.variable).is_empty() {
        return vec![port];
    }
    (0..names.size(port)).map(|element| Port { element: Some(element), ..port }).collect()
}

fn column(names: &Names, port: Port) -> Column {
    let variable = names.variable(port);
    Column {
        name: names.name(port),
        unit: names.unit(port).map(str::to_owned),
        description: variable.description.clone(),
        data_type: variable.data_type,
    }
}
