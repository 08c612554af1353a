//! Variables.

use super::{Attributes, Causality, Clock, DataType, Initial, Variability};

/// A variable of `ModelVariables`.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// `name`.
    pub name: String,
    /// `valueReference`.
    pub value_reference: u32,
    /// `description`.
    pub description: Option<String>,
    /// `causality`.
    pub causality: Causality,
    /// `variability`.
    pub variability: Variability,
    /// `initial`: as written, or what the standard's table says when it is not; a clock has none.
    pub initial: Option<Initial>,
    /// The type.
    pub data_type: DataType,
    /// `declaredType`.
    pub declared_type: Option<String>,
    /// Unit, bounds and the like.
    pub attributes: Attributes,
    /// `start`: one value, or one for each element in row-major order, or one for all elements.
    pub start: Option<Start>,
    /// `Dimension`s (FMI 3.0); none for a scalar.
    pub dimensions: Vec<Dimension>,
    /// The state that this variable is the derivative of, as an index into [`ModelDescription::variables`](super::ModelDescription::variables).
    pub derivative: Option<usize>,
    /// `reinit`.
    pub reinit: bool,
    /// `canHandleMultipleSetPerTimeInstant`; true unless said otherwise.
    pub can_handle_multiple_set_per_time_instant: bool,
    /// `intermediateUpdate` (FMI 3.0).
    pub intermediate_update: bool,
    /// `clocks`: the value references of the clocks it belongs to (FMI 3.0).
    pub clocks: Vec<u32>,
    /// `previous`: the variable that holds its value before the clock tick, as an index into
    /// [`ModelDescription::variables`](super::ModelDescription::variables) (FMI 3.0).
    pub previous: Option<usize>,
    /// When it ticks, when [`DataType::Clock`].
    pub clock: Option<Clock>,
    /// `Alias` elements (FMI 3.0).
    pub aliases: Vec<Alias>,
    /// The line it begins in, 0 when it was not read from a file.
    pub line: usize,
}

impl Variable {
    /// A scalar with nothing said about it but what every variable must say; `initial` is the standard's default for
    /// this causality and variability.
    pub fn new(
        name: impl Into<String>,
        value_reference: u32,
        data_type: DataType,
        causality: Causality,
        variability: Variability,
    ) -> Self {
        Self {
            name: name.into(),
            value_reference,
            description: None,
            causality,
            variability,
            initial: match data_type {
                DataType::Clock => None,
                _ => Initial::default_for(causality, variability),
            },
            data_type,
            declared_type: None,
            attributes: Attributes::default(),
            start: None,
            dimensions: Vec::new(),
            derivative: None,
            reinit: false,
            can_handle_multiple_set_per_time_instant: true,
            intermediate_update: false,
            clocks: Vec::new(),
            previous: None,
            clock: None,
            aliases: Vec::new(),
            line: 0,
        }
    }
}

/// `Alias`: another name of a variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Alias {
    /// The name.
    pub name: String,
    /// Its description.
    pub description: Option<String>,
    /// `displayUnit`.
    pub display_unit: Option<String>,
}

/// Start values, by type.
#[derive(Debug, Clone, PartialEq)]
pub enum Start {
    /// Of a float of either width.
    Float(Vec<f64>),
    /// Of an integer of any width or an enumeration. Wide enough for every one of them.
    Integer(Vec<i128>),
    /// Of a Boolean.
    Boolean(Vec<bool>),
    /// Of a string.
    String(Vec<String>),
    /// Of a binary.
    Binary(Vec<Vec<u8>>),
}

/// The size of an array in one direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Known.
    Fixed(u64),
    /// The value of a structural parameter, by its value reference.
    Variable(u32),
}
