//! Lays the buffers out: gives every value that is exchanged a slot, and gathers the calls that get and set them.

use std::collections::BTreeMap;

use swayless_modeldesc::types::DataType;

use super::store::{Batch, Drive, ScaledWay, Store, Transfers, Way};
use crate::system::{Kind, Names, Port, Values, Wiring, declared};

/// Slots of whole variables in one store.
#[derive(Debug, Default)]
pub(super) struct Slots {
    first: BTreeMap<Port, usize>,
}

impl Slots {
    /// The slot of a port, or of its first element.
    pub(super) fn of(&self, port: Port) -> usize {
        self.first[&Port { element: None, ..port }] + port.element.unwrap_or(0)
    }
}

/// All types whose values take part in a run, in the order in which they are got and set.
const TYPES: [DataType; 13] = [
    DataType::Float64,
    DataType::Float32,
    DataType::Int8,
    DataType::UInt8,
    DataType::Int16,
    DataType::UInt16,
    DataType::Int32,
    DataType::UInt32,
    DataType::Int64,
    DataType::UInt64,
    DataType::Enumeration,
    DataType::Boolean,
    DataType::String,
];

/// Gives slots to variables (whole ones, without repetition) of one instance, one batch for each type.
pub(super) fn batches(
    names: &Names,
    variables: &[Port],
    store: &mut Store,
    slots: &mut Slots,
    start: impl Fn(Port) -> Values,
) -> Vec<Batch> {
    let mut batches = Vec::new();
    for data_type in TYPES {
        let Some(kind) = Kind::of(data_type) else { continue };
        let of_type = variables.iter().copied().filter(|&port| names.variable(port).data_type == data_type);
        let mut batch: Option<Batch> = None;
        for port in of_type {
            let first = store.push(start(port));
            slots.first.insert(port, first);
            let size = names.size(port);
            let batch = batch.get_or_insert_with(|| Batch {
                kind,
                data_type,
                references: Vec::new(),
                slots: first..first,
                names: Vec::new(),
            });
            batch.references.push(names.variable(port).value_reference);
            batch.slots.end = first + size;
            let scalar = names.dimensions(port.instance, port.variable).is_empty();
            batch.names.extend((0..size).map(|element| match scalar {
                true => names.name(port),
                false => names.name(Port { element: Some(element), ..port }),
            }));
        }
        batches.extend(batch);
    }
    batches
}

/// The declared start values of a variable.
pub(super) fn declared_start(names: &Names, port: Port) -> Values {
    declared(names.variable(port), names.length(port.instance, port.variable))
}

/// The whole variables of an instance among some ports, once each and in the order of the description.
pub(super) fn whole(instance: usize, ports: impl Iterator<Item = Port>) -> Vec<Port> {
    let mut whole: Vec<Port> =
        ports.filter(|port| port.instance == instance).map(|port| Port { element: None, ..port }).collect();
    whole.sort();
    whole.dedup();
    whole
}

/// How the inputs of an instance come from outputs.
pub(super) fn transfers(wiring: &Wiring, instance: usize, outputs: &Slots, inputs: &Slots) -> Transfers {
    let mut transfers = Transfers::default();
    for link in wiring.links.iter().filter(|link| link.to.instance == instance) {
        let (from, to) = (outputs.of(link.from), inputs.of(link.to));
        let ways = (0..link.size).map(|index| Way { from: from + index, to: to + index });
        let kinds = [link.from, link.to].map(|port| Kind::of(wiring.names.variable(port).data_type));
        let scaled = |(factor, offset): (f64, f64)| move |way| ScaledWay { way, factor, offset };
        match (kinds, link.scale) {
            ([Some(Kind::Integer), Some(Kind::Float)], scale) => {
                transfers.widened.extend(ways.map(scaled(scale.unwrap_or((1.0, 0.0)))));
            }
            ([_, Some(Kind::Float)], Some(scale)) => transfers.scaled.extend(ways.map(scaled(scale))),
            ([_, Some(Kind::Float)], None) => transfers.floats.extend(ways),
            ([_, Some(Kind::Integer)], _) => transfers.integers.extend(ways),
            ([_, Some(Kind::Boolean)], _) => transfers.booleans.extend(ways),
            ([_, Some(Kind::String)], _) => transfers.strings.extend(ways),
            // The wiring connects no binaries and clocks.
            ([_, None], _) => {}
        }
    }
    transfers
}

/// Where the columns of the input signals go.
pub(super) fn drives(wiring: &Wiring, inputs: &Slots) -> Vec<Drive> {
    let drives = wiring.drives.iter().filter_map(|drive| {
        let kind = Kind::of(wiring.names.variable(drive.to).data_type)?;
        Some(Drive { column: drive.column, kind, to: inputs.of(drive.to), interpolated: drive.interpolated })
    });
    drives.collect()
}
