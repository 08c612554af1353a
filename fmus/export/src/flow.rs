//! The continuous part of co-simulation: integrates from event to event and finds where state events lie.

use crate::course::Course;
use crate::integrator::DormandPrince;
use crate::layout::{Block, Layout};
use crate::model::{Indicators, Model, Point};
use crate::variables::Variables;

/// The share of the tolerance that one step may use, since the errors of many steps add up: so a payload that swings by
/// 1 rad for a minute keeps its energy to ten times the tolerance.
const SHARE: f64 = 0.25;
/// A step shorter than this part of the time is taken as stuck.
const SHORTEST: f64 = 1e-15;
/// Two crossings closer than this part of the time are not told apart.
const TWICE: f64 = 1e-9;
/// A communication step that needs more steps than this, about a second of computing, does not end in useful time.
const MOST_STEPS: usize = 1_000_000;
/// The bracket of an event is narrow enough long before.
const MOST_TRIALS: usize = 150;

/// The integrator with its buffers.
pub struct Flow<M: Model> {
    rk: DormandPrince,
    x: Vec<f64>,
    before: Vec<f64>,
    nominal: Vec<f64>,
    /// x and u as the model sees them, while a step is under way.
    scratch: Seen<M>,
    /// The length that the error control wants for the next step.
    h: f64,
    /// The first stage holds the derivatives at x.
    primed: bool,
    z: Option<M::Indicators>,
}

/// How far the integrator is, beside its buffers: with it, an integration goes on to the same bits.
#[derive(Debug, Clone)]
pub struct Pace<Z> {
    /// The length that the error control wants for the next step.
    pub h: f64,
    /// The derivatives at x, if they are known.
    pub first_stage: Option<Vec<f64>>,
    /// The indicators at x, if they are known.
    pub z: Option<Z>,
}

impl<M: Model> Flow<M> {
    /// How far the integrator is.
    pub fn pace(&mut self) -> Pace<M::Indicators> {
        let first_stage = self.primed.then(|| self.rk.first_stage().to_vec());
        Pace { h: self.h, first_stage, z: self.z.clone() }
    }

    /// Goes on from where another integrator was. Stages of another number of states are not taken.
    pub fn set_pace(&mut self, pace: &Pace<M::Indicators>) {
        self.h = pace.h;
        self.z.clone_from(&pace.z);
        let place = self.rk.first_stage();
        self.primed = match &pace.first_stage {
            Some(stage) if stage.len() == place.len() => {
                place.copy_from_slice(stage);
                true
            }
            _ => false,
        };
    }

    /// With buffers for the model's states.
    pub fn new() -> Self {
        let n = Layout::<M>::STATE_COUNT;
        let mut nominal = vec![1.0; n];
        for declaration in Layout::<M>::declarations(Block::States) {
            if let Some(value) = declaration.nominal {
                nominal[declaration.first..declaration.first + declaration.count()].fill(value);
            }
        }
        Self {
            rk: DormandPrince::new(n),
            x: vec![0.0; n],
            before: vec![0.0; n],
            nominal,
            scratch: Seen { x: Variables::start(), u: Variables::start() },
            h: f64::INFINITY,
            primed: false,
            z: None,
        }
    }

    /// Forgets all of the past.
    pub fn restart(&mut self) {
        self.begin_anew_with(f64::INFINITY);
    }

    /// The length that the error control wants for the next step.
    pub fn wanted_step(&self) -> f64 {
        self.h
    }

    /// Begins anew with a step of this length.
    pub fn begin_anew_with(&mut self, h: f64) {
        self.h = h;
        self.begin_anew();
    }

    /// Something has jumped: derivatives and indicators must be evaluated again.
    pub fn begin_anew(&mut self) {
        self.primed = false;
        self.z = None;
    }

    /// Keeps the states, to tell later whether they jumped.
    pub fn remember_states(&mut self, x: &M::States<f64>) {
        x.write_reals(&mut self.before);
    }

    /// Whether the states differ from those remembered.
    pub fn states_differ(&mut self, x: &M::States<f64>) -> bool {
        x.write_reals(&mut self.x);
        self.x != self.before
    }
}

/// What is made anew for each evaluation.
struct Seen<M: Model> {
    x: M::States<f64>,
    u: M::Inputs<f64>,
}

/// The equations with all held but time, states and inputs that move.
pub struct Field<'a, M: Model> {
    /// p.
    pub p: &'a M::Parameters<f64>,
    /// u, where it is held.
    pub u: &'a M::Inputs<f64>,
    /// u, where it moves.
    pub course: &'a Course<M>,
    /// d.
    pub d: &'a M::Discrete<f64>,
    /// The memory.
    pub memory: &'a M::Memory,
    /// States that are not there, with the lengths that arrays have: they rest.
    pub idle: &'a [usize],
}

impl<M: Model> Field<'_, M> {
    #[inline]
    fn at<'a>(&'a self, t: f64, x: &[f64], seen: &'a mut Seen<M>) -> Point<'a, M, f64> {
        seen.x.read_reals(x);
        let u = if self.course.is_held() {
            self.u
        } else {
            self.course.at(t, &mut seen.u);
            &seen.u
        };
        Point { t, p: self.p, u, x: &seen.x, d: self.d, memory: self.memory }
    }

    #[inline]
    fn derivatives(&self, t: f64, x: &[f64], dx: &mut [f64], seen: &mut Seen<M>) {
        M::derivatives(&self.at(t, x, seen)).write_reals(dx);
        for state in self.idle {
            dx[*state] = 0.0;
        }
    }

    #[inline]
    fn indicators(&self, t: f64, x: &[f64], seen: &mut Seen<M>) -> M::Indicators {
        M::indicators(&self.at(t, x, seen))
    }
}

/// The equations cannot be integrated beyond this time (s).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stuck(pub f64);

impl<M: Model> Flow<M> {
    /// Integrates `x` from `t` to `target` or to the first state event before it, or for `one_step`. Returns whether an
    /// event was found.
    pub fn advance(
        &mut self,
        field: &Field<'_, M>,
        states: &mut M::States<f64>,
        t: &mut f64,
        (target, one_step): (f64, bool),
        tolerance: f64,
    ) -> Result<bool, Stuck> {
        states.write_reals(&mut self.x);
        let found = self.integrate(field, t, target, one_step, SHARE * tolerance);
        states.read_reals(&self.x);
        found
    }

    fn integrate(
        &mut self,
        field: &Field<'_, M>,
        now: &mut f64,
        target: f64,
        one_step: bool,
        tolerance: f64,
    ) -> Result<bool, Stuck> {
        let Self { rk, x, nominal, scratch: seen, h: wanted, primed, z, .. } = self;
        for _ in 0..MOST_STEPS {
            if *now >= target {
                return Ok(false);
            }
            let t = *now;
            if !*primed {
                field.derivatives(t, x, rk.first_stage(), seen);
                *primed = true;
            }
            let before = match z.take() {
                Some(known) => known,
                None => field.indicators(t, x, seen),
            };
            let rest = target - t;
            let h = wanted.min(rest);
            let error = rk.step(|t, x, dx| field.derivatives(t, x, dx, seen), t, x, h, tolerance, nominal);
            // An error that is not a number says that the step left where the equations hold.
            if error.is_nan() || error > 1.0 {
                *z = Some(before);
                *wanted = h * if error.is_finite() { (0.9 * error.powf(-0.2)).max(0.2) } else { 0.1 };
                if *wanted < SHORTEST * t.abs().max(1e-3) {
                    return Err(Stuck(t));
                }
                continue;
            }
            let after = field.indicators(t + h, &rk.end, seen);
            if crossing(&before, &after) {
                let event = locate(field, seen, rk, (t, x), (before, after), h, (tolerance, nominal));
                x.copy_from_slice(&rk.end);
                *now = if event >= rest { target } else { t + event };
                *primed = false;
                return Ok(true);
            }
            // There and back within one step: smaller steps will see it.
            if M::Indicators::COUNT > 0
                && h > TWICE * t.abs().max(1.0)
                && crossing(&before, &field.indicators(t + 0.5 * h, rk.middle(x, h), seen))
            {
                *z = Some(before);
                *wanted = 0.5 * h;
                continue;
            }
            *z = Some(after);
            x.copy_from_slice(&rk.end);
            rk.accept();
            *now = if h >= rest { target } else { t + h };
            let grown = if error > 1e-4 { h * (0.9 * error.powf(-0.2)).clamp(0.2, 5.0) } else { h * 5.0 };
            // A step cut short by the communication point says nothing against a longer one.
            *wanted = if h < *wanted { wanted.max(grown) } else { grown };
            if one_step {
                return Ok(false);
            }
        }
        Err(Stuck(*now))
    }
}

/// The length of the step from (t, x) that ends just behind the first event in (0, h]; leaves the state there in
/// `rk.end`. Every trial is a true step, so that the state at an event is as accurate as any other.
fn locate<M: Model>(
    field: &Field<'_, M>,
    seen: &mut Seen<M>,
    rk: &mut DormandPrince,
    (t, x): (f64, &[f64]),
    (before, after): (M::Indicators, M::Indicators),
    h: f64,
    (tolerance, nominal): (f64, &[f64]),
) -> f64 {
    let mut step = |rk: &mut DormandPrince, h: f64| {
        rk.step(|t, x, dx| field.derivatives(t, x, dx, seen), t, x, h, tolerance, nominal);
        field.indicators(t + h, &rk.end, seen)
    };
    let (mut ahead, mut behind) = (0.0, h);
    let (mut near, mut beyond) = (before.clone(), after);
    for round in 0..MOST_TRIALS {
        if behind - ahead <= SHORTEST * t.abs().max(1.0) {
            break;
        }
        // Every third trial halves, so that the bracket shrinks even where the secant creeps from one side.
        let part = if round % 3 == 2 { 0.5 } else { secant(&near, &beyond) };
        let middle = ahead + (behind - ahead) * part;
        let here = step(rk, middle);
        if crossing(&before, &here) {
            (behind, beyond) = (middle, here);
        } else {
            (ahead, near) = (middle, here);
        }
    }
    step(rk, behind);
    behind
}

/// Whether an indicator has changed between > 0 and ≤ 0.
fn crossing<Z: AsRef<[f64]>>(before: &Z, after: &Z) -> bool {
    before.as_ref().iter().zip(after.as_ref()).any(|(before, after)| (*before > 0.0) != (*after > 0.0))
}

/// Where the first crossing lies between two points, as a part of their distance, by the secant; a little beyond it, so
/// that the next bracket is likely to be a small one.
fn secant<Z: AsRef<[f64]>>(near: &Z, beyond: &Z) -> f64 {
    let mut first = 1.0;
    for (a, b) in near.as_ref().iter().zip(beyond.as_ref()) {
        if (*a > 0.0) != (*b > 0.0) {
            first = (a / (a - b)).min(first);
        }
    }
    (first * (1.0 + 1e-9) + 1e-12).clamp(1e-6, 1.0 - 1e-6)
}
