//! modelDescription.xml of FMI 2 and 3, terminals and icons, and SSP documents: types, read, write, check.
//!
//! One set of types serves both FMI versions: what a version calls differently is mapped by its reader and writer, so
//! the rest of Swayless never asks which version a description came from unless it must.

pub mod terminals;
pub mod types;
pub mod write;
mod xml_out;

#[cfg(feature = "read")]
pub mod check;
#[cfg(feature = "read")]
pub mod problem;
#[cfg(feature = "read")]
pub mod read;
#[cfg(feature = "ssp")]
pub mod ssp;
#[cfg(feature = "read")]
mod xml_in;
