//! The crate from outside: what it writes, reads and finds.

#![cfg(feature = "ssp")]

mod any_description;
mod any_value;
mod check;
mod properties;
mod read;
mod samples;
mod ssp;
mod terminals;
mod write;
