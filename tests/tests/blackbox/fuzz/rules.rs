//! What the standards allow when: a table of its own, against which the FMUs' is checked (FMI 2.0.5, tables of 3.2.3 and
//! 4.2.4; FMI 3.0.2, 2.3, 3.2 and 4.2).
//!
//! Extending it: a row for a new call here, a variant of [`Call`](super::call::Call), its arguments in `script`.

use swayless_modeldesc::types::FmiVersion::{self, V2, V3};

use super::call::Call;
use super::library::Kind;

/// The states of the standards' state machines, as far as an importer can tell them apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    Instantiated,
    Initialization,
    Event,
    ContinuousTime,
    Step,
    /// Where model partitions of scheduled execution are activated.
    ClockActivation,
    Terminated,
    /// Structural parameters are set, before initialization.
    Configuration,
    /// Tunable structural parameters are set, during a run.
    Reconfiguration,
    /// A call returned Error.
    Error,
}

use Mode::{
    ClockActivation, Configuration, ContinuousTime, Error, Event, Initialization, Instantiated, Reconfiguration, Step,
    Terminated,
};

/// The calls by name; the arguments are made elsewhere.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Name {
    SetDebugLogging,
    SetupExperiment,
    EnterInitialization,
    ExitInitialization,
    Terminate,
    Reset,
    Get,
    Set,
    GetClock,
    SetClock,
    GetInterval,
    SetInterval,
    GetShift,
    SetShift,
    DoStep,
    EnterEvent,
    Update,
    EnterContinuousTime,
    EnterStep,
    CompletedStep,
    SetTime,
    SetStates,
    GetStates,
    GetDerivatives,
    GetIndicators,
    GetNominals,
    GetCounts,
    Directional,
    Adjoint,
    OutputDerivatives,
    InputDerivatives,
    GetState,
    SetState,
    FreeState,
    Serialize,
    Deserialize,
    Status,
    CancelStep,
    EnterConfiguration,
    ExitConfiguration,
    EvaluateDiscrete,
    Activate,
    Dependencies,
}

/// A call: where it is allowed, where it is not but need not be refused either, and how often it is tried.
pub struct Rule {
    pub name: Name,
    versions: &'static [FmiVersion],
    /// The kinds of instances it is for.
    kinds: Kinds,
    allowed: &'static [Mode],
    /// Not allowed, yet harmless: a lenient FMU may answer.
    tolerated: &'static [Mode],
    /// Nothing in its arguments can be wrong: where it is allowed, it must succeed.
    pub certain: bool,
    pub weight: u32,
}

#[derive(Clone, Copy, PartialEq)]
enum Kinds {
    All,
    ModelExchange,
    CoSimulation,
    /// Where the importer handles events.
    WithEvents,
    EventModeOfCoSimulation,
    ScheduledExecution,
    /// FMUs with structural parameters.
    Structural,
    /// Behind a capability that no FMU offers yet.
    None,
}

const BOTH: &[FmiVersion] = &[V2, V3];
const ANY: &[Mode] = &[
    Instantiated,
    Initialization,
    Event,
    ContinuousTime,
    Step,
    ClockActivation,
    Terminated,
    Configuration,
    Reconfiguration,
    Error,
];
/// FMI 2.0 lets an importer look at values where a run has ended or failed; FMI 3.0 is stricter after an error.
const LOOKING: &[Mode] = &[Initialization, Event, ContinuousTime, Step, ClockActivation, Terminated];
const FAILED: &[Mode] = &[Error];

impl Rule {
    const fn new(name: Name, weight: u32, kinds: Kinds, allowed: &'static [Mode]) -> Self {
        Self { name, versions: BOTH, kinds, allowed, tolerated: &[], certain: false, weight }
    }

    const fn only(self, versions: &'static [FmiVersion]) -> Self {
        Self { versions, ..self }
    }

    const fn tolerated(self, tolerated: &'static [Mode]) -> Self {
        Self { tolerated, ..self }
    }

    const fn certain(self) -> Self {
        Self { certain: true, ..self }
    }
}

/// All calls.
pub const RULES: &[Rule] = &[
    Rule::new(Name::SetDebugLogging, 1, Kinds::All, ANY),
    Rule::new(Name::SetupExperiment, 3, Kinds::All, &[Instantiated]).only(&[V2]),
    Rule::new(Name::EnterInitialization, 12, Kinds::All, &[Instantiated]),
    Rule::new(Name::ExitInitialization, 8, Kinds::All, &[Initialization]),
    // Reconfiguration Mode is within the state Initialized of FMI 3.0.
    Rule::new(Name::Terminate, 1, Kinds::All, &[Event, ContinuousTime, Step, ClockActivation, Reconfiguration])
        .certain(),
    Rule::new(Name::Reset, 1, Kinds::All, ANY).certain(),
    Rule::new(Name::Get, 8, Kinds::All, LOOKING).tolerated(&[Instantiated, Configuration, Reconfiguration, Error]),
    Rule::new(
        Name::Set,
        10,
        Kinds::All,
        &[Instantiated, Initialization, Event, ContinuousTime, Step, ClockActivation, Configuration, Reconfiguration],
    ),
    Rule::new(Name::GetClock, 1, Kinds::All, &[Event, ClockActivation]).only(&[V3]),
    Rule::new(Name::SetClock, 1, Kinds::WithEvents, &[Event]).only(&[V3]),
    Rule::new(Name::GetInterval, 1, Kinds::All, &[Initialization, Event, ClockActivation]).only(&[V3]),
    Rule::new(Name::SetInterval, 1, Kinds::All, &[Initialization, Event, ClockActivation]).only(&[V3]),
    Rule::new(Name::GetShift, 1, Kinds::All, &[Initialization]).only(&[V3]),
    Rule::new(Name::SetShift, 1, Kinds::All, &[Initialization]).only(&[V3]),
    Rule::new(Name::DoStep, 20, Kinds::CoSimulation, &[Step]),
    Rule::new(Name::EnterEvent, 3, Kinds::WithEvents, &[ContinuousTime, Step]).tolerated(&[Event]).certain(),
    Rule::new(Name::Update, 8, Kinds::WithEvents, &[Event]),
    Rule::new(Name::EnterContinuousTime, 6, Kinds::ModelExchange, &[Event]).certain(),
    Rule::new(Name::EnterStep, 6, Kinds::EventModeOfCoSimulation, &[Event]).only(&[V3]).certain(),
    Rule::new(Name::CompletedStep, 4, Kinds::ModelExchange, &[ContinuousTime]).certain(),
    // FMI 2.0 sets the time of an event in Event Mode, too.
    Rule::new(Name::SetTime, 6, Kinds::ModelExchange, &[ContinuousTime]).tolerated(&[Event]),
    Rule::new(Name::SetStates, 6, Kinds::ModelExchange, &[ContinuousTime]),
    Rule::new(Name::GetStates, 2, Kinds::ModelExchange, LOOKING).tolerated(FAILED),
    Rule::new(Name::GetDerivatives, 3, Kinds::ModelExchange, LOOKING).tolerated(FAILED),
    Rule::new(Name::GetIndicators, 3, Kinds::ModelExchange, LOOKING).tolerated(FAILED),
    Rule::new(Name::GetNominals, 1, Kinds::ModelExchange, LOOKING).tolerated(&[Instantiated, Error]),
    // The numbers are those of the description wherever they are asked for.
    Rule::new(Name::GetCounts, 1, Kinds::All, &[]).only(&[V3]).tolerated(ANY),
    Rule::new(Name::Directional, 4, Kinds::All, LOOKING).tolerated(FAILED),
    Rule::new(Name::Adjoint, 4, Kinds::All, LOOKING).only(&[V3]).tolerated(FAILED),
    Rule::new(Name::OutputDerivatives, 3, Kinds::CoSimulation, &[Step, Terminated]).tolerated(FAILED),
    Rule::new(Name::InputDerivatives, 3, Kinds::CoSimulation, &[Instantiated, Initialization, Step]).only(&[V2]),
    Rule::new(Name::GetState, 4, Kinds::All, ANY).certain(),
    Rule::new(Name::SetState, 4, Kinds::All, ANY),
    Rule::new(Name::FreeState, 1, Kinds::All, ANY).certain(),
    Rule::new(Name::Serialize, 1, Kinds::All, ANY),
    Rule::new(Name::Deserialize, 2, Kinds::All, ANY),
    Rule::new(Name::Status, 1, Kinds::CoSimulation, &[Step, Terminated]).only(&[V2]).tolerated(FAILED),
    Rule::new(Name::CancelStep, 1, Kinds::None, &[]).only(&[V2]),
    // A run that has begun may be reconfigured by tunable structural parameters only; without, the FMU may refuse.
    Rule::new(Name::EnterConfiguration, 2, Kinds::Structural, &[Instantiated])
        .only(&[V3])
        .tolerated(&[Step, Event, ClockActivation])
        .certain(),
    Rule::new(Name::ExitConfiguration, 6, Kinds::Structural, &[Configuration, Reconfiguration]).only(&[V3]).certain(),
    Rule::new(Name::EvaluateDiscrete, 1, Kinds::WithEvents, &[Event]).only(&[V3]),
    Rule::new(Name::Activate, 20, Kinds::ScheduledExecution, &[ClockActivation]).only(&[V3]),
    Rule::new(
        Name::Dependencies,
        1,
        Kinds::All,
        &[Instantiated, Initialization, Event, ContinuousTime, Step, ClockActivation],
    )
    .only(&[V3])
    .tolerated(&[Terminated, Configuration, Reconfiguration, Error]),
];

/// What must come of a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    Allowed,
    Tolerated,
    Refused,
}

impl Rule {
    /// Whether a version has the call at all.
    pub fn is_of(&self, version: FmiVersion) -> bool {
        self.versions.contains(&version)
    }

    /// What must come of the call.
    pub fn verdict(&self, kind: Kind, mode: Mode, structural: bool) -> Verdict {
        let event_mode = matches!(kind, Kind::EventMode { .. });
        let for_this_kind = match self.kinds {
            Kinds::All => true,
            Kinds::ModelExchange => kind == Kind::ModelExchange,
            Kinds::CoSimulation => kind == Kind::CoSimulation || event_mode,
            Kinds::WithEvents => kind == Kind::ModelExchange || event_mode,
            Kinds::EventModeOfCoSimulation => event_mode,
            Kinds::ScheduledExecution => kind == Kind::ScheduledExecution,
            Kinds::Structural => structural,
            Kinds::None => false,
        };
        if for_this_kind && self.allowed.contains(&mode) {
            Verdict::Allowed
        } else if for_this_kind && self.tolerated.contains(&mode) {
            Verdict::Tolerated
        } else {
            Verdict::Refused
        }
    }
}

/// The mode that a successful call leads to; restored states know their own.
pub fn next(call: &Call, kind: Kind, mode: Mode) -> Mode {
    match call {
        Call::EnterInitialization(_) => Initialization,
        Call::ExitInitialization if kind == Kind::CoSimulation => Step,
        Call::ExitInitialization if kind == Kind::ScheduledExecution => ClockActivation,
        Call::ExitInitialization | Call::EnterEvent => Event,
        Call::EnterContinuousTime => ContinuousTime,
        Call::EnterStep => Step,
        Call::EnterConfiguration if mode == Instantiated => Configuration,
        Call::EnterConfiguration => Reconfiguration,
        Call::ExitConfiguration if mode == Configuration => Instantiated,
        Call::ExitConfiguration if kind == Kind::ModelExchange => Event,
        Call::ExitConfiguration if kind == Kind::ScheduledExecution => ClockActivation,
        Call::ExitConfiguration => Step,
        Call::Terminate => Terminated,
        Call::Reset => Instantiated,
        _ => mode,
    }
}
