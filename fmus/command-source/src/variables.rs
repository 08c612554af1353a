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
    /// A pulse that is shaped where it begins, where it ends, or at both: the luffing command of fig. 2.16.
    PartlyShaped,
    /// Pulses of vertical acceleration, up and down in turn, that take swing away.
    HoistPulses,
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
    /// Height of the command; of hoist pulses, the first acceleration, positive upwards.
    #[variable(start = 1.0)]
    pub amplitude: R,
    /// When the command begins; a playback begins there with time 0 of its file.
    #[variable(unit = "s")]
    pub start_time: R,
    /// Length of a pulse; of a trapezoid or a partly shaped pulse, from its begin to the begin of its fall.
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
    pub mode: ModeParameters<R>,
    pub shaped: ShapedParameters,
    pub pulse: PulseParameters,
    /// Gravity, for hoist pulses.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3, max = 1e3)]
    pub gravity: R,
}

#[derive(Clone, Variables)]
pub struct ModeParameters<R: Scalar> {
    /// Undamped natural frequency of the swing that a partly shaped pulse or hoist pulses are for.
    #[variable(unit = "rad/s", start = 5.9, min = 1e-3, max = 1e6)]
    pub frequency: R,
    /// Its damping ratio, for a partly shaped pulse.
    #[variable(unit = "1", min = 0.0, max = 0.99)]
    pub damping_ratio: R,
}

#[derive(Clone, Variables)]
pub struct ShapedParameters {
    /// Whether the begin of a partly shaped pulse is shaped.
    pub start: bool,
    /// Whether its end is shaped.
    #[variable(start = true)]
    pub stop: bool,
}

#[derive(Clone, Variables)]
pub struct PulseParameters {
    /// How many hoist pulses there are; after an even number the hoist stands still.
    #[variable(start = 2, min = 1, max = 1000)]
    pub count: i32,
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
