//! The supervisor against an axis that does exactly as it is told, and against braking distances added up.

mod braking;
mod faults;
mod limits;
mod memory;
mod plant;
mod stops;
