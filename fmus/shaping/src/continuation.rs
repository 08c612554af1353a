//! Solutions followed from where they are known to where they are wanted.

use nalgebra::SVector;

/// How a solution is followed: in steps as large as the solver takes.
pub(crate) struct Pace {
    /// Length of the first step.
    pub first: f64,
    /// What a step is multiplied by after one that was taken.
    pub growth: f64,
    /// What a step is multiplied by if it was too long.
    pub shrinkage: f64,
    /// A continuation that cannot go on by this share of what it has come ends there.
    pub finest: f64,
    /// Steps, taken or not.
    pub most: u32,
}

impl Pace {
    /// The solution at `end`, from the known one at 0 on; if there is none, or none found, the last place that has one.
    ///
    /// The solver gets a guess and a place. Guesses are extrapolated from the last two solutions; the first ones are `guess`, which
    /// at 0 is the solution.
    pub fn follow<const N: usize>(
        &self,
        end: f64,
        guess: impl Fn(f64) -> SVector<f64, N>,
        solve: impl Fn(&SVector<f64, N>, f64) -> Option<SVector<f64, N>>,
    ) -> Result<SVector<f64, N>, f64> {
        let mut here = (0.0, guess(0.0));
        if end == 0.0 {
            return Ok(here.1);
        }
        let mut tangent = None;
        let mut step = self.first;
        for _ in 0..self.most {
            let next = if here.0 + step < end { here.0 + step } else { end };
            let length = next - here.0;
            let guess = tangent.map_or_else(|| guess(next), |tangent| here.1 + tangent * length);
            if let Some(solution) = solve(&guess, next) {
                if next == end {
                    return Ok(solution);
                }
                tangent = Some((solution - here.1) / length);
                here = (next, solution);
                step *= self.growth;
            } else {
                step *= self.shrinkage;
                if step < self.finest * here.0.max(self.finest * end) {
                    break;
                }
            }
        }
        Err(here.0)
    }
}

/// The last place that has a solution when asked for itself: with other steps a continuation may end a little sooner.
pub(crate) fn confirmed<T>(mut place: f64, solve: impl Fn(f64) -> Result<T, f64>) -> f64 {
    for _ in 0..MOST_QUESTIONS {
        match solve(place) {
            Err(sooner) => place = sooner,
            Ok(_) => break,
        }
    }
    place
}

/// One or two do, as a rule.
const MOST_QUESTIONS: u32 = 20;

#[cfg(test)]
mod tests {
    use super::*;

    const PACE: Pace = Pace { first: 0.5, growth: 2.0, shrinkage: 0.5, finest: 1e-4, most: 100 };

    /// x² = 1 − s by Newton's method from nearby only; the branch x > 0 ends at s = 1.
    fn root(guess: &SVector<f64, 1>, s: f64) -> Option<SVector<f64, 1>> {
        let root = (1.0 - s).sqrt();
        ((guess.x - root).abs() < 0.1).then(|| SVector::from([root]))
    }

    #[test]
    fn a_branch_is_followed_to_its_end() {
        let start = |_| SVector::from([1.0]);
        assert_eq!(PACE.follow(0.0, start, root).unwrap().x, 1.0);
        assert!((PACE.follow(0.99, start, root).unwrap().x - 0.1).abs() < 1e-15);
        let last = PACE.follow(1.5, start, root).unwrap_err();
        assert!(0.999 < last && last <= 1.0, "{last}");
    }
}
