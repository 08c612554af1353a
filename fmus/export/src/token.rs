//! The instantiation token: it changes with every change of the variables, and with nothing else.

use crate::layout::{Block, Layout};
use crate::model::Model;
use crate::variables::{Value, Variables};

/// FNV-1a of 128 bits (offset basis and prime from the FNV reference).
struct Hash(u128);

/// The hash of bytes, to see whether they are still what they were.
pub fn checksum(bytes: &[u8]) -> [u8; 16] {
    let mut hash = Hash::new();
    hash.add_bytes(bytes);
    hash.0.to_le_bytes()
}

impl Hash {
    fn new() -> Self {
        Self(0x6C62_272E_07BB_0142_62B8_2175_6295_C58D)
    }

    fn add_bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u128::from(*byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013B);
        }
    }

    fn add(&mut self, text: &str) {
        self.add_bytes(text.as_bytes());
        self.add_bytes(&[0]);
    }

    fn add_starts(&mut self, values: &impl Variables<f64>, count: usize) {
        for index in 0..count {
            self.add_value(values.get(index));
        }
    }

    fn add_value(&mut self, value: Value<'_, f64>) {
        match value {
            // The bits, since every change of a number counts.
            Value::Real(value) => self.add(&format!("{:016x}", value.to_bits())),
            other => self.add(&format!("{other:?}")),
        }
    }
}

/// Which of a model's FMUs is meant: one library serves both, and the token tells which.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variant {
    /// The FMU that ticks its clocks itself, if it has any.
    Plain,
    /// The FMU whose clocks the importer ticks.
    Clocked,
}

impl Variant {
    /// The name of the FMU.
    pub fn name<M: Model>(self) -> String {
        match self {
            Self::Plain => M::INFO.name.to_string(),
            Self::Clocked => format!("{}Clocked", M::INFO.name),
        }
    }

    /// Whether the FMU with clocks can be executed by a scheduler: nothing in it may happen between ticks.
    pub fn has_scheduled_execution<M: Model>() -> bool {
        Layout::<M>::STATE_COUNT == 0 && Layout::<M>::INDICATOR_COUNT == 0
    }
}

/// The token of a model, written as a GUID.
pub fn of<M: Model>(variant: Variant) -> String {
    let mut hash = Hash::new();
    hash.add(&variant.name::<M>());
    for clock in M::CLOCKS {
        hash.add(&format!("{clock:?}"));
    }
    hash.add(env!("CARGO_PKG_VERSION"));
    for block in [Block::Parameters, Block::Inputs, Block::States, Block::Outputs, Block::Discrete] {
        for declaration in Layout::<M>::declarations(block) {
            hash.add(&format!("{block:?} {declaration:?}"));
        }
    }
    hash.add_starts(&<M::Parameters<f64> as Variables<f64>>::start(), Layout::<M>::INPUTS - Layout::<M>::PARAMETERS);
    hash.add_starts(&<M::Inputs<f64> as Variables<f64>>::start(), Layout::<M>::STATES - Layout::<M>::INPUTS);
    hash.add_starts(&<M::States<f64> as Variables<f64>>::start(), Layout::<M>::STATE_COUNT);
    let text = format!("{:032x}", hash.0);
    format!("{{{}-{}-{}-{}-{}}}", &text[..8], &text[8..12], &text[12..16], &text[16..20], &text[20..])
}
