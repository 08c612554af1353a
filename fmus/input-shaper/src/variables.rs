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
    /// Zero vibration and three derivatives: five impulses, two periods long.
    ZVDDD,
    /// Extra-insensitive: three impulses, a period long, with the vibration limit at the design frequency.
    EI,
    /// Two-hump extra-insensitive: four impulses, one and a half periods long; no vibration at the design frequency, humps of the
    /// vibration limit beside it.
    TwoHumpEI,
    /// Three-hump extra-insensitive: five impulses, two periods long; humps of the vibration limit at the design frequency and beside.
    ThreeHumpEI,
    /// Specified insensitivity: the shortest train of positive impulses that keeps the vibration limit over a range of frequencies.
    SI,
    /// Unity-magnitude zero vibration: impulses +1, −1, +1, a third of a period long.
    UMZV,
    /// Unity-magnitude zero vibration and derivative: impulses +1, −1, +1, −1, +1, three quarters of a period long.
    UMZVD,
    /// Unity-magnitude extra-insensitive: impulses +1, −1, +1, −1, +1, three quarters of a period long, with the vibration limit at
    /// the design frequency.
    UMEI,
    /// UMZV for a drive that accelerates and brakes with different time constants: one train for a command that grows, one for a
    /// command that shrinks.
    UMZVc,
    /// ZVD for a drive with an acceleration limit: no vibration behind the ramps that it makes of a change.
    ALZVD,
    /// EI for a drive with an acceleration limit.
    ALEI,
    /// SI for a drive with an acceleration limit: the shortest command that keeps the vibration limit over a range of frequencies.
    ALSI,
    /// A shaper for each of two modes, convolved: as long as both.
    Convolved,
    /// Minimum impulses for two modes: up to three, which may be negative and greater than 1.
    MinimumImpulse,
    /// Specified insensitivity around each of two modes: the shortest train of positive impulses that keeps the limit over both ranges.
    MultiModeSI,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Enumeration)]
pub enum FrequencySource {
    /// The frequencies are mode.frequency.
    Parameter,
    /// The frequencies follow the suspension length when the command changes.
    Length,
}

#[derive(Clone, Variables)]
pub struct Parameters<R: Scalar> {
    /// The kind of shaper.
    #[variable(start = Kind::ZV)]
    pub kind: Kind,
    pub mode: ModeParameters<R>,
    /// Where the design frequencies come from.
    #[variable(start = FrequencySource::Parameter)]
    pub frequency_source: FrequencySource,
    /// Gravity, for frequencies that follow the length.
    #[variable(unit = "m/s2", start = 9.81, min = 1e-3)]
    pub gravity: R,
    pub rigging: RiggingParameters<R>,
    /// Mass of the payload over that of the hook, for frequencies that follow the length; 0 for a single pendulum.
    #[variable(unit = "1", min = 0.0, max = 1e6, tunable)]
    pub mass_ratio: R,
    /// Residual vibration that the kinds with EI or SI in their name allow (V), as a share of the unshaped one.
    #[variable(unit = "1", start = 0.05, min = 0.0, max = 0.5, tunable)]
    pub vibration_limit: R,
    /// Width of the range of frequencies in which SI, ALSI and MultiModeSI keep the vibration limit (I), as a share of the design frequency.
    #[variable(unit = "1", start = 0.4, min = 0.0, max = 1.5, tunable)]
    pub insensitivity: R,
    /// Acceleration limit of the drive behind the kinds with AL in their name.
    #[variable(start = 1.0, min = 1e-9, tunable)]
    pub acceleration_limit: R,
    /// Greatest change of the command that the kinds with AL in their name are designed for.
    #[variable(start = 1.0, min = 0.0, max = 1e6, tunable)]
    pub velocity_limit: R,
    /// Whether the kinds with AL in their name are designed for each change of the command; if not, for the velocity limit.
    #[variable(start = true, tunable)]
    pub redesign: bool,
    /// Time constant with which the drive behind UMZVc speeds up.
    #[variable(unit = "s", min = 0.0, max = 1e3, tunable)]
    pub acceleration_time_constant: R,
    /// Time constant with which the drive behind UMZVc slows down.
    #[variable(unit = "s", min = 0.0, max = 1e3, tunable)]
    pub braking_time_constant: R,
    /// Which solution of MinimumImpulse: 1 is the shortest.
    #[variable(start = 1, min = 1, max = 32)]
    pub solution: i32,
    /// The kinds that Convolved is made of, one for each mode: those for one mode.
    #[variable(start = [Kind::ZV, Kind::ZV])]
    pub base_kind: [Kind; 2],
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
pub struct RiggingParameters<R: Scalar> {
    /// From the hook to the payload, for frequencies that follow the length; 0 for a single pendulum.
    #[variable(unit = "m", min = 0.0, tunable)]
    pub length: R,
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
    /// Suspension length, for frequencies that follow it.
    #[variable(unit = "m", start = 10.0)]
    pub length: R,
}

#[derive(Clone, Variables)]
pub struct Discrete<R: Scalar> {
    /// The shaped command.
    #[variable(output, depends_on = ["command", "hoist.length"])]
    pub shaped: R,
    /// Delay that the shaper adds: the time of its last impulse.
    #[variable(output, unit = "s", depends_on = ["command", "hoist.length"])]
    pub duration: R,
    /// Whether the last change of the command was shaped for the modes as they were then; else with the design before.
    #[variable(output, start = true, depends_on = ["command", "hoist.length"])]
    pub valid: bool,
    /// Whether trains overlap that are exact only alone: those of UMZVc and of the kinds with AL in their name.
    #[variable(output, depends_on = ["command", "hoist.length"])]
    pub interference: bool,
    pub impulse: ImpulseVariables<R>,
    pub braking: BrakingVariables<R>,
}

#[derive(Clone, Variables)]
pub struct ImpulseVariables<R: Scalar> {
    /// How many impulses the shaper has that the last change of the command was shaped with; for the kinds with AL in their name
    /// it is that for the velocity limit.
    #[variable(output, depends_on = ["command", "hoist.length"])]
    pub count: i32,
    /// Their amplitudes; 0 beyond the count.
    #[variable(output, unit = "1", depends_on = ["command", "hoist.length"])]
    pub amplitude: [R; MAX_IMPULSES],
    /// Their times; 0 beyond the count.
    #[variable(output, unit = "s", depends_on = ["command", "hoist.length"])]
    pub time: [R; MAX_IMPULSES],
}

#[derive(Clone, Variables)]
pub struct BrakingVariables<R: Scalar> {
    pub impulse: BrakingImpulseVariables<R>,
}

#[derive(Clone, Variables)]
pub struct BrakingImpulseVariables<R: Scalar> {
    /// Times of the impulses 1, −1, 1 of UMZVc for a command that shrinks; 0 for all other kinds.
    #[variable(output, unit = "s", depends_on = ["command", "hoist.length"])]
    pub time: [R; 3],
}
