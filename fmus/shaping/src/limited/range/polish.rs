//! From a command that is nearly the shortest to the shortest, to rounding: Newton's method on the conditions for an optimum.
//!
//! With n = |B|² + ε², Q = |F|²/n and weights νₘ, Σνₘ = 1, the command that switches at places sₖ, the last of which is the length
//! that is sought, fulfils
//!
//! - g(sₖ) = Σₘ νₘ Re(F̄(ωₘ) e(ωₘ, sₖ))/n(ωₘ) − λ = 0 at every switch but the last;
//! - Q = V² at every frequency in use, with zero slope over ω at those inside the range (the equioscillation);
//! - the on-time is what it should be.
//!
//! Those are as many equations as there are sₖ, νₘ, inner ωₘ and λ.

use nalgebra::{Complex, DMatrix, DVector};

use super::exchange::{Cut, Mix, humps, price};
use super::problem::{Command, Problem};
use super::start::without_slivers;
use crate::order::order_by;
use crate::specified::{minima, samples};

/// A frequency in use.
struct Wave {
    omega: f64,
    weight: f64,
    /// Whether ω is an unknown.
    free: bool,
}

/// The switches of a command, ascending; the command is on from a place before the first one if `on_at_zero`.
struct Switches {
    places: Vec<f64>,
    on_at_zero: bool,
}

impl Switches {
    fn of(command: &Command) -> Self {
        let on_at_zero = command.first().is_some_and(|[from, _]| *from == 0.0);
        let places = command.iter().flatten().copied().skip(usize::from(on_at_zero)).collect();
        Self { places, on_at_zero }
    }

    /// 1 where the command is switched off, −1 where on; the last switch is one off.
    fn sign(&self, index: usize) -> f64 {
        if (self.places.len() - 1 - index).is_multiple_of(2) { 1.0 } else { -1.0 }
    }

    fn command(&self) -> Command {
        let all: Vec<f64> = self.on_at_zero.then_some(0.0).into_iter().chain(self.places.iter().copied()).collect();
        all.chunks_exact(2).map(|pulse| [pulse[0], pulse[1]]).collect()
    }
}

/// The optimum near a mix. `None` if Newton's method does not lead to one that passes the check from both sides.
pub(super) fn polish(problem: &Problem, mix: &Mix, longest: f64) -> Option<Command> {
    let starts = [Some(mix.rounded()), Some(mix.reply.clone()), mix.gathered(problem, longest)];
    starts.iter().flatten().find_map(|command| polish_from(problem, mix, command, longest))
}

fn polish_from(problem: &Problem, mix: &Mix, command: &Command, longest: f64) -> Option<Command> {
    if command.last()?[1] < longest {
        return None;
    }
    let mut switches = Switches::of(&without_slivers(command, problem.on_time));
    let mut waves = gather(problem, mix);
    let inner = &switches.places[..switches.places.len() - 1];
    let mut threshold =
        inner.iter().map(|place| price(problem, &mix.weights, *place)[0]).sum::<f64>() / inner.len().max(1) as f64;
    // the game's weights are for directions of size 1: ν = y level/|F|, to a common factor
    let total: f64 = waves.iter().map(|wave| wave.weight).sum();
    waves.iter_mut().for_each(|wave| wave.weight /= total);
    threshold *= problem.limit / total;
    newton(problem, &mut switches, &mut waves, threshold)?;
    checked(problem, &switches, &waves)
}

/// Cuts of the same hump together, the ends of the range by themselves. Humps of opposite sides are next to each other where the
/// bare ramp leaves nothing.
fn gather(problem: &Problem, mix: &Mix) -> Vec<Wave> {
    let mut cuts: Vec<&(Cut, f64)> = mix.weights.iter().filter(|(_, weight)| *weight > LEAST_WEIGHT).collect();
    order_by(&mut cuts, |(cut, _)| cut.omega);
    let mut waves: Vec<Wave> = Vec::new();
    // the two ends of a range may be next to each other
    let same = |free| if free { SAME } else { 0.5 * (problem.high - problem.low) };
    let mut last_direction = Complex::ONE;
    for (Cut { omega, direction, .. }, weight) in cuts.into_iter().copied() {
        let free = problem.low < omega && omega < problem.high;
        let agrees = (direction.conj() * std::mem::replace(&mut last_direction, direction)).re > 0.5;
        match waves.last_mut() {
            Some(last) if last.free == free && agrees && omega - last.omega <= same(free) => {
                let total = last.weight + weight;
                last.omega = (last.omega * last.weight + omega * weight) / total;
                last.weight = total;
            }
            _ => waves.push(Wave { omega, weight, free }),
        }
    }
    waves
}

fn newton(problem: &Problem, switches: &mut Switches, waves: &mut [Wave], threshold: f64) -> Option<()> {
    let (mut threshold, mut last) = (threshold, f64::INFINITY);
    for _ in 0..MAX_ITERATIONS {
        let (mut residual, mut jacobian) = system(problem, switches, waves, threshold);
        divide(switches, &mut residual, &mut jacobian);
        let size = residual.amax();
        let rounding = ROUNDING * switches.places.last()? / problem.on_time;
        if size <= (TOLERANCE * problem.limit * problem.limit).max(rounding) && size >= 0.5 * last {
            return Some(()); // rounding is all that is left
        }
        last = size;
        let mut step = jacobian.lu().solve(&residual)?;
        let length = step.amax();
        if !length.is_finite() {
            return None;
        }
        step *= (LONGEST_STEP / length).min(1.0);
        let mut steps = step.iter();
        for place in &mut switches.places {
            *place -= steps.next()?;
        }
        for wave in waves.iter_mut() {
            wave.weight -= steps.next()?;
        }
        threshold -= steps.next()?;
        for wave in waves.iter_mut().filter(|wave| wave.free) {
            wave.omega -= steps.next()?;
            if !(0.5 * problem.low < wave.omega && wave.omega < 2.0 * problem.high) {
                return None;
            }
        }
        if !(switches.places.is_sorted_by(|a, b| a < b) && switches.places[0] > 0.0) {
            return None;
        }
    }
    None
}

/// Residuals, and their derivatives with respect to s, ν, λ and free ω in that order. Rows: g at all switches but the last, Σν,
/// Q at all frequencies, the on-time, slopes of Q at free frequencies.
fn system(problem: &Problem, switches: &Switches, waves: &[Wave], threshold: f64) -> (DVector<f64>, DMatrix<f64>) {
    let (places, frequencies) = (switches.places.len(), waves.len());
    let lambda = places + frequencies;
    let free = waves.iter().filter(|wave| wave.free).count();
    let size = lambda + 1 + free;
    let mut residual = DVector::zeros(size);
    let mut jacobian = DMatrix::zeros(size, size);
    let (last, on_time_row) = (places - 1, lambda);

    residual[last] = waves.iter().map(|wave| wave.weight).sum::<f64>() - 1.0;
    for k in 0..last {
        residual[k] = -threshold;
        jacobian[(k, lambda)] = -1.0;
    }
    let on: f64 = switches.places.iter().enumerate().map(|(k, place)| switches.sign(k) * place).sum();
    residual[on_time_row] = on / problem.on_time - 1.0;
    for k in 0..places {
        jacobian[(on_time_row, k)] = switches.sign(k) / problem.on_time;
    }

    let mut next_free = lambda + 1;
    for (m, wave) in waves.iter().enumerate() {
        let omega = wave.omega;
        let column = wave.free.then_some(next_free);
        next_free += usize::from(wave.free);
        let e: Vec<_> = switches.places.iter().map(|place| problem.response.derivatives(omega, *place)).collect();
        // F and its derivatives over ω; each switch contributes the integral up to it
        let f = switches.places.iter().enumerate().fold([Complex::ZERO; 3], |sum, (k, place)| {
            let own = problem.integral(omega, *place);
            std::array::from_fn(|i| sum[i] + own[i] * switches.sign(k))
        });
        let [level, level_slope, _] = problem.level(omega);
        let [ratio, ratio_slope, ratio_curvature] = problem.ratio(f, omega);
        let (c, c_slope) = (f[0].conj(), f[1].conj());
        // dF/ds and d²F/dωds
        let by_place = |k: usize| e[k].value * (switches.sign(k) / problem.on_time);
        let slope_by_place = |k: usize| e[k].by_omega * (switches.sign(k) / problem.on_time);
        let share = wave.weight / level;

        jacobian[(last, places + m)] = 1.0;
        for k in 0..last {
            let own = (c * e[k].value).re;
            residual[k] += share * own;
            for j in 0..places {
                jacobian[(k, j)] += share * (by_place(j).conj() * e[k].value).re;
            }
            jacobian[(k, k)] += share * (c * e[k].by_tau).re;
            jacobian[(k, places + m)] += own / level;
            if let Some(column) = column {
                let rise = (c_slope * e[k].value + c * e[k].by_omega).re;
                jacobian[(k, column)] += share * (rise - own * level_slope / level);
            }
        }

        let row = places + m;
        residual[row] = 0.5 * (ratio - problem.limit * problem.limit);
        for j in 0..places {
            let by = (c * by_place(j)).re / level; // ½ dQ/ds
            jacobian[(row, j)] = by;
            if let Some(slope_row) = column {
                let rise = (by_place(j).conj() * f[1] + c * slope_by_place(j)).re;
                jacobian[(slope_row, j)] = (rise - by * level_slope) / level;
            }
        }
        if let Some(column) = column {
            jacobian[(row, column)] = 0.5 * ratio_slope;
            residual[column] = 0.5 * ratio_slope;
            jacobian[(column, column)] = 0.5 * ratio_curvature;
        }
    }
    // the row of Q of frequency m is places + m, which leaves λ's for the on-time
    (residual, jacobian)
}

/// Where two switches come close, their conditions all but say the same. So the later one's is made g[sₖ, sₖ₊₁] = 0, the divided
/// difference of both, which stays regular and does not tie the next step to the pulse's or the gap's length.
fn divide(switches: &Switches, residual: &mut DVector<f64>, jacobian: &mut DMatrix<f64>) {
    let first = usize::from(switches.on_at_zero);
    for earlier in (first..switches.places.len().saturating_sub(2)).step_by(2) {
        let later = earlier + 1;
        let length = switches.places[later] - switches.places[earlier];
        residual[later] = (residual[later] - residual[earlier]) / length;
        for column in 0..jacobian.ncols() {
            jacobian[(later, column)] = (jacobian[(later, column)] - jacobian[(earlier, column)]) / length;
        }
        jacobian[(later, later)] -= residual[later] / length;
        jacobian[(later, earlier)] += residual[later] / length;
    }
}

/// The proof, whatever way the command was found: it keeps the limit everywhere in the range, and the weights' price is below
/// the threshold exactly where it is on, its end included, so that no command of that length or shorter keeps less.
fn checked(problem: &Problem, switches: &Switches, waves: &[Wave]) -> Option<Command> {
    let command = switches.command();
    let longest = *switches.places.last()?;
    let inside = waves.iter().all(|wave| problem.low <= wave.omega && wave.omega <= problem.high && wave.weight > 0.0);
    if !inside {
        return None;
    }
    let highest = humps(problem, longest, |omega| problem.answer(&command, omega));
    if highest.iter().any(|(_, size)| *size > problem.limit * (1.0 + MARGIN)) {
        return None;
    }
    let weights: Vec<(Cut, f64)> = waves
        .iter()
        .map(|wave| {
            let [f, ..] = problem.answer(&command, wave.omega);
            let level = problem.level(wave.omega)[0].sqrt();
            (Cut { omega: wave.omega, direction: f / f.norm(), level }, wave.weight * f.norm() / level)
        })
        .collect();
    let at = |tau: f64| price(problem, &weights, tau);
    // one switch tells the threshold; without any but the last the command is the bare ramp, and that is the shortest of all
    let threshold = at(switches.places[0])[0];
    if switches.places.len() == 1 {
        return Some(command);
    }
    let margin = MARGIN * weights.iter().map(|(cut, weight)| weight / cut.level).sum::<f64>();
    let bounds = std::iter::once(0.0).chain(switches.places.iter().copied()).collect::<Vec<_>>();
    let first_on = switches.places.len() % 2 == 1;
    let proved = bounds.windows(2).enumerate().all(|(index, stretch)| {
        let side = if first_on == index.is_multiple_of(2) { -1.0 } else { 1.0 };
        let points = samples(problem.high * (stretch[1] - stretch[0]));
        let lowest = minima(stretch[0]..=stretch[1], points, |tau| {
            let [value, slope, curvature] = at(tau);
            [side * (value - threshold), side * slope, side * curvature]
        });
        lowest.iter().all(|(_, [value, ..])| *value >= -margin)
    });
    (proved && at(longest)[0] < threshold).then_some(command)
}

/// Weights below this are left-overs, too.
const LEAST_WEIGHT: f64 = 1e-9;

/// Cuts closer than this belong to one hump.
const SAME: f64 = 0.03;

/// From afar steps are cut to this.
const LONGEST_STEP: f64 = 0.2;

/// Newton converges in about five iterations once it is near.
const MAX_ITERATIONS: usize = 40;

/// Largest residual accepted, relative to V².
const TOLERANCE: f64 = 1e-9;

/// Roundings of the last place, relative, that the residual of the on-time may be.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// By how much, relative to the limit, rounding may keep the two sides apart.
const MARGIN: f64 = 1e-9;
