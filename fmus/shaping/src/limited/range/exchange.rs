//! The least highest ratio that commands of a given length can be held to, found by exchange.
//!
//! One side mixes commands, the other mixes cuts (ω, φ); the payoff is Re e^{−jφ}F(ω)/√(|B|² + ε²). In every round each side's best
//! answer to the other's mix is added: the command that is on where the cuts' price is lowest, and the humps of the mixed
//! command's ratio. They bound the value of the whole game from either side.

use nalgebra::{Complex, DMatrix};

use super::problem::{Command, Problem};
use super::reply::reply;
use crate::specified::{Jet, minima, samples, solve};

/// A tangent to the cone |F(ω)| ≤ v·level: Re(e^{−jφ}F(ω)) ≤ v·level.
#[derive(Clone, Copy)]
pub(super) struct Cut {
    pub omega: f64,
    /// e^{jφ}
    pub direction: Complex<f64>,
    /// √(|B|² + ε²)
    pub level: f64,
}

/// Both sides' mixes, and the best command for the cuts'.
pub(super) struct Mix {
    pub commands: Vec<(Command, f64)>,
    pub weights: Vec<(Cut, f64)>,
    pub reply: Command,
}

#[derive(Clone, Copy)]
pub(super) enum Verdict {
    /// No command of this length holds the limit.
    TooShort,
    /// The mix's command holds it.
    LongEnough,
    /// Not told so far; asking again goes on.
    Open,
    /// Rounding hides the answer.
    Close,
}

pub(super) struct Exchange {
    problem: Problem,
    commands: Vec<Command>,
    cuts: Vec<Cut>,
}

/// p(τ) = Σ y Re(e^{−jφ}e(ω, τ))/level.
pub(super) fn price(problem: &Problem, weights: &[(Cut, f64)], tau: f64) -> Jet {
    weights.iter().fold([0.0; 3], |[value, slope, curvature], (cut, weight)| {
        let e = problem.response.derivatives(cut.omega, tau);
        let part = |e: Complex<f64>| (cut.direction.conj() * e).re * weight / cut.level;
        [value + part(e.value), slope + part(e.by_tau), curvature + part(e.by_tau_tau)]
    })
}

/// Where a ratio given by its answer is highest: frequencies and |F|/level.
pub(super) fn humps(problem: &Problem, longest: f64, answer: impl Fn(f64) -> [Complex<f64>; 3]) -> Vec<(f64, f64)> {
    let phase = (problem.high - problem.low) * (longest + problem.on_time);
    let found = minima(problem.low..=problem.high, samples(phase), |omega| {
        problem.ratio(answer(omega), omega).map(|part| -part)
    });
    found.into_iter().map(|(omega, [square, ..])| (omega, (-square).sqrt())).collect()
}

impl Exchange {
    pub fn new(problem: Problem) -> Self {
        let cut = |omega| Cut { omega, direction: Complex::ONE, level: problem.level(omega)[0].sqrt() };
        Self { problem, commands: Vec::new(), cuts: [problem.low, problem.high].map(cut).to_vec() }
    }

    /// Whether a command up to `longest` can keep the limit. What the answer uses is kept for the next question. `None` if rounding
    /// broke the game itself.
    pub fn judge(&mut self, longest: f64) -> Option<(Verdict, Mix)> {
        let (verdict, mix) = self.play_rounds(longest)?;
        self.commands = mix.commands.iter().map(|(command, _)| command.clone()).collect();
        self.cuts = mix.weights.iter().map(|(cut, _)| *cut).collect();
        Some((verdict, mix))
    }

    fn play_rounds(&mut self, longest: f64) -> Option<(Verdict, Mix)> {
        let problem = self.problem;
        self.commands = self.commands.drain(..).filter_map(|command| shortened(command, longest)).collect();
        self.commands.push(vec![[longest - problem.on_time, longest]]);
        for round in 0..MAX_ROUNDS {
            let mix = self.play(longest)?;
            let payoff = |(cut, weight): &(Cut, f64)| weight * self.payoff(cut, &mix.reply);
            let lower: f64 = mix.weights.iter().map(payoff).sum();
            let answer = |omega| {
                mix.commands.iter().fold([Complex::ZERO; 3], |sum, (command, share)| {
                    let own = problem.answer(command, omega);
                    std::array::from_fn(|i| sum[i] + own[i] * *share)
                })
            };
            let humps = humps(&problem, longest, answer);
            let upper = humps.iter().map(|(_, size)| *size).fold(0.0, f64::max);
            if lower > problem.limit {
                return Some((Verdict::TooShort, mix));
            }
            if upper <= problem.limit {
                return Some((Verdict::LongEnough, mix));
            }
            if upper - lower <= GAP {
                return Some((Verdict::Close, mix));
            }
            if round == MAX_ROUNDS - 1 {
                return Some((Verdict::Open, mix));
            }
            let value = 0.5 * (lower + upper);
            for (omega, size) in humps.into_iter().filter(|(_, size)| *size > value) {
                let [f, ..] = answer(omega);
                let level = problem.level(omega)[0].sqrt();
                self.cuts.push(Cut { omega, direction: f / (size * level), level });
            }
            self.commands.push(mix.reply);
        }
        None
    }

    fn payoff(&self, cut: &Cut, command: &Command) -> f64 {
        (cut.direction.conj() * self.problem.answer(command, cut.omega)[0]).re / cut.level
    }

    /// Solves the game of the present commands and cuts.
    fn play(&self, longest: f64) -> Option<Mix> {
        let mut payoff = DMatrix::from_fn(self.cuts.len(), self.commands.len(), |cut, command| {
            self.payoff(&self.cuts[cut], &self.commands[command])
        });
        payoff /= payoff.amax().max(1.0); // the size of the stakes changes nobody's choice
        let solution = solve(&payoff)?;
        let used = |share: &f64| *share > 0.0;
        let commands = self.commands.iter().cloned().zip(solution.columns).filter(|(_, share)| used(share)).collect();
        let weights: Vec<_> = self.cuts.iter().copied().zip(solution.rows).filter(|(_, share)| used(share)).collect();
        let prices = |tau: f64| price(&self.problem, &weights, tau);
        let reply = reply(&prices, longest, self.problem.high, self.problem.on_time);
        Some(Mix { commands, reply, weights })
    }
}

/// A command with its last pulse moved so far that it ends in time; none if it would meet the one before.
fn shortened(mut command: Command, longest: f64) -> Option<Command> {
    let before = command.len().checked_sub(2).map_or(0.0, |index| command[index][1]);
    let [from, to] = command.last_mut()?;
    if *to > longest {
        (*from, *to) = (longest - (*to - *from), longest);
    }
    (*from >= before).then_some(command)
}

/// Rounds of exchange before Newton's method has a try, and what is not in use is forgotten.
const MAX_ROUNDS: usize = 12;

/// Bounds this close to each other are equal to rounding.
const GAP: f64 = 1e-12;
