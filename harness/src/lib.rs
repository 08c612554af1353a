//! Imports FMUs, wires them to systems and steps them together.

pub mod package;
