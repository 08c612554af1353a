//! The variables of the sampled mean.

use swayless_export::{Enumeration, Scalar, Variables};

/// Room for samples.
pub const ROOM: usize = 16;

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Weighting {
    /// All samples count the same.
    Uniform,
    /// Each sample counts by its weight.
    Weights,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Level {
    /// The mean is not above the threshold.
    Low,
    /// The mean is above the threshold.
    High,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// How many samples count.
    #[variable(start = 4, min = 1, max = 16, tunable)]
    pub window: u32,
    /// How samples count.
    #[variable(start = Weighting::Uniform)]
    pub weighting: Weighting,
    /// Weights of the samples, the newest first.
    #[variable(unit = "1", start = 1.0, min = 0.0, tunable, length = "window")]
    pub weight: [R; ROOM],
    /// Interval of the samples; 0 for every communication point and event.
    #[variable(unit = "s", start = 0.1, min = 0.0, tunable)]
    pub sample_time: R,
    /// Interval at which the mean is logged.
    #[variable(unit = "s", start = 0.3, min = 1e-3)]
    pub log_interval: R,
    /// Above it, the mean raises the alarm.
    #[variable(start = 0.2, tunable)]
    pub threshold: R,
    /// Time from the crossing of the threshold to the alarm.
    #[variable(unit = "s", start = 0.17, min = 0.0, tunable)]
    pub delay: R,
    /// Greatest noise added to a sample.
    #[variable(start = 0.01, min = 0.0)]
    pub dither: R,
    /// Where the noise begins.
    #[variable(start = 1)]
    pub seed: i32,
    /// A name for the record.
    #[variable(start = "mean & <more>")]
    pub label: String,
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// What is sampled.
    #[variable(discrete)]
    pub signal: R,
    /// While it is set, no samples are taken.
    pub paused: bool,
    /// Added to the number of samples.
    pub offset: i32,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// Weighted mean of the last samples.
    #[variable(output, clock = "sample", depends_on = ["signal", "paused"])]
    pub mean: R,
    /// How many samples have been taken, and the offset.
    #[variable(output, clock = "sample", depends_on = ["paused", "offset"])]
    pub samples: i32,
    /// The last samples, the newest first.
    #[variable(output, clock = "sample", length = "window", depends_on = ["signal", "paused"])]
    pub history: [R; ROOM],
    /// Where the mean is.
    #[variable(output, start = Level::Low, clock = "sample", depends_on = ["signal", "paused"])]
    pub level: Level,
    /// Whether the alarm has been raised.
    #[variable(output, clock = "alarm", depends_on = [])]
    pub alarmed: bool,
    /// Ticks of the clock with a constant interval.
    #[variable(output, clock = "heartbeat", depends_on = [])]
    pub heartbeats: i32,
    /// Ticks of the clock whose interval the importer fixes.
    #[variable(clock = "check", alias = "check_count", depends_on = [])]
    pub checks: i32,
    /// Interval of the clock whose interval the importer tunes.
    #[variable(output, unit = "s", clock = "trim", depends_on = [])]
    pub trim_interval: R,
    /// Ticks of the clock with growing intervals.
    #[variable(output, clock = "pulse", depends_on = [])]
    pub pulses: i32,
    /// Mean when it was logged last.
    #[variable(output, clock = "log", depends_on = [])]
    pub logged: R,
    /// Length of the label when it was logged last.
    #[variable(output, clock = "log", depends_on = [])]
    pub letters: i32,
}
