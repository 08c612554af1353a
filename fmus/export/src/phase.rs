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
}

impl Phase {
    /// The phase of a number, if there is one.
    pub fn of(number: u8) -> Option<Self> {
        use Phase::{Broken, ContinuousTime, Event, Failed, Initialization, Instantiated, Step, Terminated};
        [Instantiated, Initialization, Event, ContinuousTime, Step, Terminated, Failed, Broken]
            .into_iter()
            .find(|phase| *phase as u8 == number)
    }
}

const RUNNING: u8 = Phase::Event as u8 | Phase::ContinuousTime as u8 | Phase::Step as u8;
const ANY: u8 = u8::MAX - Phase::Broken as u8;

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
    State,
    GetDerivative,
    GetOutputDerivatives,
    SetInputDerivatives,
    EnterStepMode,
    /// A function behind a capability that is not offered: refused in every phase.
    NotOffered,
}

impl Call {
    /// The phases in which the call is allowed, as bits; and the interface it belongs to, if only one.
    fn allowed(self) -> (u8, Option<Interface>) {
        use Interface::{CoSimulation, ModelExchange};
        const INSTANTIATED: u8 = Phase::Instantiated as u8;
        const INITIALIZATION: u8 = Phase::Initialization as u8;
        const EVENT: u8 = Phase::Event as u8;
        const CONTINUOUS: u8 = Phase::ContinuousTime as u8;
        const STEP: u8 = Phase::Step as u8;
        const LOOKING: u8 = INITIALIZATION | RUNNING | Phase::Terminated as u8 | Phase::Failed as u8;
        match self {
            Self::SetDebugLogging | Self::Reset | Self::State => (ANY, None),
            Self::SetupExperiment | Self::EnterInitializationMode => (INSTANTIATED, None),
            Self::ExitInitializationMode => (INITIALIZATION, None),
            Self::Terminate => (RUNNING, None),
            Self::Get | Self::GetDerivative => (LOOKING, None),
            Self::Set => (INSTANTIATED | INITIALIZATION | RUNNING, None),
            Self::DoStep => (STEP, Some(CoSimulation)),
            Self::SetInputDerivatives => (INSTANTIATED | INITIALIZATION | STEP, Some(CoSimulation)),
            Self::GetStatus => (STEP | Phase::Terminated as u8 | Phase::Failed as u8, Some(CoSimulation)),
            Self::EnterEventMode => (CONTINUOUS | STEP, None),
            Self::NewDiscreteStates => (EVENT, None),
            Self::EnterContinuousTimeMode => (EVENT, Some(ModelExchange)),
            Self::EnterStepMode => (EVENT, Some(CoSimulation)),
            Self::GetOutputDerivatives => (STEP | Phase::Terminated as u8 | Phase::Failed as u8, Some(CoSimulation)),
            Self::CompletedIntegratorStep | Self::SetContinuousStates => (CONTINUOUS, Some(ModelExchange)),
            Self::SetTime => (EVENT | CONTINUOUS, Some(ModelExchange)),
            Self::GetDerivatives | Self::GetEventIndicators | Self::GetContinuousStates | Self::GetNominals => {
                (LOOKING, Some(ModelExchange))
            }
            Self::GetCounts => (INSTANTIATED | LOOKING, None),
            Self::NotOffered => (0, None),
        }
    }

    /// Whether an instance of the interface may take the call in the phase.
    pub fn is_allowed(self, interface: Interface, phase: Phase) -> bool {
        let (phases, only) = self.allowed();
        phases & phase as u8 != 0 && only.is_none_or(|only| only == interface)
    }
}
