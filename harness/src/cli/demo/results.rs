//! What the shapers are worth, in numbers.

use serde_json::{Value as Json, json};
use swayless::Recording;
use swayless::report::Table;

use super::super::console;
use super::{AXES, Run};

/// Below this speed (rad/s or m/s) a drive has stopped.
const STOPPED: f64 = 1e-4;

/// The numbers of all runs.
pub struct Results {
    /// One for each run, the unshaped first.
    pub rows: Vec<Row>,
    /// From when on every drive of every run has stopped (s).
    pub rest_from: f64,
}

/// The numbers of one run.
pub struct Row {
    pub kind: &'static str,
    /// When the last drive had stopped (s).
    stopped: f64,
    /// The greatest swing after that (rad).
    residual: f64,
    /// The greatest angle of the rope from the vertical (rad).
    peak: f64,
    /// How much later than the command its last impulse comes, at most (s).
    delay: f64,
    /// By what part the residual swing is smaller than without shaping.
    reduction: f64,
    fmi3_factor: f64,
    fmi2_factor: f64,
    same: bool,
}

pub fn results(runs: &[Run]) -> Results {
    let mut rows: Vec<Row> = runs.iter().map(row).collect();
    let unshaped = rows.first().map_or(f64::NAN, |r| r.residual);
    rows.iter_mut().for_each(|r| r.reduction = 1.0 - r.residual / unshaped);
    let rest_from = rows.iter().map(|r| r.stopped).fold(0.0, f64::max);
    Results { rows, rest_from }
}

fn row(run: &Run) -> Row {
    let recording = &run.recording;
    let stopped = stopped(recording);
    let amplitude = column(recording, "crane.swing.amplitude");
    let after = recording.times.iter().zip(amplitude).filter(|(t, _)| **t >= stopped).map(|(_, s)| *s);
    let longest = |axis: &super::Axis| greatest(column(recording, &format!("{}_shaper.duration", axis.name)));
    Row {
        kind: run.kind,
        stopped,
        residual: after.fold(0.0, f64::max),
        peak: peak(recording),
        delay: AXES.iter().map(longest).fold(0.0, f64::max),
        reduction: 0.0,
        fmi3_factor: run.fmi3.real_time_factor(),
        fmi2_factor: run.fmi2.real_time_factor(),
        same: run.same,
    }
}

/// When the last drive has stopped for good.
fn stopped(recording: &Recording) -> f64 {
    let speeds: Vec<&[f64]> = AXES.iter().map(|a| column(recording, &format!("{}_drive.velocity", a.name))).collect();
    let moving = |at: &usize| speeds.iter().any(|s| s.get(*at).is_some_and(|v| v.abs() > STOPPED));
    let last = (0..recording.times.len()).rev().find(moving);
    last.and_then(|at| recording.times.get(at + 1).or(recording.times.last())).copied().unwrap_or_default()
}

/// The greatest angle from the vertical. With n from the pivot to the payload, swing.radial = asin n_x and
/// swing.tangential = atan2(n_y, −n_z), so that −n_z = cos(radial) cos(tangential).
fn peak(recording: &Recording) -> f64 {
    let (radial, tangential) = (column(recording, "crane.swing.radial"), column(recording, "crane.swing.tangential"));
    radial.iter().zip(tangential).map(|(r, t)| (r.cos() * t.cos()).acos()).fold(0.0, f64::max)
}

/// A recorded column. Every run records what is asked for here, so an absent one is an empty one.
pub fn column<'a>(recording: &'a Recording, name: &str) -> &'a [f64] {
    recording.column(name).unwrap_or_default()
}

fn greatest(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

const HEADER: [&str; 7] = [
    "Shaper",
    "Residual swing",
    "Reduction",
    "Peak swing",
    "Delay added",
    "× real time, FMI 3.0",
    "× real time, FMI 2.0",
];

impl Results {
    /// For a terminal.
    pub fn table(&self) -> String {
        let mut table = console::table(HEADER, 1..HEADER.len());
        table.add_rows(self.rows.iter().map(Row::cells));
        format!("{}\n\n{}", table.trim_fmt(), self.notes().join("\n"))
    }

    /// For the page.
    pub fn report_table(&self) -> Table {
        Table {
            title: "What the shapers are worth".to_owned(),
            header: HEADER.map(str::to_owned).to_vec(),
            rows: self.rows.iter().map(|r| r.cells().to_vec()).collect(),
            notes: self.notes(),
        }
    }

    fn notes(&self) -> Vec<String> {
        let differing: Vec<&str> = self.rows.iter().filter(|r| !r.same).map(|r| r.kind).collect();
        let versions = if differing.is_empty() {
            "FMI 2.0 and FMI 3.0 give the same bits in every run.".to_owned()
        } else {
            format!("FMI 2.0 and FMI 3.0 DIFFER in {}.", differing.join(", "))
        };
        vec![
            "Residual swing: the greatest amplitude after the last drive has stopped. Peak swing: the greatest angle \
             from the vertical."
                .to_owned(),
            "Delay added: the shaper's longest duration during the run. × real time: simulated over computing time, \
             recording included."
                .to_owned(),
            versions,
        ]
    }
}

impl Row {
    fn cells(&self) -> [String; HEADER.len()] {
        [
            self.kind.to_owned(),
            format!("{:.2}°", self.residual.to_degrees()),
            if self.kind == super::KINDS[0] { "–".to_owned() } else { format!("{:.1} %", 100.0 * self.reduction) },
            format!("{:.2}°", self.peak.to_degrees()),
            format!("{:.2} s", self.delay),
            format!("{:.0}", self.fmi3_factor),
            format!("{:.0}", self.fmi2_factor),
        ]
    }

    pub fn json(&self) -> Json {
        json!({
            "kind": self.kind,
            "residual_swing": self.residual,
            "reduction": self.reduction,
            "peak_swing": self.peak,
            "delay": self.delay,
            "stopped_at": self.stopped,
            "real_time_factor": { "fmi3": self.fmi3_factor, "fmi2": self.fmi2_factor },
            "fmi2_equals_fmi3": self.same,
        })
    }
}
