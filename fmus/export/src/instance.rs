//! An instance of a model: its values, its log, and its way through the life cycle.

use std::ffi::CString;
use std::path::PathBuf;
use std::sync::Arc;

use crate::backup::Backup;
use crate::course::Course;
use crate::declaration::Declaration;
use crate::event::Tentative;
use crate::flow::Flow;
use crate::layout::{Block, Layout};
use crate::log::{Log, Severity};
use crate::model::{Model, Point};
use crate::phase::{Call, Interface, Phase};
use crate::schedule::Schedule;
use crate::sizes::Sizes;
use crate::structure::Structure;
use crate::variables::{Value, Variables};

/// The relative tolerance of co-simulation where the importer gives none.
pub const TOLERANCE: f64 = 1e-8;

/// Said where the life cycle should have made it impossible.
pub(crate) const NOT_INITIALIZED: &str = "the instance has not been initialized";

/// How far an importer that adds its steps up may be off, as a part of the time: half a million steps of 0.1 s get there.
const OFF: f64 = 1e-11;

/// Whether an event is due at a time: both may be sums that mean the same and differ by rounding.
pub(crate) fn is_due(event: f64, t: f64) -> bool {
    event <= t + OFF * t.abs()
}

/// Why a call was refused.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The status to return.
    pub severity: Severity,
    /// What is wrong and what to do.
    pub message: String,
}

impl Refusal {
    /// The instance cannot go on.
    pub fn error(message: impl Into<String>) -> Self {
        Self { severity: Severity::Error, message: message.into() }
    }

    /// The instance is unchanged and may try again.
    pub fn discard(message: impl Into<String>) -> Self {
        Self { severity: Severity::Discard, message: message.into() }
    }
}

/// How an importer of co-simulation deals with events (FMI 3.0.2, 4.1.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EventMode {
    /// `eventModeUsed`.
    pub used: bool,
    /// `earlyReturnAllowed`.
    pub early_return: bool,
}

/// An instance of a model.
pub struct Instance<M: Model> {
    pub(crate) interface: Interface,
    pub(crate) phase: Phase,
    /// Co-simulation with Event Mode: whether it is used, and whether a step may end at an event.
    pub(crate) event_mode: EventMode,
    pub(crate) name: String,
    pub(crate) log: Log,
    pub(crate) resources: Option<PathBuf>,
    pub(crate) parameter_declarations: Vec<Declaration>,
    pub(crate) input_declarations: Vec<Declaration>,
    pub(crate) state_declarations: Vec<Declaration>,

    pub(crate) t: f64,
    pub(crate) tolerance: f64,
    pub(crate) p: M::Parameters<f64>,
    pub(crate) u: M::Inputs<f64>,
    /// The start values of the states, as declared or set.
    pub(crate) declared: M::States<f64>,
    /// How inputs move within the next step.
    pub(crate) course: Course<M>,
    pub(crate) x: M::States<f64>,
    pub(crate) d: M::Discrete<f64>,
    /// None until initialization has read what the model remembers.
    pub(crate) memory: Option<M::Memory>,
    pub(crate) next_event: Option<f64>,
    /// Whether the importer ticks the clocks.
    pub(crate) clocked: bool,
    pub(crate) schedule: Schedule,
    /// Which elements of arrays are there, in a model with structural parameters.
    pub(crate) sizes: Option<Arc<Sizes>>,
    /// What depends on what, once it has been asked for.
    pub(crate) structure: Option<Box<Structure>>,
    /// The numbers of the scalars that the importer wants in intermediate updates.
    pub(crate) intermediate: Vec<usize>,
    /// Input clocks that are active, those that have ticked in this Event Mode, and output clocks that the model has
    /// ticked; one bit each.
    pub(crate) active: u64,
    pub(crate) ticked: u64,
    pub(crate) fired: u64,
    /// Event Mode: there is something to compute, and what has been computed for looking.
    pub(crate) pending: bool,
    pub(crate) tentative: Option<Tentative>,
    pub(crate) y: M::Outputs<f64>,
    pub(crate) dx: M::States<f64>,

    /// The start values have changed since x and d were initialized.
    pub(crate) uninitialized: bool,
    /// An input or tunable parameter has changed since the last event.
    pub(crate) disturbed: bool,
    pub(crate) outputs_stale: bool,
    pub(crate) derivatives_stale: bool,
    pub(crate) flow: Flow<M>,
    pub(crate) backup: Backup<M>,
    /// Texts handed to the importer, valid until the next call.
    pub(crate) returned: Vec<CString>,
}

impl<M: Model> Instance<M> {
    /// Makes an instance with the declared start values.
    pub fn new(interface: Interface, name: &str, log: Log, resources: Option<PathBuf>) -> Self {
        Self {
            interface,
            phase: Phase::Instantiated,
            event_mode: EventMode::default(),
            name: name.to_string(),
            log,
            resources,
            parameter_declarations: Layout::<M>::declarations(Block::Parameters),
            input_declarations: Layout::<M>::declarations(Block::Inputs),
            state_declarations: Layout::<M>::declarations(Block::States),
            t: 0.0,
            tolerance: TOLERANCE,
            p: Variables::start(),
            u: Variables::start(),
            declared: Variables::start(),
            course: Course::held(),
            x: Variables::start(),
            d: Variables::start(),
            memory: None,
            next_event: None,
            clocked: false,
            schedule: Schedule::new(M::CLOCKS),
            sizes: Sizes::of::<M>(&Variables::start()).map(Arc::new),
            structure: None,
            intermediate: Vec::new(),
            active: 0,
            ticked: 0,
            fired: 0,
            pending: false,
            tentative: None,
            y: Variables::start(),
            dx: Variables::start(),
            uninitialized: true,
            disturbed: false,
            outputs_stale: true,
            derivatives_stale: true,
            flow: Flow::new(),
            backup: Backup::default(),
            returned: Vec::new(),
        }
    }

    /// Refuses a call that is not allowed now.
    pub(crate) fn allow(&self, call: Call, function: &str) -> Result<(), Refusal> {
        if call.is_allowed(self.interface, self.phase) { Ok(()) } else { Err(self.not_allowed(function)) }
    }

    #[cold]
    #[inline(never)]
    fn not_allowed(&self, function: &str) -> Refusal {
        Refusal::error(format!(
            "{function} is not allowed: the instance is in phase {:?} of {:?}",
            self.phase, self.interface
        ))
    }

    /// Back to where the instance was when it was made; the log keeps its settings.
    pub fn reset(&mut self) {
        self.phase = Phase::Instantiated;
        self.t = 0.0;
        self.tolerance = TOLERANCE;
        self.p = Variables::start();
        self.u = Variables::start();
        self.declared = Variables::start();
        self.course.hold();
        self.x = Variables::start();
        self.d = Variables::start();
        self.memory = None;
        self.next_event = None;
        self.schedule = Schedule::new(M::CLOCKS);
        self.sizes = Sizes::of::<M>(&self.p).map(Arc::new);
        self.structure = None;
        (self.active, self.ticked, self.fired) = (0, 0, 0);
        (self.pending, self.tentative) = (false, None);
        self.uninitialized = true;
        self.disturbed = false;
        self.moved();
        self.flow.restart();
    }

    /// What follows from t, x, u, p and d must be evaluated again.
    pub(crate) fn moved(&mut self) {
        self.outputs_stale = true;
        self.derivatives_stale = true;
    }

    /// The point in time the instance is at.
    pub(crate) fn point(&self) -> Result<Point<'_, M, f64>, Refusal> {
        let Some(memory) = &self.memory else {
            return Err(Refusal::error(NOT_INITIALIZED));
        };
        Ok(Point { t: self.t, p: &self.p, u: &self.u, x: &self.x, d: &self.d, memory })
    }

    /// Refuses inputs that are not finite.
    pub(crate) fn check_inputs(&self) -> Result<(), Refusal> {
        let mut finite = true;
        self.u.each_real(&mut |value| finite &= value.is_finite());
        if finite {
            return Ok(());
        }
        let found = (0..<M::Inputs<f64> as Variables<f64>>::COUNT).find_map(|index| match self.u.get(index) {
            Value::Real(value) if !value.is_finite() => {
                Some(format!("input {} is {value}; set it to a finite number", Layout::<M>::name(Block::Inputs, index)))
            }
            _ => None,
        });
        Err(Refusal::discard(found.unwrap_or_default()))
    }

    /// Brings the outputs up to date.
    pub(crate) fn refresh_outputs(&mut self) -> Result<(), Refusal> {
        if self.outputs_stale {
            self.y = M::outputs(&self.point()?);
            self.outputs_stale = false;
        }
        Ok(())
    }

    /// Brings the derivatives up to date.
    pub(crate) fn refresh_derivatives(&mut self) -> Result<(), Refusal> {
        if self.derivatives_stale {
            self.dx = M::derivatives(&self.point()?);
            self.derivatives_stale = false;
        }
        Ok(())
    }
}
