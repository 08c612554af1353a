//! The variables of the input shaper.

use swayless_export::{Enumeration, Scalar, Variables};
use swayless_shaping::MAX_IMPULSES;

#[allow(clippy::upper_case_acronyms, reason = "the names are the literature's")]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum Kind {
    /// No shaping: the command passes through.
    None,
    /// Zero vibration: two impulses, half a period long.
    ZV,
    /// Zero vibration and derivative: three impulses, a period long.
    ZVD,
    /// Zero vibration and two derivatives: four impulses, one and a half periods long.
    ZVDD,
    /// Extra-insensitive: three impulses, a period long, with the vibration limit at the design frequency.
    EI,
    /// Unity-magnitude zero vibration: impulses +1, −1, +1, a third of a period long.
    UMZV,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum FrequencySource {
    /// The frequency is mode.frequency.
    Parameter,
    /// The frequency follows the suspension length: ω = √(gravity/hoist.length) when the command changes.
    Length,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// The kind of shaper.
    #[variable(start = Kind::ZV)]
    pub kind: Kind,
    pub mode: ModeParameters<R>,
    /// Where the design frequency comes from.
    #[variable(start = FrequencySource::Parameter)]
    pub frequency_source: FrequencySource,
    /// Gravity, for a frequency that follows the length.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3)]
    pub gravity: R,
    /// Residual vibration that EI allows at the design frequency (V), as a share of the unshaped one.
    #[variable(unit = "1", start = 0.05, min = 0.0, max = 0.5, tunable)]
    pub vibration_limit: R,
    /// Whether changes of the command are shaped; trains under way finish in any case.
    #[variable(start = true, tunable)]
    pub enabled: bool,
    /// The command before the start, so that a first command that differs from it is shaped.
    pub command_start: R,
    /// Interval at which the command is looked at; 0 for every communication point and event.
    #[variable(unit = "s", min = 0.0)]
    pub sample_time: R,
}

#[derive(Clone, Variables)]
pub struct ModeParameters<R: Scalar> {
    /// Undamped natural frequencies of the modes to be shaped for; an unused second mode is 0.
    #[variable(unit = "rad/s", start = [0.990_454, 0.0], min = 0.0, tunable)]
    pub frequency: [R; 2],
    /// Damping ratios of the modes.
    #[variable(unit = "1", min = 0.0, max = 0.99, tunable)]
    pub damping_ratio: [R; 2],
}

#[derive(Clone, Variables)]
pub struct Inputs<R: Scalar> {
    /// The command to be shaped; each change spawns an impulse train.
    #[variable(discrete)]
    pub command: R,
    pub hoist: HoistInputs<R>,
}

#[derive(Clone, Variables)]
pub struct HoistInputs<R: Scalar> {
    /// Suspension length, for a frequency that follows it.
    #[variable(unit = "m", start = 10.0)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// The shaped command.
    #[variable(output, depends_on = ["command"])]
    pub shaped: R,
    /// Delay that the shaper adds: the time of its last impulse.
    #[variable(output, unit = "s", depends_on = ["command", "hoist.length"])]
    pub duration: R,
    /// Whether the last change of the command was shaped for the mode as it was then; else with the design before.
    #[variable(output, start = true, depends_on = ["command", "hoist.length"])]
    pub valid: bool,
    pub impulse: ImpulseVariables<R>,
}

#[derive(Clone, Variables)]
pub struct ImpulseVariables<R: Scalar> {
    /// How many impulses the shaper has that the last change of the command was shaped with.
    #[variable(output, depends_on = ["command", "hoist.length"])]
    pub count: i32,
    /// Their amplitudes; 0 beyond the count.
    #[variable(output, unit = "1", depends_on = ["command", "hoist.length"])]
    pub amplitude: [R; MAX_IMPULSES],
    /// Their times; 0 beyond the count.
    #[variable(output, unit = "s", depends_on = ["command", "hoist.length"])]
    pub time: [R; MAX_IMPULSES],
}
