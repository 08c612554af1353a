//! A command as a sequence of straight pieces.

use serde::{Deserialize, Serialize};
use swayless_export::{Environment, Problem};

use crate::variables::{Interpolation, Kind, Parameters};
use crate::{pulses, table};

/// A straight piece: value + slope · (t − begin), until the next begins.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Segment {
    /// When it begins (s).
    pub begin: f64,
    /// The value there.
    pub value: f64,
    /// The slope (1/s).
    pub slope: f64,
}

impl Segment {
    /// A level piece.
    pub fn level(begin: f64, value: f64) -> Self {
        Self { begin, value, slope: 0.0 }
    }
}

/// What the bounds of single parameters cannot say.
pub fn check(p: &Parameters<f64>) -> Vec<Problem> {
    let mut problems = Vec::new();
    if p.kind == Kind::Trapezoid && p.duration < p.ramp_time {
        problems.push(Problem::new(
            "duration",
            format!("is {} s; a trapezoid needs at least its ramp_time of {} s", p.duration, p.ramp_time),
        ));
    }
    if p.kind == Kind::Playback && p.file.is_empty() {
        problems.push(Problem::new("file", "is empty; kind = Playback needs the name of a CSV file"));
    }
    if p.kind == Kind::HoistPulses && p.amplitude < -pulses::LIGHTEST * p.gravity {
        let (least, gravity) = (-pulses::LIGHTEST * p.gravity, p.gravity);
        let message = format!("is {} m/s²; with a gravity of {gravity} m/s² it must be at least {least}", p.amplitude);
        problems.push(Problem::new("amplitude", message));
    }
    problems
}

/// The pieces of the command, the first from long ago.
pub fn segments(p: &Parameters<f64>, environment: &Environment<'_>) -> Result<Vec<Segment>, Problem> {
    let (begin, height) = (p.start_time, p.amplitude);
    let end = begin + p.duration;
    let before = Segment::level(f64::NEG_INFINITY, 0.0);
    Ok(match p.kind {
        Kind::Constant => vec![Segment::level(f64::NEG_INFINITY, height)],
        Kind::Step => vec![before, Segment::level(begin, height)],
        Kind::Pulse => vec![before, Segment::level(begin, height), Segment::level(end, 0.0)],
        Kind::Trapezoid if p.ramp_time == 0.0 => {
            vec![before, Segment::level(begin, height), Segment::level(end, 0.0)]
        }
        Kind::Trapezoid => {
            let slope = height / p.ramp_time;
            vec![
                before,
                Segment { begin, value: 0.0, slope },
                Segment::level(begin + p.ramp_time, height),
                Segment { begin: end, value: height, slope: -slope },
                Segment::level(end + p.ramp_time, 0.0),
            ]
        }
        Kind::PartlyShaped => pulses::partly_shaped(p)?,
        Kind::HoistPulses => pulses::hoist_pulses(p),
        Kind::Playback => playback(&table::read(p, environment)?, begin, p.interpolation),
    })
}

/// The pieces between the rows (time, value), of which there is at least one. Before the first row and behind the last
/// their values hold; of rows with the same time the last counts.
fn playback(rows: &[(f64, f64)], shift: f64, interpolation: Interpolation) -> Vec<Segment> {
    let mut segments = vec![Segment::level(f64::NEG_INFINITY, rows[0].1)];
    for (i, (time, value)) in rows.iter().enumerate() {
        let slope = match (interpolation, rows.get(i + 1)) {
            (Interpolation::Linear, Some((next, then))) if next > time => (then - value) / (next - time),
            _ => 0.0,
        };
        segments.push(Segment { begin: time + shift, value: *value, slope });
    }
    segments
}
