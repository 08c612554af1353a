//! Why a description could not be written.

use crate::types::DataType;
use crate::xml_out::IllegalCharacter;
use std::error::Error;
use std::fmt;

/// Why a description could not be written.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum WriteError {
    /// There are no variables; both versions want at least one.
    NoVariables,
    /// The version has no way to say it.
    NotInVersion {
        /// What there is no way to say, and of which variable or type.
        what: String,
        /// The standard and its version, such as `FMI 2.0`.
        version: String,
    },
    /// An index points past the variables.
    NoSuchVariable {
        /// Where the index stands.
        place: String,
        /// The index, counted from 0.
        index: usize,
    },
    /// Bounds, unit or the like that the type does not have, or a bound of an integer that is not whole.
    Attributes {
        /// The variable or type definition.
        place: String,
        /// Its type.
        data_type: DataType,
    },
    /// A start value that is not of the variable's type, beyond its range, or of a number that does not fit.
    StartType {
        /// The variable.
        variable: String,
        /// Its type.
        data_type: DataType,
    },
    /// A character that XML cannot hold.
    IllegalCharacter {
        /// The element.
        element: String,
        /// The attribute.
        attribute: String,
        /// The character.
        character: char,
    },
}

impl WriteError {
    /// Something that a version cannot say.
    pub(crate) fn not_in(version: &str, what: impl Into<String>) -> Self {
        Self::NotInVersion { what: what.into(), version: version.to_owned() }
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoVariables => f.write_str("the description has no variables; declare at least one"),
            Self::NotInVersion { what, version } => {
                write!(f, "{what} cannot be written in {version}")
            }
            Self::NoSuchVariable { place, index } => {
                write!(f, "{place} refers to variable {index}, which does not exist")
            }
            Self::Attributes { place, data_type } => write!(
                f,
                "`{place}` has a quantity, unit, bound or the like that a {} does not take",
                data_type.as_str()
            ),
            Self::StartType { variable, data_type } => {
                write!(f, "the start value of `{variable}` is not a {} value or not of its size", data_type.as_str())
            }
            Self::IllegalCharacter { element, attribute, character } => write!(
                f,
                "the attribute {attribute} of {element} holds {character:?}, which XML cannot hold; remove it"
            ),
        }
    }
}

impl Error for WriteError {}

impl From<IllegalCharacter> for WriteError {
    fn from(illegal: IllegalCharacter) -> Self {
        Self::IllegalCharacter {
            element: illegal.element.to_owned(),
            attribute: illegal.attribute,
            character: illegal.character,
        }
    }
}
