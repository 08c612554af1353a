//! C types and function tables of FMI 2.0 and FMI 3.0.
//!
//! Each version's functions are declared once, in [`fmi2_functions!`] and [`fmi3_functions!`]; the exporter makes its
//! C symbols and the importer its struct of function pointers from the same table, so the two cannot disagree.

#[macro_use]
mod pointers;

pub mod describe;
pub mod fmi2;
pub mod fmi3;
