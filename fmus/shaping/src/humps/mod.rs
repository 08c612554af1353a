//! Shapers with humps: two-hump and three-hump EI and the unity-magnitude ZVD and EI, with damping, solved rather than fitted.
//!
//! Between its n zeros V has n − 1 humps. What each kind means, with or without damping, all at the mode's damping ratio:
//!
//! - TwoHumpEI: positive impulses leave nothing at the design frequency ω₀, at one frequency below and at one above; both
//!   humps between these zeros peak at exactly the vibration limit.
//! - ThreeHumpEI: nothing at two frequencies below ω₀ and at two above; all three humps peak at exactly the limit, the middle
//!   one at ω₀.
//! - UMEI: impulses +1, −1, +1, −1, +1 leave nothing at one frequency below and one above, with a hump that peaks at ω₀, at
//!   exactly the limit. UMZVD is UMEI without vibration: V = 0 and dV/dω = 0 at ω₀.
//!
//! These are as many conditions as there are times, amplitudes, zeros and peaks. Without damping they are those of W. Singhose,
//! L. Porter, T. Tuttle and N. Singer, *Vibration reduction using multi-hump input shapers*, J. Dynamic Systems, Measurement and
//! Control 119, 1997, and W. Singhose, N. Singer and W. Seering, *Time-optimal negative input shapers*, same journal and year.
//!
//! [`System`] has the equations, [`undamped`] the solutions without damping, from which they are followed.

mod system;
mod undamped;

use nalgebra::{SMatrix, SVector};

use crate::continuation::{Pace, confirmed};
use crate::differences::FARTHEST;
use crate::{DesignError, Kind, Mode, Shaper, binomial};
use system::System;

pub(crate) fn two_hump(mode: Mode, limit: f64) -> Result<Shaper, DesignError> {
    if (0.0..=f64::EPSILON).contains(&limit) {
        return Ok(binomial::design::<4>(mode));
    }
    let form = Form { kind: Kind::TwoHumpEI, impulses: 4, unity: false, zeros: 3 };
    form.design::<4>(mode, limit, undamped::two_hump)
}

pub(crate) fn three_hump(mode: Mode, limit: f64) -> Result<Shaper, DesignError> {
    if (0.0..=f64::EPSILON).contains(&limit) {
        return Ok(binomial::design::<5>(mode));
    }
    let form = Form { kind: Kind::ThreeHumpEI, impulses: 5, unity: false, zeros: 4 };
    form.design::<5>(mode, limit, undamped::three_hump)
}

pub(crate) fn unity(kind: Kind, mode: Mode, limit: f64) -> Result<Shaper, DesignError> {
    let form = Form { kind, impulses: 5, unity: true, zeros: 2 };
    form.design::<5>(mode, limit, undamped::unity)
}

/// A train with its zeros dₖ and peaks η.
#[derive(Clone, Copy, Default)]
struct Design {
    phases: [f64; IMPULSES],
    amplitudes: [f64; IMPULSES],
    zeros: [f64; ZEROS],
    peaks: [f64; ZEROS - 1],
}

const IMPULSES: usize = 5;
const ZEROS: usize = 4;
/// Times, amplitudes, zeros and free peaks of ThreeHumpEI, which has most.
const UNKNOWNS: usize = 14;

/// What kind of train is sought.
struct Form {
    kind: Kind,
    impulses: usize,
    /// Whether the amplitudes are +1, −1, … rather than unknown.
    unity: bool,
    zeros: usize,
}

impl Form {
    fn design<const N: usize>(
        &self,
        mode: Mode,
        limit: f64,
        undamped: impl FnOnce(f64) -> Option<Design>,
    ) -> Result<Shaper, DesignError> {
        if !(0.0..1.0).contains(&limit) {
            return Err(DesignError::VibrationLimit { value: limit });
        }
        let zeta = mode.damping_ratio();
        let none = |damping_ratio| DesignError::NoSolution {
            kind: self.kind,
            damping_ratio: zeta,
            vibration_limit: (self.kind != Kind::UMZVD).then_some(limit),
            nearest_damping_ratio: damping_ratio,
        };
        let start = undamped(limit).ok_or(none(None))?;
        let solve = |zeta| self.follow(start, zeta, |zeta| (zeta, limit));
        let design = solve(zeta).map_err(|nearest| none(Some(confirmed(nearest, solve))))?;
        let per_radian = 1.0 / mode.damped_frequency();
        Ok(Shaper::of::<N>(std::array::from_fn(|i| (design.phases[i] * per_radian, design.amplitudes[i]))))
    }

    /// Follows a solution at 0 to one at `end`; `at` gives damping ratio and limit. Where it ends before, the last place that has
    /// one.
    fn follow(&self, start: Design, end: f64, at: impl Fn(f64) -> (f64, f64)) -> Result<Design, f64> {
        let pace = Pace { first: end.min(0.1), growth: 1.5, shrinkage: 0.5, finest: 2e-4, most: 100 };
        let guess = |place| self.pack(&self.damped(start, at(place).0));
        let solve = |guess: &SVector<f64, UNKNOWNS>, place| {
            let (zeta, limit) = at(place);
            self.newton(guess, zeta, limit)
        };
        pace.follow(end, guess, solve).map(|unknowns| self.unpack(&unknowns))
    }

    /// A guess: damping takes e^{−rx} from what an impulse leaves.
    fn damped(&self, mut design: Design, zeta: f64) -> Design {
        if !self.unity {
            let r = decay(zeta);
            (0..self.impulses).for_each(|i| design.amplitudes[i] *= (-r * design.phases[i]).exp());
            let sum: f64 = design.amplitudes.iter().sum();
            design.amplitudes.iter_mut().for_each(|amplitude| *amplitude /= sum);
        }
        design
    }

    /// How many zeros and peaks are free: the middle one of all lies at the design frequency.
    fn free(&self) -> (usize, usize) {
        let odd = self.zeros % 2;
        (self.zeros - odd, self.zeros - 2 + odd)
    }

    fn pack(&self, design: &Design) -> SVector<f64, UNKNOWNS> {
        let mut unknowns = SVector::<f64, UNKNOWNS>::zeros();
        let later = 1..self.impulses;
        let amplitudes = if self.unity { &[] } else { &design.amplitudes[later.clone()] };
        let aside = |index: &usize, count: usize| 2 * index + 1 != count;
        let zeros = (0..self.zeros).filter(|k| aside(k, self.zeros)).map(|k| design.zeros[k]);
        let humps = self.zeros - 1;
        let peaks = (0..humps).filter(|k| aside(k, humps)).map(|k| design.peaks[k]);
        let all = design.phases[later].iter().chain(amplitudes).copied().chain(zeros).chain(peaks);
        unknowns.iter_mut().zip(all).for_each(|(unknown, value)| *unknown = value);
        unknowns
    }

    fn unpack(&self, unknowns: &SVector<f64, UNKNOWNS>) -> Design {
        let mut rest = unknowns.iter().copied();
        let mut next = || rest.next().unwrap_or(0.0);
        let mut design = Design { amplitudes: [1.0, -1.0, 1.0, -1.0, 1.0], ..Design::default() };
        design.phases[1..self.impulses].fill_with(&mut next);
        if !self.unity {
            design.amplitudes = [0.0; IMPULSES];
            design.amplitudes[1..self.impulses].fill_with(&mut next);
            design.amplitudes[0] = 1.0 - design.amplitudes.iter().sum::<f64>();
        }
        let humps = self.zeros - 1;
        for k in (0..self.zeros).filter(|k| 2 * k + 1 != self.zeros) {
            design.zeros[k] = next();
        }
        for k in (0..humps).filter(|k| 2 * k + 1 != humps) {
            design.peaks[k] = next();
        }
        design
    }

    /// Newton's method with slopes from differences; `None` unless it ends at a shaper of this form.
    fn newton(&self, start: &SVector<f64, UNKNOWNS>, zeta: f64, limit: f64) -> Option<SVector<f64, UNKNOWNS>> {
        let system = System { form: self, r: decay(zeta), spread: limit.powf(1.0 / self.zeros as f64) };
        let mut unknowns = *start;
        let mut moved_by = f64::INFINITY;
        for _ in 0..MAX_ITERATIONS {
            let residual = system.at(&unknowns);
            let mut jacobian = SMatrix::<f64, UNKNOWNS, UNKNOWNS>::identity();
            for unknown in 0..system.size() {
                let mut moved = unknowns;
                moved[unknown] += DIFFERENCE;
                jacobian.set_column(unknown, &((system.at(&moved) - residual) / DIFFERENCE));
            }
            let step = jacobian.lu().solve(&residual)?;
            unknowns -= step;
            if !unknowns.iter().all(|value| value.abs() < 50.0) {
                return None;
            }
            let last = std::mem::replace(&mut moved_by, step.amax());
            if moved_by.max(last) <= LAST_STEP && system.at(&unknowns).amax() <= TOLERANCE {
                return self.holds(&self.unpack(&unknowns), &system).then_some(unknowns);
            }
        }
        None
    }

    /// Whether impulses and zeros are in order, the peaks between the zeros, these not too far, and free amplitudes positive.
    fn holds(&self, design: &Design, system: &System<'_>) -> bool {
        let (zeros, peaks) = (&design.zeros[..self.zeros], &design.peaks[..self.zeros - 1]);
        let end = design.phases[self.impulses - 1];
        design.phases[..self.impulses].is_sorted_by(|a, b| a + RESOLVED < *b)
            && (self.unity || design.amplitudes[..self.impulses].iter().all(|amplitude| *amplitude > 0.0))
            && 1.0 + system.spread * zeros[0] > 0.0
            && 0.5 * end * system.r.hypot(1.0) * system.spread * zeros[self.zeros - 1] <= FARTHEST
            && zeros.windows(2).zip(peaks).all(|(pair, peak)| pair[0] < *peak && *peak < pair[1])
    }
}

/// r = ζ/√(1 − ζ²)
fn decay(zeta: f64) -> f64 {
    zeta / crate::mode::damped_share(zeta)
}

/// Newton's method takes five to nine from where a good step of the continuation puts it.
const MAX_ITERATIONS: usize = 12;

/// What is left after two steps this small is rounding.
const LAST_STEP: f64 = 1e-9;

/// Largest residual accepted. Rounding of a fifth difference leaves up to about 1e-12.
const TOLERANCE: f64 = 1e-10;

/// Impulses closer than this, in radians, are not told apart.
const RESOLVED: f64 = 1e-9;

/// Slopes from differences this wide are good to about as much, and each iteration leaves that share of the error.
const DIFFERENCE: f64 = 1e-7;
