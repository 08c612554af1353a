//! Tests of the export runtime through its C functions, with a bouncing ball whose motion has a closed form.

#![allow(missing_docs, reason = "a test binary has no readers of its documentation")]
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod ball;
mod chain;
mod clocks;
mod configuration;
mod derivatives;
mod description;
mod events;
mod host;
mod intermediate;
mod life_cycle;
mod newcomer;
mod refusals;
mod sampler;
mod scheduled;
mod state;
mod values;
mod wrong_names;
