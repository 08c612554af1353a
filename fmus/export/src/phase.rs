//! The life cycle of an instance: its phases and the table of calls allowed in each.
//!
//! Sources: FMI 2.0.5 sections 3.2.3 and 4.2.4, FMI 3.0.2 sections 2.3, 3.3 and 4.3.

/// The interface an instance was made for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interface {
    /// The importer integrates.
    ModelExchange,
    /// The FMU integrates.
    CoSimulation,
    /// The importer says when each part is computed (FMI 3.0).
    ScheduledExecution,
}

/// Where an instance is in its life.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// Made or reset.
    Instantiated = 1,
    /// Initialization Mode.
    Initialization = 2,
    /// Event Mode, in co-simulation where the importer uses it.
    Event = 4,
    /// Continuous-Time Mode of model exchange.
    ContinuousTime = 8,
    /// Step Mode of co-simulation.
    Step = 16,
    /// Terminated.
    Terminated = 32,
    /// A call returned Error: only looking, resetting and freeing are left.
    Failed = 64,
    /// A call returned Fatal: nothing is left but freeing.
    Broken = 128,
    /// Configuration Mode: structural parameters may be set before initialization.
    Configuration = 256,
    /// Reconfiguration Mode: tunable structural parameters may be set while the simulation runs.
    Reconfiguration = 512,
    /// Intermediate Update Mode: the importer's callback runs within a step.
    Intermediate = 1024,
    /// Clock Activation Mode of scheduled execution.
    ClockActivation = 2048,
    /// Clock Update Mode: the importer's callback runs after a model partition.
    ClockUpdate = 4096,
}

impl Phase {
    /// The phase of a number, if there is one.
    pub fn of(number: u16) -> Option<Self> {
        use Phase::{
            Broken, ClockActivation, ClockUpdate, Configuration, ContinuousTime, Event, Failed, Initialization,
            Instantiated, Intermediate, Reconfiguration, Step, Terminated,
        };
        [
            Instantiated,
            Initialization,
            Event,
            ContinuousTime,
            Step,
            Terminated,
            Failed,
            Broken,
            Configuration,
            Reconfiguration,
            Intermediate,
            ClockActivation,
            ClockUpdate,
        ]
        .into_iter()
        .find(|phase| *phase as u16 == number)
    }

    /// Whether a callback of the importer runs, which may look and set but not end the instance.
    pub fn is_callback(self) -> bool {
        CALLBACK & self as u16 != 0
    }
}

const RUNNING: u16 =
    Phase::Event as u16 | Phase::ContinuousTime as u16 | Phase::Step as u16 | Phase::ClockActivation as u16;
const CONFIGURING: u16 = Phase::Configuration as u16 | Phase::Reconfiguration as u16;
const CALLBACK: u16 = Phase::Intermediate as u16 | Phase::ClockUpdate as u16;
const ANY: u16 = u16::MAX - Phase::Broken as u16 - CALLBACK;

/// What an importer asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "the names are the standard's, less what differs between its versions")]
pub enum Call {
    SetDebugLogging,
    SetupExperiment,
    EnterInitializationMode,
    ExitInitializationMode,
    Terminate,
    Reset,
    Get,
    Set,
    DoStep,
    GetStatus,
    EnterEventMode,
    NewDiscreteStates,
    EnterContinuousTimeMode,
    CompletedIntegratorStep,
    SetTime,
    SetContinuousStates,
    GetDerivatives,
    GetEventIndicators,
    GetContinuousStates,
    GetNominals,
    GetCounts,
    GetDependencies,
    State,
    GetDerivative,
    GetOutputDerivatives,
    SetInputDerivatives,
    EnterStepMode,
    EnterConfigurationMode,
    ExitConfigurationMode,
    GetClock,
    SetClock,
    GetInterval,
    SetInterval,
    GetShift,
    SetShift,
    ActivateModelPartition,
    /// No call of the importer: a step goes on after an intermediate update.
    ContinueStep,
    /// No call of the importer: Clock Update Mode ends.
    EndClockUpdate,
    /// A function behind a capability that is not offered: refused in every phase.
    NotOffered,
}

impl Call {
    /// The phases in which the call is allowed, as bits; and the interface it belongs to, if only one.
    fn allowed(self) -> (u16, Option<Interface>) {
        use Interface::{CoSimulation, ModelExchange, ScheduledExecution};
        const INSTANTIATED: u16 = Phase::Instantiated as u16;
        const INITIALIZATION: u16 = Phase::Initialization as u16;
        const EVENT: u16 = Phase::Event as u16;
        const CONTINUOUS: u16 = Phase::ContinuousTime as u16;
        const STEP: u16 = Phase::Step as u16;
        const INTERMEDIATE: u16 = Phase::Intermediate as u16;
        const ACTIVATION: u16 = Phase::ClockActivation as u16;
        const UPDATE: u16 = Phase::ClockUpdate as u16;
        const OVER: u16 = Phase::Terminated as u16 | Phase::Failed as u16;
        const LOOKING: u16 = INITIALIZATION | RUNNING | OVER;
        match self {
            Self::SetDebugLogging | Self::Reset | Self::State => (ANY, None),
            Self::SetupExperiment | Self::EnterInitializationMode => (INSTANTIATED, None),
            Self::ExitInitializationMode => (INITIALIZATION, None),
            Self::Terminate => (RUNNING | Phase::Reconfiguration as u16, None),
            // Before initialization what has been set can be read.
            Self::Get => (INSTANTIATED | LOOKING | CONFIGURING | CALLBACK, None),
            Self::GetDerivative => (LOOKING, None),
            Self::Set => (INSTANTIATED | INITIALIZATION | RUNNING | CONFIGURING | CALLBACK, None),
            Self::DoStep => (STEP, Some(CoSimulation)),
            Self::ContinueStep => (STEP | INTERMEDIATE, Some(CoSimulation)),
            Self::SetInputDerivatives => (INSTANTIATED | INITIALIZATION | STEP, Some(CoSimulation)),
            Self::GetStatus => (STEP | OVER, Some(CoSimulation)),
            // Importers of FMI 2.0 enter Event Mode after initialization too, which ends in it.
            Self::EnterEventMode => (CONTINUOUS | STEP | EVENT, None),
            Self::NewDiscreteStates => (EVENT, None),
            Self::EnterContinuousTimeMode => (EVENT, Some(ModelExchange)),
            Self::EnterStepMode => (EVENT, Some(CoSimulation)),
            Self::GetOutputDerivatives => (STEP | INTERMEDIATE | OVER, Some(CoSimulation)),
            Self::CompletedIntegratorStep | Self::SetContinuousStates => (CONTINUOUS, Some(ModelExchange)),
            Self::SetTime => (EVENT | CONTINUOUS, Some(ModelExchange)),
            Self::GetDerivatives | Self::GetEventIndicators | Self::GetContinuousStates => {
                (LOOKING, Some(ModelExchange))
            }
            // FMI 2.0 allows it from the begin.
            Self::GetNominals => (INSTANTIATED | LOOKING, Some(ModelExchange)),
            Self::GetCounts | Self::GetDependencies => (INSTANTIATED | LOOKING, None),
            Self::EnterConfigurationMode => (INSTANTIATED | EVENT | STEP | ACTIVATION, None),
            Self::ExitConfigurationMode => (CONFIGURING, None),
            Self::GetClock => (EVENT | ACTIVATION | UPDATE, None),
            Self::SetClock => (EVENT, None),
            Self::GetInterval => (INITIALIZATION | EVENT | ACTIVATION | UPDATE, None),
            Self::SetInterval => (INITIALIZATION | EVENT | ACTIVATION, None),
            Self::GetShift | Self::SetShift => (INITIALIZATION, None),
            // While one partition is in Clock Update Mode, the scheduler may preempt it with another.
            Self::ActivateModelPartition | Self::EndClockUpdate => (ACTIVATION | UPDATE, Some(ScheduledExecution)),
            Self::NotOffered => (0, None),
        }
    }

    /// Whether an instance of the interface may take the call in the phase.
    pub fn is_allowed(self, interface: Interface, phase: Phase) -> bool {
        let (phases, only) = self.allowed();
        phases & phase as u16 != 0 && only.is_none_or(|only| only == interface)
    }
}
