//! Shapers against closed forms, reference values, a simulated oscillator, and what must hold for every mode.

mod closed_forms;
mod compensated;
mod drives;
mod extra_insensitive;
mod humps;
mod limited;
mod limited_range;
mod oscillator;
mod properties;
mod ranges;
mod reference;
mod refusals;
mod specification;
mod specified;
mod trains;
mod two_modes;

use swayless_shaping::{Impulse, Kind, Mode, Shaper, design};

const LIMIT: f64 = 0.05;

fn mode(frequency: f64, damping_ratio: f64) -> Mode {
    Mode::new(frequency, damping_ratio).expect("a mode in range")
}

fn designed(kind: Kind, frequency: f64, damping_ratio: f64) -> Shaper {
    design(kind, mode(frequency, damping_ratio), LIMIT).expect("a design that exists")
}

fn shaper<const N: usize>(pairs: [(f64, f64); N]) -> Shaper {
    Shaper::new(&pairs.map(|(time, amplitude)| Impulse { time, amplitude })).expect("impulses in order")
}

/// Largest difference of two shapers, times relative to the longer duration; infinite if the counts differ.
fn distance(a: &Shaper, b: &Shaper) -> f64 {
    if a.impulses().len() != b.impulses().len() {
        return f64::INFINITY;
    }
    let duration = a.duration().max(b.duration()).max(f64::MIN_POSITIVE);
    let pairs = a.impulses().iter().zip(b.impulses());
    pairs.map(|(a, b)| ((a.time - b.time) / duration).abs().max((a.amplitude - b.amplitude).abs())).fold(0.0, f64::max)
}
