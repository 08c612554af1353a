//! The variables of the command source.

use swayless_export::{Enumeration, Scalar, Variables};

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Kind {
    /// amplitude, always.
    Constant,
    /// 0, then amplitude from start_time on.
    Step,
    /// amplitude from start_time for duration, else 0.
    Pulse,
    /// From start_time a ramp of ramp_time to amplitude; duration after start_time a ramp of ramp_time back to 0.
    Trapezoid,
    /// A column of a CSV file over its time column.
    Playback,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Interpolation {
    /// A value holds until the next row.
    Hold,
    /// Straight lines between rows.
    Linear,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// Shape of the command.
    #[variable(start = Kind::Constant)]
    pub kind: Kind,
    /// Height of the command.
    #[variable(start = 1.0)]
    pub amplitude: R,
    /// When the command begins; a playback begins there with time 0 of its file.
    #[variable(unit = "s")]
    pub start_time: R,
    /// Length of a pulse; of a trapezoid, from its begin to the begin of its falling ramp.
    #[variable(unit = "s", start = 1.0, min = 0.0)]
    pub duration: R,
    /// Length of each ramp of a trapezoid.
    #[variable(unit = "s", start = 0.5, min = 0.0)]
    pub ramp_time: R,
    /// CSV file of a playback: an absolute path, or one relative to the FMU's resources or the working directory.
    pub file: String,
    /// Column of the CSV file to play back; empty for the first column that is not the time.
    pub column: String,
    /// What holds between the rows of a playback.
    #[variable(start = Interpolation::Hold)]
    pub interpolation: Interpolation,
}

#[derive(Clone, Variables)]
pub struct Outputs<R: Scalar> {
    /// The command.
    pub command: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    pub segment: SegmentVariables<R>,
}

#[derive(Clone, Variables)]
pub struct SegmentVariables<R: Scalar> {
    /// Begin of the present piece of the command.
    #[variable(unit = "s", depends_on = [])]
    pub begin: R,
    /// Value of the command there.
    #[variable(depends_on = [])]
    pub value: R,
    /// Slope of the command from there on.
    #[variable(depends_on = [])]
    pub slope: R,
}
