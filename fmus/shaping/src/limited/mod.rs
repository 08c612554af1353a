//! Shapers for a drive with an acceleration limit (thesis 5.1.3): ALZVD, ALEI and, in a room of its own, ALSI.
//!
//! A drive that cannot jump turns each impulse of a shaped step into a ramp, and with it most of what the usual shapers are good
//! for is lost: at ωv_f/a = 5.25, ZVD leaves more than the bare step. These shapers are designed for the ramps: the command that
//! comes out of the drive is a train of pulses of its full acceleration, with one impulse for the start of each.

mod error;
mod pulses;
mod range;

pub use error::LimitedError;
pub use range::limited_insensitivity;

use std::f64::consts::PI;

use nalgebra::SVector;

use crate::continuation::{Pace, confirmed};
use crate::{Mode, Shaper, binomial, ei};
use pulses::{Pulses, Unknowns};

/// A step of the commanded velocity and the acceleration that the drive answers it with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    speed: f64,
    acceleration: f64,
}

impl Ramp {
    /// A velocity step in m/s (of either sign) at an acceleration limit in m/s²; an infinite limit is none.
    ///
    /// # Errors
    /// [`LimitedError`] for a step that is not finite or an acceleration that is not greater than 0.
    pub fn new(speed: f64, acceleration: f64) -> Result<Self, LimitedError> {
        if acceleration.is_nan() || acceleration <= 0.0 {
            return Err(LimitedError::Acceleration { value: acceleration });
        }
        let time = speed.abs() / acceleration;
        if !(speed.is_finite() && time.is_finite()) {
            return Err(LimitedError::Speed { value: speed, acceleration });
        }
        Ok(Self { speed: speed.abs(), acceleration })
    }

    /// How long the drive takes for the bare step, v_f/a in seconds.
    #[must_use]
    pub fn time(self) -> f64 {
        self.speed / self.acceleration
    }

    /// The size of the step, m/s.
    #[must_use]
    pub fn speed(self) -> f64 {
        self.speed
    }

    /// The acceleration limit, m/s².
    #[must_use]
    pub fn acceleration(self) -> f64 {
        self.acceleration
    }
}

/// A shaper and the command that the drive makes of a step shaped by it: pulses of the full acceleration.
#[derive(Clone, Debug, PartialEq)]
pub struct Limited {
    shaper: Shaper,
    ramp_time: f64,
}

impl Limited {
    /// The shaper. Its impulse Aᵢ at tᵢ keeps the drive accelerating for Aᵢv_f/a (5.20).
    #[must_use]
    pub fn shaper(&self) -> &Shaper {
        &self.shaper
    }

    /// When the acceleration is switched on and off, in seconds after the step: start and end of each pulse, in order.
    pub fn switch_times(&self) -> impl ExactSizeIterator<Item = [f64; 2]> {
        let ramp = self.ramp_time;
        self.shaper.impulses().iter().map(move |pulse| [pulse.time, pulse.time + pulse.amplitude * ramp])
    }

    /// When the command is complete, in seconds after the step.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.switch_times().last().map_or(0.0, |[_, end]| end)
    }
}

/// Designs ALZVD (`vibration_limit` = 0) or ALEI: three pulses of the full acceleration that leave, at the mode, no more vibration
/// than `vibration_limit` times what the bare ramp leaves, and no slope of that over frequency. Does not allocate.
///
/// ALZVD's command is the shortest of all between 0 and the acceleration limit that leaves no vibration and no slope; without
/// damping up to ωv_f/a = 4π, beyond which it is up to 0.4 % longer than that. As v_f → 0 it tends to ZVD and, without damping, ALEI to EI. With
/// damping ALEI's vibration peaks at the mode's frequency at exactly the limit, where [`Kind::EI`](crate::Kind::EI) peaks beside it.
///
/// With P(w) what the pulses answer at w times the mode's frequency and B(w) the bare ramp's answer, the conditions are that
///
/// P(w) + V e^{(rδ + jδ′)w} B(w), δ = t_e − t_b, δ′ = δ/2 (phases; t_e where the pulses end, t_b the bare ramp),
///
/// has a double zero at w = 1. So the ratio of both, each counted from its own end, has the size V and no slope, and ALEI's
/// (R/R_u = −V, (R/R_u)′ = 0 without damping) stay regular where the bare ramp leaves nothing, ωv_f/a = 2π.
///
/// # Errors
/// [`LimitedError`] for a vibration limit that is none, for a bare ramp of more than three periods, and where damping is so large
/// that pulses touch or no solution is found. For V ≤ 0.2 solutions exist for all bare ramps up to one damped period if ζ ≤ 0.2, and
/// up to two periods if ζ ≤ 0.15.
pub fn limited(mode: Mode, ramp: Ramp, vibration_limit: f64) -> Result<Limited, LimitedError> {
    if !(0.0..1.0).contains(&vibration_limit) {
        return Err(LimitedError::VibrationLimit { value: vibration_limit });
    }
    let half = 0.5 * ramp.time() * mode.damped_frequency();
    let feasible = |share: f64| {
        confirmed(share, |share| match share > 0.0 {
            true => pulses(mode, half * share, vibration_limit).map(drop).map_err(|end| share * end.ramp()),
            false => Ok(()),
        })
    };
    if half > LONGEST {
        return Err(LimitedError::TooSlow { ramp, feasible_share: feasible(0.999_999 * LONGEST / half) });
    }
    let ramp_time = ramp.time();
    let unlimited = |shaper| Limited { shaper, ramp_time };
    if half == 0.0 && vibration_limit == 0.0 {
        return Ok(unlimited(binomial::design::<3>(mode)));
    }
    if half == 0.0 && mode.damping_ratio() == 0.0 {
        // the limit is one of EI's
        return ei::design(mode, vibration_limit)
            .map(unlimited)
            .map_err(|_| LimitedError::VibrationLimit { value: vibration_limit });
    }
    let solution = pulses(mode, half, vibration_limit).map_err(|end| match end {
        End::Limit(share) => LimitedError::Damping {
            damping_ratio: mode.damping_ratio(),
            vibration_limit,
            feasible_limit: vibration_limit * share,
        },
        End::Ramp(share) => {
            LimitedError::NoPulses { ramp, damping_ratio: mode.damping_ratio(), feasible_share: feasible(share) }
        }
    })?;
    let [starts, amplitudes] = solution.train(half, mode.damping_ratio() == 0.0);
    let per_radian = 1.0 / mode.damped_frequency();
    Ok(unlimited(Shaper::of::<3>(std::array::from_fn(|pulse| (starts[pulse] * per_radian, amplitudes[pulse])))))
}

/// Where solutions end.
enum End {
    /// At this share of the limit, even without a ramp.
    Limit(f64),
    /// At this share of the ramp.
    Ramp(f64),
}

impl End {
    fn ramp(self) -> f64 {
        match self {
            Self::Limit(_) => 0.0,
            Self::Ramp(share) => share,
        }
    }
}

fn pulses(mode: Mode, half: f64, vibration_limit: f64) -> Result<Unknowns, End> {
    follow(mode, |share| (half * share, vibration_limit * share)).or_else(|_| {
        // one after the other, to find out which is to blame
        follow(mode, |share| (0.0, vibration_limit * share)).map_err(End::Limit)?;
        let ramp = |share: f64| (2.0 * share - 1.0).max(0.0);
        follow(mode, |share| (half * ramp(share), vibration_limit * (2.0 * share).min(1.0)))
            .map_err(|share| End::Ramp(ramp(share)))
    })
}

/// Half the longest bare ramp, in radians: three periods.
const LONGEST: f64 = 3.0 * PI;

/// Follows the solution from ZVD along a path of half ramps and vibration limits, in steps as large as Newton's method takes
/// without leaving the branch. Where it ends, the last share of the path that has one.
fn follow(mode: Mode, path: impl Fn(f64) -> (f64, f64)) -> Result<Unknowns, f64> {
    let r = mode.decay_angle();
    let [first, _, third] = binomial::amplitudes::<3>(mode);
    let start = SVector::from([first, third, PI, 2.0 * PI]);
    let first = (LONGEST_STEP / path(1.0).0).min(1.0);
    let pace = Pace { first, growth: 1.0, shrinkage: 0.5, finest: 1e-4, most: 200 };
    let solve = |guess: &SVector<f64, 4>, share| {
        let (half, limit) = path(share);
        let found = Pulses::new(r, half, limit).newton(*guess)?.0;
        ((found - guess).amax() < NEAR).then_some(found)
    };
    pace.follow(1.0, |_| start, solve).map(Unknowns)
}

/// Half the bare ramp grows by so much a step, in radians.
const LONGEST_STEP: f64 = 0.8;

/// Farther from the guess, in radians, it might be another branch.
const NEAR: f64 = 0.5;
