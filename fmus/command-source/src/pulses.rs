//! Pulses that are timed by a swing: the luffing command of fig. 2.16, and the accelerations of section 2.5.4.

use std::f64::consts::FRAC_PI_2;

use swayless_export::Problem;
use swayless_shaping::{Kind, Mode, Shaper, design};

use crate::profile::Segment;
use crate::variables::Parameters;

/// No payload is let fall by more than this share of gravity: it must hang.
pub const LIGHTEST: f64 = 0.99;

/// A pulse of which a step is shaped, or both are: "Unshaped-ZV" where the second is.
pub fn partly_shaped(p: &Parameters<f64>) -> Result<Vec<Segment>, Problem> {
    let wrong = |name: &str, error: String| Problem::new(name, format!("cannot be used: {error}"));
    let mode = Mode::new(p.mode.frequency, p.mode.damping_ratio)
        .map_err(|error| wrong("mode.frequency", error.to_string()))?;
    let zv = design(Kind::ZV, mode, 0.0).map_err(|error| wrong("mode.damping_ratio", error.to_string()))?;
    let shaper = |shaped| if shaped { zv.clone() } else { Shaper::unshaped() };
    let parts = [(p.shaped.start, p.start_time, p.amplitude), (p.shaped.stop, p.start_time + p.duration, -p.amplitude)];
    let mut changes = Vec::new();
    for (shaped, time, step) in parts {
        changes.extend(shaper(shaped).impulses().iter().map(|impulse| (time + impulse.time, step * impulse.amplitude)));
    }
    changes.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut found = vec![Segment::level(f64::NEG_INFINITY, 0.0)];
    let mut value = 0.0;
    for (time, change) in changes {
        value += change;
        found.push(Segment::level(time, value));
    }
    // What has begun is over, to the last bit.
    if let Some(last) = found.last_mut() {
        last.value = 0.0;
    }
    Ok(found)
}

/// Accelerations z̈ up and down in turn, each for a quarter of the period that the pendulum has meanwhile,
/// t₂ − t₁ = π/(2ω_a) (2.58) with ω_a = ω_n √(1 + z̈/g) (2.36).
///
/// They follow each other where the pendulum is at the bottom and at the apex in turn. What one takes the hoist up to, the
/// next has to take back, z̈ π/(2ω_a) + z̈′ π/(2ω_a′) = 0, from which z̈′ = −z̈/(1 + z̈/g): then 1 + z̈′/g = 1/(1 + z̈/g), and
/// both take away the same share of the swing.
pub fn hoist_pulses(p: &Parameters<f64>) -> Vec<Segment> {
    let opposite = -p.amplitude / (1.0 + p.amplitude / p.gravity);
    let mut time = p.start_time;
    let mut found = vec![Segment::level(f64::NEG_INFINITY, 0.0)];
    for (_, acceleration) in (0..p.pulse.count).zip([p.amplitude, opposite].into_iter().cycle()) {
        found.push(Segment::level(time, acceleration));
        time += FRAC_PI_2 / (p.mode.frequency * (1.0 + acceleration / p.gravity).sqrt());
    }
    found.push(Segment::level(time, 0.0));
    found
}
