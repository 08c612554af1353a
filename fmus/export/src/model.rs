//! The model: a handful of plain structs and pure functions of one point in time.

use std::fmt;
use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;
use swayless_scalar::Scalar;

use crate::clocks::Clock;
use crate::terminal::Terminal;
use crate::variables::Variables;

/// A model that can be exported. All it says is mathematics; nothing in it knows FMI.
pub trait Model: Sized + Send + 'static {
    /// What it is.
    const INFO: Info;
    /// p: fixed or tunable.
    type Parameters<R: Scalar>: Variables<R>;
    /// u.
    type Inputs<R: Scalar>: Variables<R>;
    /// x: continuous; real numbers only.
    type States<R: Scalar>: Variables<R>;
    /// y: continuous; real numbers only.
    type Outputs<R: Scalar>: Variables<R>;
    /// d: changes at events only; numbers, truth values, enumerations.
    type Discrete<R: Scalar>: Variables<R>;
    /// What a model remembers beside its variables: event queues, tables. Copied before a step that has events, so
    /// `clone_from` should reuse memory; deserialization must refuse what cannot be.
    type Memory: Clone + Default + Send + Serialize + DeserializeOwned;
    /// z: `[f64; N]`; a change between > 0 and ≤ 0 is an event.
    type Indicators: Indicators;

    /// What is wrong with parameters and start values of states, beyond their declared bounds: all of it.
    fn check(_p: &Self::Parameters<f64>, _declared: &Self::States<f64>) -> Vec<Problem> {
        Vec::new()
    }
    /// The memory when initialization begins. Files are read here and nowhere else.
    fn memory(_p: &Self::Parameters<f64>, _environment: &Environment<'_>) -> Result<Self::Memory, Problem> {
        Ok(Self::Memory::default())
    }
    /// x when initialization ends, from the start values declared or set by the user.
    fn start<R: Scalar>(_p: &Self::Parameters<R>, _u: &Self::Inputs<R>, declared: &Self::States<R>) -> Self::States<R> {
        declared.clone()
    }
    /// ẋ = f(t, x, d, u, p).
    fn derivatives<R: Scalar>(at: &Point<'_, Self, R>) -> Self::States<R>;
    /// y = g(t, x, d, u, p).
    fn outputs<R: Scalar>(at: &Point<'_, Self, R>) -> Self::Outputs<R>;
    /// z = h(t, x, d, u, p).
    fn indicators(_at: &Point<'_, Self, f64>) -> Self::Indicators {
        Self::Indicators::quiet()
    }
    /// Instants at which a part of the model is computed.
    const CLOCKS: &'static [Clock] = &[];
    /// The interval of a periodic clock whose interval comes from parameters (s); 0 for every communication point and
    /// event, which an FMU with clocks refuses.
    fn interval(_clock: usize, _p: &Self::Parameters<f64>) -> f64 {
        0.0
    }
    /// When an aperiodic clock ticks next (s), if it does.
    fn next_tick(_clock: usize, _at: &Point<'_, Self, f64>) -> Option<f64> {
        None
    }
    /// What is computed when a clock ticks: d⁺, x⁺ and memory. The model's own event follows.
    fn tick(_clock: usize, _at: &mut Event<'_, Self>) {}
    /// d⁺ and x⁺, and when the next time event falls due (after `t`). Called when initialization ends and at every
    /// event; a second call at the same point changes nothing.
    fn event(_at: &mut Event<'_, Self>) -> Option<f64> {
        None
    }
}

/// The values of event indicators.
pub trait Indicators: AsRef<[f64]> + Clone + Send {
    /// How many there are.
    const COUNT: usize;
    /// The indicators of these values, if they are as many.
    fn of(values: &[f64]) -> Option<Self>
    where
        Self: Sized;
    /// Indicators of no event.
    fn quiet() -> Self;
}

impl<const N: usize> Indicators for [f64; N] {
    const COUNT: usize = N;
    fn of(values: &[f64]) -> Option<Self> {
        values.try_into().ok()
    }
    fn quiet() -> Self {
        [1.0; N]
    }
}

/// What a model is.
#[derive(Debug, Clone, Copy)]
pub struct Info {
    /// `modelName` and `modelIdentifier`.
    pub name: &'static str,
    /// One line.
    pub description: &'static str,
    /// Equations, variables and sources, in Markdown.
    pub documentation: &'static str,
    /// The icon, in SVG.
    pub icon: &'static str,
    /// The groups of variables that are connected together.
    pub terminals: &'static [Terminal],
    /// The length of a typical experiment (s).
    pub stop_time: f64,
    /// A typical communication step (s).
    pub step_size: f64,
}

impl Info {
    /// What a model is with nothing said but its name and a line: a page of that, a plain icon, no terminals,
    /// and 10 s in steps of 10 ms.
    pub const fn new(name: &'static str, description: &'static str) -> Self {
        Self {
            name,
            description,
            documentation: description,
            icon: PLAIN_ICON,
            terminals: &[],
            stop_time: 10.0,
            step_size: 0.01,
        }
    }
}

const PLAIN_ICON: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 128 128" width="128" height="128">
  <rect x="8" y="8" width="112" height="112" rx="12" fill="#f5f7f9" stroke="#3b4a5a" stroke-width="6"/>
</svg>"##;

/// A point in time at which the equations are evaluated.
pub struct Point<'a, M: Model, R: Scalar> {
    /// t (s).
    pub t: R,
    /// p.
    pub p: &'a M::Parameters<R>,
    /// u.
    pub u: &'a M::Inputs<R>,
    /// x.
    pub x: &'a M::States<R>,
    /// d.
    pub d: &'a M::Discrete<R>,
    /// The memory.
    pub memory: &'a M::Memory,
}

/// A point in time at which discrete variables, states and memory may jump.
pub struct Event<'a, M: Model> {
    /// t (s).
    pub t: f64,
    /// Whether this is the event that ends initialization.
    pub initial: bool,
    /// p.
    pub p: &'a M::Parameters<f64>,
    /// u.
    pub u: &'a M::Inputs<f64>,
    /// x.
    pub x: &'a mut M::States<f64>,
    /// d.
    pub d: &'a mut M::Discrete<f64>,
    /// The memory.
    pub memory: &'a mut M::Memory,
    /// The interval of each clock (s).
    pub intervals: &'a [f64],
    pub(crate) fired: &'a mut u64,
}

impl<M: Model> Event<'_, M> {
    /// The point that equations are evaluated at, as it is now.
    pub fn point(&self) -> Point<'_, M, f64> {
        Point { t: self.t, p: self.p, u: self.u, x: self.x, d: self.d, memory: self.memory }
    }

    /// Ticks an output clock.
    pub fn fire(&mut self, clock: usize) {
        *self.fired |= 1 << clock;
    }
}

/// What lies around an instance.
#[derive(Debug, Clone, Copy)]
pub struct Environment<'a> {
    /// The folder of the FMU's resources, if the importer gave one.
    pub resources: Option<&'a Path>,
}

/// What is wrong with a parameter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The parameter's name.
    pub variable: String,
    /// What is wrong and what to do, as it goes on after the name: "is 3; it must be …".
    pub message: String,
}

impl Problem {
    /// A problem with a parameter.
    pub fn new(variable: impl Into<String>, message: impl Into<String>) -> Self {
        Self { variable: variable.into(), message: message.into() }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.variable, self.message)
    }
}
