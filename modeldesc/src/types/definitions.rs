//! Units and types.

use super::{Clock, FmiVersion, name_of};

/// A `Unit` with its display units.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Unit {
    /// The name by which variables refer to it.
    pub name: String,
    /// Its dimensions and conversion to SI, if given.
    pub base: Option<BaseUnit>,
    /// The units a user may want to see instead.
    pub display_units: Vec<DisplayUnit>,
}

/// `BaseUnit`: value in SI = factor · value + offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BaseUnit {
    /// Exponents of kg, m, s, A, K, mol, cd, rad, in this order.
    pub exponents: [i32; 8],
    /// The factor.
    pub factor: f64,
    /// The offset.
    pub offset: f64,
}

impl BaseUnit {
    /// The names of the exponents, as the standard's attributes have them.
    pub const SYMBOLS: [&'static str; 8] = ["kg", "m", "s", "A", "K", "mol", "cd", "rad"];
}

/// `DisplayUnit`: display value = factor · value + offset; with `inverse` (FMI 3.0), factor / value.
#[derive(Debug, Clone, PartialEq)]
pub struct DisplayUnit {
    /// Its name.
    pub name: String,
    /// The factor.
    pub factor: f64,
    /// The offset.
    pub offset: f64,
    /// Whether the value stands below the factor.
    pub inverse: bool,
}

/// A `SimpleType` (FMI 2.0) or a type of `TypeDefinitions` (FMI 3.0).
#[derive(Debug, Clone, PartialEq)]
pub struct TypeDefinition {
    /// The name by which variables refer to it.
    pub name: String,
    /// Its description.
    pub description: Option<String>,
    /// The base type.
    pub data_type: DataType,
    /// What numbers of this type are.
    pub attributes: Attributes,
    /// The items, when [`DataType::Enumeration`].
    pub items: Vec<Item>,
    /// When its clocks tick, when [`DataType::Clock`].
    pub clock: Option<Clock>,
}

/// An `Item` of an enumeration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Item {
    /// Its name.
    pub name: String,
    /// Its value.
    pub value: i64,
    /// Its description.
    pub description: Option<String>,
}

/// The type of a variable. FMI 2.0's `Real` is `Float64`, its `Integer` is `Int32`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "the names are the standard's")]
pub enum DataType {
    Float32,
    Float64,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Boolean,
    String,
    Binary,
    Enumeration,
    Clock,
}

impl DataType {
    /// Every type with the name of its element in FMI 3.0.
    pub(crate) const NAMES: [(&'static str, Self); 15] = [
        ("Float32", Self::Float32),
        ("Float64", Self::Float64),
        ("Int8", Self::Int8),
        ("UInt8", Self::UInt8),
        ("Int16", Self::Int16),
        ("UInt16", Self::UInt16),
        ("Int32", Self::Int32),
        ("UInt32", Self::UInt32),
        ("Int64", Self::Int64),
        ("UInt64", Self::UInt64),
        ("Boolean", Self::Boolean),
        ("String", Self::String),
        ("Binary", Self::Binary),
        ("Enumeration", Self::Enumeration),
        ("Clock", Self::Clock),
    ];

    /// The name of its element in FMI 3.0.
    pub fn as_str(self) -> &'static str {
        name_of(&Self::NAMES, self)
    }

    /// The least and the greatest value of an integer type or an enumeration (whose values are 32 bits wide in FMI 2.0);
    /// `None` for the other types.
    pub fn integer_range(self, version: FmiVersion) -> Option<(i128, i128)> {
        Some(match self {
            Self::Int8 => (i8::MIN.into(), i8::MAX.into()),
            Self::UInt8 => (0, u8::MAX.into()),
            Self::Int16 => (i16::MIN.into(), i16::MAX.into()),
            Self::UInt16 => (0, u16::MAX.into()),
            Self::Int32 => (i32::MIN.into(), i32::MAX.into()),
            Self::UInt32 => (0, u32::MAX.into()),
            Self::Enumeration if version == FmiVersion::V2 => (i32::MIN.into(), i32::MAX.into()),
            Self::Int64 | Self::Enumeration => (i64::MIN.into(), i64::MAX.into()),
            Self::UInt64 => (0, u64::MAX.into()),
            _ => return None,
        })
    }

    /// Whether variables of this type can be continuous.
    pub fn is_float(self) -> bool {
        matches!(self, Self::Float32 | Self::Float64)
    }
}

/// Attributes that a type definition and a variable share; on a variable, what is absent holds from its declared type.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Attributes {
    /// `quantity`.
    pub quantity: Option<String>,
    /// `unit`.
    pub unit: Option<String>,
    /// `displayUnit`.
    pub display_unit: Option<String>,
    /// `relativeQuantity`.
    pub relative_quantity: bool,
    /// `unbounded`.
    pub unbounded: bool,
    /// `min`.
    pub min: Option<f64>,
    /// `max`.
    pub max: Option<f64>,
    /// `nominal`.
    pub nominal: Option<f64>,
}
