//! The controllers on a simulated crane, and their theory against numbers found elsewhere.

mod baseline;
mod behaviour;
mod moves;
mod plant;
mod poles;
mod rig;
