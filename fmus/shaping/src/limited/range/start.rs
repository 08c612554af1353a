//! One command out of a mix of many, from which Newton's method starts.

use super::exchange::{Mix, price};
use super::problem::{Command, Problem};
use crate::order::order_by;
use crate::specified::{minima, samples};

impl Mix {
    /// The mixed command with each passage from on to off, in which it is on in part, made one switch. The switch keeps the
    /// on-time from the middle of the pulse to the middle of the gap, so that what the command leaves differs by the square of the
    /// passage's length only: where the bare ramp leaves next to nothing, that is what counts.
    pub fn rounded(&self) -> Command {
        let mut runs: Vec<(bool, [f64; 2])> = Vec::new();
        for [from, to] in self.stretches() {
            let on = self.on_time(from, to) > 0.5 * (to - from);
            match runs.last_mut() {
                Some((last, run)) if *last == on => run[1] = to,
                _ => runs.push((on, [from, to])),
            }
        }
        let middle = |[from, to]: [f64; 2]| 0.5 * (from + to);
        let switches: Vec<f64> = runs
            .windows(2)
            .map(|pair| {
                let (from, to) = (middle(pair[0].1), middle(pair[1].1));
                if pair[0].0 { from + self.on_time(from, to) } else { to - self.on_time(from, to) }
            })
            .collect();
        for (index, switch) in switches.into_iter().enumerate() {
            runs[index].1[1] = switch;
            runs[index + 1].1[0] = switch;
        }
        runs.into_iter().filter(|(on, _)| *on).map(|(_, run)| run).collect()
    }

    /// For each minimum of the price one pulse, with the on-time of all commands that is nearer to it than to another one. That is the
    /// start for short ramps, whose pulses are next to impulses: commands are then mixed place by place, and on for less than half
    /// everywhere. `None` if pulses would overlap.
    pub fn gathered(&self, problem: &Problem, longest: f64) -> Option<Command> {
        let minima = minima(0.0..=longest, samples(problem.high * longest), |tau| price(problem, &self.weights, tau));
        let mut pulses: Vec<(f64, f64)> = minima.into_iter().map(|(place, _)| (place, 0.0)).collect();
        for [from, to] in self.stretches() {
            let distance = |place: f64| (place - 0.5 * (from + to)).abs();
            let nearest = pulses.iter_mut().min_by(|(a, _), (b, _)| distance(*a).total_cmp(&distance(*b)))?;
            nearest.1 += self.on_time(from, to);
        }
        let pulse = |(place, width): (f64, f64)| {
            let middle = place.clamp(0.5 * width, longest - 0.5 * width);
            [middle - 0.5 * width, middle + 0.5 * width]
        };
        let command: Command = pulses.into_iter().filter(|(_, width)| *width > 0.0).map(pulse).collect();
        command.is_sorted_by(|earlier, later| earlier[1] < later[0]).then_some(command)
    }

    /// From each place where a command is switched to the next.
    fn stretches(&self) -> impl Iterator<Item = [f64; 2]> {
        let mut places: Vec<f64> =
            self.commands.iter().flat_map(|(command, _)| command.iter().flatten().copied()).collect();
        order_by(&mut places, |place| *place);
        places.dedup();
        (1..places.len()).map(move |next| [places[next - 1], places[next]])
    }

    /// For how long the mixed command is on between two places.
    fn on_time(&self, from: f64, to: f64) -> f64 {
        let part = |[start, end]: &[f64; 2]| (end.min(to) - start.max(from)).max(0.0);
        self.commands.iter().map(|(command, share)| share * command.iter().map(part).sum::<f64>()).sum()
    }
}

/// Pulses and gaps that are next to nothing are left-overs of the exchange.
pub(super) fn without_slivers(command: &Command, on_time: f64) -> Command {
    let mut kept: Command = Vec::new();
    for [from, to] in command.iter().copied().filter(|[from, to]| to - from > SLIVER * on_time) {
        match kept.last_mut() {
            Some(last) if from - last[1] < SLIVER => last[1] = to,
            _ => kept.push([if from < SLIVER * on_time { 0.0 } else { from }, to]),
        }
    }
    kept
}

/// Pulses below this share of the on-time, and gaps below so much, are left-overs of the exchange.
const SLIVER: f64 = 1e-6;
