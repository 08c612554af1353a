//! The state of an instance, to go back to or to go on from elsewhere (FMI 2.0.5, 2.1.8; FMI 3.0.2, 2.2.6.4).
//!
//! A snapshot is complete: an instance that takes it goes on to the same bits as the one it was taken from. Its portable
//! form is independent of the process and holds no pointers: a magic text with the version of the format, the
//! instantiation token, a checksum, and the values.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::course::{HIGHEST_ORDER, Term};
use crate::flow::Pace;
use crate::instance::{Instance, Refusal};
use crate::layout::Layout;
use crate::model::{Indicators, Model};
use crate::phase::{Interface, Phase};
use crate::schedule::Timer;
use crate::sizes::Sizes;
use crate::token::{self, Variant};
use crate::variables::{Value, Variables};

const MAGIC: &[u8] = b"Swayless state 2\n";

/// All that an instance is, beside what it was made with: its name, its log, its resources, and whether Event Mode is
/// used.
pub struct Snapshot<M: Model> {
    interface: Interface,
    clocked: bool,
    phase: Phase,
    t: f64,
    tolerance: f64,
    p: M::Parameters<f64>,
    u: M::Inputs<f64>,
    declared: M::States<f64>,
    x: M::States<f64>,
    d: M::Discrete<f64>,
    memory: Option<M::Memory>,
    next_event: Option<f64>,
    uninitialized: bool,
    disturbed: bool,
    course: Vec<Term>,
    pace: Pace<M::Indicators>,
    /// Of clocks: which are active, which have ticked, which the model has ticked; and where each is.
    clocks: (u64, u64, u64),
    pending: bool,
    timers: Vec<Timer>,
    intervals: Vec<f64>,
}

impl<M: Model> Instance<M> {
    /// The state now.
    pub fn snapshot(&mut self) -> Snapshot<M> {
        self.withdraw();
        let (timers, intervals) = self.schedule.parts();
        Snapshot {
            interface: self.interface,
            clocked: self.clocked,
            phase: self.phase,
            t: self.t,
            tolerance: self.tolerance,
            p: self.p.clone(),
            u: self.u.clone(),
            declared: self.declared.clone(),
            x: self.x.clone(),
            d: self.d.clone(),
            memory: self.memory.clone(),
            next_event: self.next_event,
            uninitialized: self.uninitialized,
            disturbed: self.disturbed,
            course: self.course.terms().to_vec(),
            pace: self.flow.pace(),
            clocks: (self.active, self.ticked, self.fired),
            pending: self.pending,
            timers: timers.to_vec(),
            intervals: intervals.to_vec(),
        }
    }

    /// Refuses a state from outside whose run goes on with parameters or start values out of bounds, on which models rely.
    /// How parameters go together is no matter here: tunable ones may have changed since.
    pub fn check_snapshot(&self, snapshot: &Snapshot<M>) -> Result<(), Refusal> {
        if snapshot.memory.is_none() || snapshot.uninitialized {
            return Ok(());
        }
        let sizes = Sizes::of::<M>(&snapshot.p);
        let has = |block, index| sizes.as_ref().is_none_or(|sizes| sizes.has(Layout::<M>::first(block) + index));
        let problems = self.out_of_bounds(&snapshot.p, &snapshot.declared, has);
        if problems.is_empty() {
            return Ok(());
        }
        Err(Refusal::error(format!("the serialized state is refused: {}", problems.join("; "))))
    }

    /// Goes to a state, from wherever the instance is.
    pub fn restore(&mut self, snapshot: &Snapshot<M>) -> Result<(), Refusal> {
        if snapshot.clocked != self.clocked {
            return Err(Refusal::error(
                "the state is one of an FMU with clocks and the instance is not, or the other way",
            ));
        }
        if snapshot.interface != self.interface {
            return Err(Refusal::error(format!(
                "the state is one of {:?}, but the instance is for {:?}",
                snapshot.interface, self.interface
            )));
        }
        self.tentative = None;
        (self.active, self.ticked, self.fired) = snapshot.clocks;
        self.pending = snapshot.pending;
        self.schedule.set_parts(&snapshot.timers, &snapshot.intervals);
        self.phase = snapshot.phase;
        self.disturbed = snapshot.disturbed;
        if self.phase == Phase::Event && self.interface == Interface::CoSimulation && !self.event_mode.used {
            // Where Event Mode is not used, the next step begins with the event.
            self.phase = Phase::Step;
            self.disturbed = true;
            self.pending = false;
        }
        self.t = snapshot.t;
        self.tolerance = snapshot.tolerance;
        self.p.clone_from(&snapshot.p);
        self.sizes = Sizes::of::<M>(&self.p).map(Arc::new);
        self.u.clone_from(&snapshot.u);
        self.declared.clone_from(&snapshot.declared);
        self.x.clone_from(&snapshot.x);
        self.d.clone_from(&snapshot.d);
        self.memory.clone_from(&snapshot.memory);
        self.next_event = snapshot.next_event;
        self.uninitialized = snapshot.uninitialized;
        self.course.hold();
        snapshot.course.iter().for_each(|term| self.course.set(*term));
        self.flow.set_pace(&snapshot.pace);
        self.moved();
        self.prepare_steps();
        Ok(())
    }
}

/// The values of a snapshot as they are written.
#[derive(Serialize, Deserialize)]
struct Portable<Memory> {
    interface: u8,
    clocked: bool,
    phase: u16,
    t: f64,
    tolerance: f64,
    next_event: Option<f64>,
    uninitialized: bool,
    disturbed: bool,
    p: Vec<Stored>,
    u: Vec<Stored>,
    declared: Vec<Stored>,
    x: Vec<Stored>,
    d: Vec<Stored>,
    memory: Option<Memory>,
    course: Vec<(u32, u32, f64)>,
    h: f64,
    first_stage: Option<Vec<f64>>,
    z: Option<Vec<f64>>,
    clocks: (u64, u64, u64),
    pending: bool,
    timers: Vec<Timer>,
    intervals: Vec<f64>,
}

/// A value that owns its text.
#[derive(Serialize, Deserialize)]
enum Stored {
    Real(f64),
    Integer(i32),
    Size(u32),
    Boolean(bool),
    Text(String),
    Enumeration(i32),
}

fn store<V: Variables<f64>>(values: &V) -> Vec<Stored> {
    let stored = |value: Value<'_, f64>| match value {
        Value::Real(value) => Stored::Real(value),
        Value::Integer(value) => Stored::Integer(value),
        Value::Size(value) => Stored::Size(value),
        Value::Boolean(value) => Stored::Boolean(value),
        Value::Text(value) => Stored::Text(value.to_string()),
        Value::Enumeration(value) => Stored::Enumeration(value),
    };
    (0..V::COUNT).map(|index| stored(values.get(index))).collect()
}

fn load<V: Variables<f64>>(stored: &[Stored]) -> Option<V> {
    let mut values = V::start();
    let fits = stored.len() == V::COUNT
        && stored.iter().enumerate().all(|(index, value)| {
            let value = match value {
                Stored::Real(value) => Value::Real(*value),
                Stored::Integer(value) => Value::Integer(*value),
                Stored::Size(value) => Value::Size(*value),
                Stored::Boolean(value) => Value::Boolean(*value),
                Stored::Text(value) => Value::Text(value),
                Stored::Enumeration(value) => Value::Enumeration(*value),
            };
            values.set(index, value)
        });
    fits.then_some(values)
}

impl<M: Model> Snapshot<M> {
    /// The portable form.
    pub fn to_bytes(&self) -> Result<Vec<u8>, Refusal> {
        let portable = Portable {
            interface: self.interface as u8,
            clocked: self.clocked,
            phase: self.phase as u16,
            t: self.t,
            tolerance: self.tolerance,
            next_event: self.next_event,
            uninitialized: self.uninitialized,
            disturbed: self.disturbed,
            p: store(&self.p),
            u: store(&self.u),
            declared: store(&self.declared),
            x: store(&self.x),
            d: store(&self.d),
            memory: self.memory.as_ref(),
            // A model has far fewer inputs than that.
            course: self.course.iter().map(|t| (u32::try_from(t.index).unwrap_or(0), t.order, t.value)).collect(),
            h: self.pace.h,
            first_stage: self.pace.first_stage.clone(),
            z: self.pace.z.as_ref().map(|z| z.as_ref().to_vec()),
            clocks: self.clocks,
            pending: self.pending,
            timers: self.timers.clone(),
            intervals: self.intervals.clone(),
        };
        let values = postcard::to_allocvec(&portable)
            .map_err(|error| Refusal::error(format!("the state cannot be serialized: {error}")))?;
        let mut bytes = MAGIC.to_vec();
        bytes.extend_from_slice(token::of::<M>(Variant::Plain).as_bytes());
        bytes.extend_from_slice(&token::checksum(&values));
        bytes.extend_from_slice(&values);
        Ok(bytes)
    }

    /// Reads the portable form; refuses what is not one, not of this FMU, or damaged.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Refusal> {
        let refuse = |why: &str| Refusal::error(format!("the serialized state is refused: {why}"));
        let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| refuse("it is none of Swayless, or of another version"))?;
        let token = token::of::<M>(Variant::Plain);
        let rest = rest
            .strip_prefix(token.as_bytes())
            .ok_or_else(|| refuse(&format!("it is not of the FMU {} with token {token}", M::INFO.name)))?;
        let damaged = || refuse("it is damaged");
        let (checksum, values) = rest.split_at_checked(16).ok_or_else(damaged)?;
        if checksum != token::checksum(values) {
            return Err(damaged());
        }
        let (portable, rest): (Portable<M::Memory>, _) = postcard::take_from_bytes(values).map_err(|_| damaged())?;
        if !rest.is_empty() {
            return Err(damaged());
        }
        Self::of(portable).ok_or_else(damaged)
    }

    fn of(portable: Portable<M::Memory>) -> Option<Self> {
        // A simulation that runs, or has run, has been initialized.
        let starting = Phase::Instantiated as u16 | Phase::Configuration as u16 | Phase::Initialization as u16;
        let may_lack = portable.phase & (starting | Phase::Failed as u16) != 0;
        if !may_lack && (portable.uninitialized || portable.memory.is_none()) {
            return None;
        }
        Some(Self {
            interface: [Interface::ModelExchange, Interface::CoSimulation, Interface::ScheduledExecution]
                .into_iter()
                .find(|interface| *interface as u8 == portable.interface)?,
            clocked: portable.clocked,
            phase: Phase::of(portable.phase).filter(|phase| *phase != Phase::Broken && !phase.is_callback())?,
            t: Some(portable.t).filter(|t| t.is_finite())?,
            tolerance: Some(portable.tolerance).filter(|tolerance| *tolerance > 0.0)?,
            p: load(&portable.p).filter(Sizes::fit::<M>)?,
            u: load(&portable.u)?,
            declared: load(&portable.declared)?,
            x: load(&portable.x)?,
            d: load(&portable.d)?,
            memory: portable.memory,
            next_event: portable.next_event,
            uninitialized: portable.uninitialized,
            disturbed: portable.disturbed,
            course: portable
                .course
                .iter()
                .map(|&(index, order, value)| {
                    let inside = (index as usize) < <M::Inputs<f64> as Variables<f64>>::COUNT;
                    let known = (1..=HIGHEST_ORDER).contains(&order);
                    (inside && known && value.is_finite()).then_some(Term { index: index as usize, order, value })
                })
                .collect::<Option<_>>()?,
            pace: Pace {
                h: Some(portable.h).filter(|h| *h > 0.0)?,
                first_stage: portable.first_stage,
                z: match portable.z {
                    Some(values) => Some(M::Indicators::of(&values)?),
                    None => None,
                },
            },
            clocks: portable.clocks,
            pending: portable.pending,
            intervals: Some(portable.intervals).filter(|intervals| intervals.len() == M::CLOCKS.len())?,
            timers: Some(portable.timers).filter(|timers| timers.len() == M::CLOCKS.len())?,
        })
    }
}
