//! The least vibration that trains of a given length can be held to, found by exchange.
//!
//! Over the places τ of impulses xₖ ≥ 0, Σxₖ = 1, and the frequencies ω of the ranges, the least highest vibration is
//!
//! v = min over x of max over ω |Σ xₖ e(ω, τₖ)| = min over x of max over (ω, φ) Re e^{−jφ} Σ xₖ e(ω, τₖ).
//!
//! That is a game: one side mixes places, the other mixes cuts (ω, φ), both from a compact set, and the payoff is smooth, so
//! the game has a value. It is solved with finitely many places and cuts, each side's best answers to the other's mix are added,
//! and so on (the double-oracle method; for the cuts alone it is Remez' exchange). In every round the other side's mix
//! bounds the value of the whole game from either side: `min over τ of p(τ) ≤ v ≤ max over ω of |f(ω)|`, whatever the points.

use crate::order::order_by;
use nalgebra::{Complex, DMatrix};

use super::SpecifiedError;
use super::extrema::{Jet, minima};
use super::game;
use super::polish::MARGIN;
use super::response::Response;

/// Frequencies that one damping ratio goes with.
#[derive(Clone, Copy)]
pub(super) struct Range {
    pub response: Response,
    pub low: f64,
    pub high: f64,
}

/// A tangent to the cone |f(ω)| ≤ v of a range: Re(e^{−jφ} f(ω)) ≤ v.
#[derive(Clone, Copy)]
pub(super) struct Cut {
    /// The range's number.
    pub range: usize,
    pub response: Response,
    pub omega: f64,
    /// e^{jφ}
    pub direction: Complex<f64>,
}

/// Both sides' mixes.
#[derive(Clone, Default)]
pub(super) struct Mix {
    /// Places and shares x of the impulses.
    pub train: Vec<(f64, f64)>,
    /// Cuts and their weights y.
    pub weights: Vec<(Cut, f64)>,
}

impl Mix {
    /// The train with its places in order, each once.
    pub fn ordered_train(&self) -> Vec<(f64, f64)> {
        let mut train = self.train.clone();
        order_by(&mut train, |(place, _)| *place);
        train.dedup_by(|later, earlier| {
            let same = later.0 == earlier.0;
            earlier.1 += if same { later.1 } else { 0.0 };
            same
        });
        train
    }

    /// p(τ) = Σ y Re(e^{−jφ} e(ω, τ)) with its slope and curvature.
    pub fn price(&self, tau: f64) -> Jet {
        self.weights.iter().fold([0.0; 3], |[value, slope, curvature], (cut, weight)| {
            let e = cut.response.derivatives(cut.omega, tau);
            let part = |e: Complex<f64>| (cut.direction.conj() * e).re * weight;
            [value + part(e.value), slope + part(e.by_tau), curvature + part(e.by_tau_tau)]
        })
    }

    /// f(ω) with its first two derivatives.
    pub fn answer(&self, response: Response, omega: f64) -> [Complex<f64>; 3] {
        self.train.iter().fold([Complex::ZERO; 3], |[value, slope, curvature], (tau, share)| {
            let e = response.derivatives(omega, *tau);
            [value + e.value * *share, slope + e.by_omega * *share, curvature + e.by_omega_omega * *share]
        })
    }
}

/// A local maximum of |f(ω)| in a range, its ends included.
pub(super) struct Hump {
    /// The range's number.
    pub range: usize,
    pub omega: f64,
    /// |f(ω)|
    pub size: f64,
}

/// The ranges and what has been exchanged so far.
pub(super) struct Exchange {
    /// At least one; with either all or none of the responses symmetric.
    pub ranges: Vec<Range>,
    cuts: Vec<Cut>,
    places: Vec<f64>,
}

/// What the game says about a length of train.
pub(super) enum Verdict {
    /// No train of this length holds the limit: v is above it.
    TooShort(Mix),
    /// The mix's train holds it.
    LongEnough(Mix),
    /// Rounding hides the answer.
    Close(Mix),
}

impl Exchange {
    pub fn new(ranges: Vec<Range>) -> Self {
        Self { ranges, cuts: Vec::new(), places: Vec::new() }
    }

    /// Minima of p over all places: the best answers to the weights.
    pub fn prices(&self, mix: &Mix, longest: f64) -> Vec<(f64, Jet)> {
        let highest = self.ranges.iter().map(|range| range.high).fold(0.0, f64::max);
        minima(0.0..=longest, samples(highest * longest), |tau| mix.price(tau))
    }

    /// Maxima of |f| over all frequencies, as minima of −|f|²/2: the best answers to the train.
    pub fn humps(&self, mix: &Mix, longest: f64) -> Vec<Hump> {
        let of_range = |(number, range): (usize, &Range)| {
            let Range { response, low, high } = *range;
            let found = minima(low..=high, samples((high - low) * longest), |omega| {
                let [f, slope, curvature] = mix.answer(response, omega);
                let bend = slope.norm_sqr() + (f.conj() * curvature).re;
                [-0.5 * f.norm_sqr(), -(f.conj() * slope).re, -bend]
            });
            let hump = move |(omega, [half, ..]): (f64, Jet)| Hump { range: number, omega, size: (-2.0 * half).sqrt() };
            found.into_iter().map(hump)
        };
        self.ranges.iter().enumerate().flat_map(of_range).collect()
    }

    /// Whether a train with places up to `longest` can keep V at the limit. The points that the answer uses are kept for the
    /// next question.
    ///
    /// # Errors
    /// [`SpecifiedError::NotFound`] if rounding broke the game itself, [`SpecifiedError::TooWide`] if it grew too large.
    pub fn judge(&mut self, longest: f64, limit: f64) -> Result<Verdict, SpecifiedError> {
        let verdict = self.play_rounds(longest, limit)?;
        let (Verdict::TooShort(mix) | Verdict::LongEnough(mix) | Verdict::Close(mix)) = &verdict;
        self.places = mix.train.iter().map(|(place, _)| *place).collect();
        self.cuts = mix.weights.iter().map(|(cut, _)| *cut).collect();
        Ok(verdict)
    }

    fn play_rounds(&mut self, longest: f64, limit: f64) -> Result<Verdict, SpecifiedError> {
        self.places.retain(|place| *place < longest);
        self.places.push(longest);
        let (mut gap, mut idle) = (f64::INFINITY, 0);
        if self.cuts.is_empty() {
            self.places.push(0.0);
            for (number, &Range { response, low, high }) in self.ranges.iter().enumerate() {
                let cut = |omega| Cut { range: number, response, omega, direction: Complex::ONE };
                self.cuts.extend([low, high].map(cut));
            }
        }
        for _ in 0..MAX_ROUNDS {
            if self.cuts.len() + self.places.len() > MAX_POINTS {
                return Err(SpecifiedError::TooWide);
            }
            let mix = self.play().ok_or(SpecifiedError::NotFound)?;
            let prices = self.prices(&mix, longest);
            let humps = self.humps(&mix, longest);
            let lower = prices.iter().map(|(_, [price, ..])| *price).fold(f64::INFINITY, f64::min);
            let upper = humps.iter().map(|hump| hump.size).fold(0.0, f64::max);
            if lower > limit {
                return Ok(Verdict::TooShort(mix));
            }
            if upper <= limit {
                return Ok(Verdict::LongEnough(mix));
            }
            idle = if upper - lower < 0.99 * gap { 0 } else { idle + 1 };
            gap = gap.min(upper - lower);
            if gap <= GAP || idle > MAX_IDLE {
                // as good as the proof of what Newton's method finds
                let holds = upper <= limit * (1.0 + MARGIN);
                return Ok(if holds { Verdict::LongEnough(mix) } else { Verdict::Close(mix) });
            }
            let value = 0.5 * (lower + upper);
            self.places.extend(prices.iter().filter(|(_, jet)| jet[0] < value).map(|(place, _)| *place));
            for Hump { range, omega, size } in humps.into_iter().filter(|hump| hump.size > value) {
                let response = self.ranges[range].response;
                let [f, ..] = mix.answer(response, omega);
                self.cuts.push(Cut { range, response, omega, direction: f / size });
            }
        }
        Err(SpecifiedError::NotFound)
    }

    /// Solves the game of the present points.
    fn play(&mut self) -> Option<Mix> {
        let payoff = DMatrix::from_fn(self.cuts.len(), self.places.len(), |cut, place| {
            let cut = self.cuts[cut];
            (cut.direction.conj() * cut.response.value(cut.omega, self.places[place])).re
        });
        let solution = game::solve(&payoff)?;
        let used = |share: &f64| *share > 0.0;
        let train = self.places.iter().copied().zip(solution.columns).filter(|(_, share)| used(share)).collect();
        let weights = self.cuts.iter().copied().zip(solution.rows).filter(|(_, share)| used(share)).collect();
        Some(Mix { train, weights })
    }
}

/// Enough for functions that oscillate over the given phase.
pub(crate) fn samples(phase: f64) -> usize {
    16 + (10.0 * phase) as usize
}

/// Places and cuts in a game. Trains of up to 32 impulses need less than 800, and larger games take many seconds.
const MAX_POINTS: usize = 900;

/// Rounds of exchange; about ten are usual.
const MAX_ROUNDS: usize = 200;

/// Rounds without progress after which rounding is all that is left.
const MAX_IDLE: u32 = 20;

/// Bounds this close to each other are equal to rounding.
const GAP: f64 = 1e-13;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_game_too_large_is_not_played() {
        let mut exchange = Exchange::new(vec![Range { response: Response::Symmetric, low: 0.9, high: 1.1 }]);
        exchange.places = vec![0.5; MAX_POINTS];
        let Err(error) = exchange.judge(1.0, 0.05) else { panic!("the game was played") };
        assert_eq!(error, SpecifiedError::TooWide);
    }
}
