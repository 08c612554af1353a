//! The crate from outside: what it writes, reads and finds.

#![cfg(feature = "ssp")]

mod check;
mod properties;
mod read;
mod samples;
mod ssp;
mod terminals;
mod write;
