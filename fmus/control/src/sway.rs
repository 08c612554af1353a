//! Damping by plain feedback of the swing (thesis fig. 3.5).

use serde::{Deserialize, Serialize};

use crate::crane::BOUND;
use crate::pace::Pace;

/// How swing is damped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damping {
    /// k (m/s per rad).
    pub gain: f64,
    /// How far ahead of the swing the feedback is (s).
    pub lead_time: f64,
    /// Time constant of the filter behind the swing's difference quotient (s).
    pub filter_time: f64,
    /// Greatest correction (m/s).
    pub correction_limit: f64,
    /// Time in which feedback fades out and in (s).
    pub fade_time: f64,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
struct Now {
    swing: [f64; 2],
    rate: [f64; 2],
    trust: f64,
    seen: bool,
}

/// Feedback of a swing angle in two horizontal directions: k (θ + lead θ̇), with θ̇ from differences.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
#[serde(try_from = "Parts")]
pub struct SwayDamping {
    now: Now,
    /// As it was before the last sample: a second one at the same time takes the place of the first.
    before: Now,
    pace: Pace,
}

/// What damping is serialized as.
#[derive(Deserialize)]
struct Parts {
    now: Now,
    before: Now,
    pace: Pace,
}

impl TryFrom<Parts> for SwayDamping {
    type Error = &'static str;

    fn try_from(Parts { now, before, pace }: Parts) -> Result<Self, Self::Error> {
        let possible = |now: &Now| {
            let numbers = now.swing.iter().chain(&now.rate);
            numbers.copied().all(|number| number.abs() <= BOUND) && (0.0..=1.0).contains(&now.trust)
        };
        if !(possible(&now) && possible(&before)) {
            return Err("a swing is what none can be");
        }
        if !pace.is_possible() {
            return Err("the time of the last sample is not finite");
        }
        Ok(Self { now, before, pace })
    }
}

impl SwayDamping {
    /// Takes a sample of the swing (rad, in directions that do not turn) at `time` (s), as it is done every `period` (s; 0 for
    /// whenever it suits); nothing if it is not seen. Returns the correction to the command (m/s).
    pub fn step(&mut self, time: f64, period: f64, damping: &Damping, swing: Option<[f64; 2]>) -> [f64; 2] {
        if self.pace.tick(time, period) {
            self.now = self.before;
        } else {
            self.before = self.now;
        }
        let (interval, now) = (self.pace.interval(), &mut self.now);
        if let Some(swing) = swing {
            if now.seen && interval > 0.0 {
                let share = interval / (interval + damping.filter_time);
                for (rate, (new, old)) in now.rate.iter_mut().zip(swing.iter().zip(now.swing)) {
                    let quotient = (new - old) / interval;
                    *rate = (*rate + share * (quotient - *rate)).clamp(-BOUND, BOUND);
                }
            }
            now.swing = swing;
        } else {
            now.rate = [0.0; 2];
        }
        now.seen = swing.is_some();
        let step = if damping.fade_time > 0.0 { interval / damping.fade_time } else { 1.0 };
        now.trust = (now.trust + if now.seen { step } else { -step }).clamp(0.0, 1.0);
        let correction: [f64; 2] = std::array::from_fn(|axis| {
            now.trust * damping.gain * (now.swing[axis] + damping.lead_time * now.rate[axis])
        });
        let size = correction[0].hypot(correction[1]);
        let within = if size > damping.correction_limit { damping.correction_limit / size } else { 1.0 };
        correction.map(|part| part * within)
    }
}
