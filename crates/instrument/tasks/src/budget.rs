//! Budgets: the sample sizes of a judge, beyond the queries themselves.

/// The sample sizes of a judge. Samples are spread evenly and by index only, so they are the same in every run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Budget {
    /// Findings kept per class; all are counted.
    pub findings_per_class: usize,
    /// Evaluations spent on argument permutations; zero means none.
    pub permutations: usize,
    /// Tuples tried for relations between answers (Grassmann-Plücker, transitivity).
    pub relations: usize,
    /// True if all applicable laws are checked: also the relations of circles and spheres and the mixed ones, in all
    /// planes, of single calls and batches, of the scene and its first half.
    pub thorough: bool,
    /// The number of broken ties that are compared with explicit infinitesimals.
    pub ties: usize,
    /// True if every answer is recorded: see [`Outcome::answers`](crate::Outcome::answers).
    pub answers: bool,
}

impl Budget {
    /// The budget of level quick: samples only, seconds for all embedded corpora.
    pub const QUICK: Budget = Budget {
        findings_per_class: 25,
        permutations: 5_000,
        relations: 500,
        thorough: false,
        ties: 50,
        answers: false,
    };
    /// The budget of level full: every permutation of every query, up to 24 million evaluations a scene.
    pub const FULL: Budget = Budget {
        findings_per_class: 25,
        permutations: 24_000_000,
        relations: 50_000,
        thorough: true,
        ties: 2_000,
        answers: false,
    };

    /// Evenly spread numbers below `n`, as many as `budget` allows at this cost each; empty without a budget.
    pub fn spread(n: usize, cost: usize, budget: usize) -> impl Iterator<Item = usize> {
        let step = (n * cost).div_ceil(budget.max(1)).max(1);
        (0..if budget == 0 { 0 } else { n }).step_by(step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_spread_over_everything_and_cost_no_more_than_the_budget() {
        let sample = |n, cost, budget| Budget::spread(n, cost, budget).collect::<Vec<_>>();
        assert_eq!(sample(10, 1, 100), (0..10).collect::<Vec<_>>());
        assert_eq!(sample(10, 2, 10), [0, 2, 4, 6, 8]);
        assert_eq!(sample(1_000_000, 1, 3), [0, 333_334, 666_668]);
        assert_eq!(sample(10, 24, 0), [] as [usize; 0], "no budget buys nothing");
        assert_eq!(sample(0, 24, 10), [] as [usize; 0]);
    }
}
