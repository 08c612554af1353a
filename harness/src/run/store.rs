//! Values between instances: where each is kept, how a batch of them is got or set, how they are carried over.

use std::ops::Range;

use swayless_modeldesc::types::DataType;

use crate::signals::Cursor;
use crate::slave::{Failure, Slave};
use crate::system::{Kind, Values};

/// Values by kind, each at its slot.
#[derive(Debug, Clone, Default)]
pub(super) struct Store {
    pub floats: Vec<f64>,
    pub integers: Vec<i64>,
    pub booleans: Vec<bool>,
    pub strings: Vec<String>,
}

impl Store {
    /// Adds values; they begin at the slot that is returned.
    pub(super) fn push(&mut self, values: Values) -> usize {
        fn extend<T>(to: &mut Vec<T>, values: Vec<T>) -> usize {
            let slot = to.len();
            to.extend(values);
            slot
        }
        match values {
            Values::Float(values) => extend(&mut self.floats, values),
            Values::Integer(values) => extend(&mut self.integers, values),
            Values::Boolean(values) => extend(&mut self.booleans, values),
            Values::String(values) => extend(&mut self.strings, values),
        }
    }
}

/// Variables of one type of one instance that are got or set in one call.
#[derive(Debug, Clone)]
pub(super) struct Batch {
    pub kind: Kind,
    pub data_type: DataType,
    pub references: Vec<u32>,
    /// The slots of all their values.
    pub slots: Range<usize>,
    /// The name of each value, for messages.
    pub names: Vec<String>,
}

impl Batch {
    /// Gets the values into the store.
    pub(super) fn get(&self, slave: &mut dyn Slave, store: &mut Store) -> Result<(), Failure> {
        let (references, slots) = (&self.references, self.slots.clone());
        match self.kind {
            Kind::Float => slave.get_float(self.data_type, references, &mut store.floats[slots]),
            Kind::Integer => slave.get_integer(self.data_type, references, &mut store.integers[slots]),
            Kind::Boolean => slave.get_boolean(references, &mut store.booleans[slots]),
            Kind::String => slave.get_string(references, &mut store.strings[slots]),
        }
    }

    /// Sets the values from the store.
    pub(super) fn set(&self, slave: &mut dyn Slave, store: &Store) -> Result<(), Failure> {
        let (references, slots) = (&self.references, self.slots.clone());
        match self.kind {
            Kind::Float => slave.set_float(self.data_type, references, &store.floats[slots]),
            Kind::Integer => slave.set_integer(self.data_type, references, &store.integers[slots]),
            Kind::Boolean => slave.set_boolean(references, &store.booleans[slots]),
            Kind::String => slave.set_string(references, &store.strings[slots]),
        }
    }

    /// Whether a slot of the floats is one of its own.
    pub(super) fn holds_float(&self, slot: usize) -> bool {
        self.kind == Kind::Float && self.slots.contains(&slot)
    }

    /// The name of the value in one of its slots.
    pub(super) fn name_of(&self, slot: usize) -> String {
        self.names[slot - self.slots.start].clone()
    }
}

/// From a slot of the outputs to a slot of the inputs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Way {
    pub from: usize,
    pub to: usize,
}

/// The same with `to = factor · from + offset`.
#[derive(Debug, Clone, Copy)]
pub(super) struct ScaledWay {
    pub way: Way,
    pub factor: f64,
    pub offset: f64,
}

/// How the inputs of an instance come from outputs. What is only copied keeps its bits.
#[derive(Debug, Clone, Default)]
pub(super) struct Transfers {
    pub floats: Vec<Way>,
    pub scaled: Vec<ScaledWay>,
    pub integers: Vec<Way>,
    pub widened: Vec<ScaledWay>,
    pub booleans: Vec<Way>,
    pub strings: Vec<Way>,
}

impl Transfers {
    /// Carries all values over. A float that is NaN is an error: the slot of the output that delivered it.
    pub(super) fn apply(&self, outputs: &Store, inputs: &mut Store) -> Result<(), usize> {
        let mut bad = None;
        for &Way { from, to } in &self.floats {
            let value = outputs.floats[from];
            if value.is_nan() {
                bad = Some(from);
            }
            inputs.floats[to] = value;
        }
        for &ScaledWay { way: Way { from, to }, factor, offset } in &self.scaled {
            let value = outputs.floats[from];
            if value.is_nan() {
                bad = Some(from);
            }
            inputs.floats[to] = factor * value + offset;
        }
        for &ScaledWay { way: Way { from, to }, factor, offset } in &self.widened {
            inputs.floats[to] = factor * outputs.integers[from] as f64 + offset;
        }
        for &Way { from, to } in &self.integers {
            inputs.integers[to] = outputs.integers[from];
        }
        for &Way { from, to } in &self.booleans {
            inputs.booleans[to] = outputs.booleans[from];
        }
        for &Way { from, to } in &self.strings {
            inputs.strings[to].clone_from(&outputs.strings[from]);
        }
        bad.map_or(Ok(()), Err)
    }
}

/// From a column of the input signals to a slot of the inputs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Drive {
    pub column: usize,
    pub kind: Kind,
    pub to: usize,
    pub interpolated: bool,
}

impl Drive {
    /// Takes the value at the cursor.
    pub(super) fn apply(&self, columns: &[Vec<f64>], cursor: &Cursor, inputs: &mut Store) {
        let column = &columns[self.column];
        let value = if self.interpolated { cursor.interpolate(column) } else { cursor.hold(column) };
        match self.kind {
            Kind::Float => inputs.floats[self.to] = value,
            // The wiring has found all values of the column to be whole.
            Kind::Integer => inputs.integers[self.to] = value as i64,
            Kind::Boolean => inputs.booleans[self.to] = value != 0.0,
            Kind::String => {}
        }
    }
}
