//! The counts of a stream of pairs.

use predicament_contacts::checks::audit::{Judgement, Verdict};

/// The relative distance to T₋ or T₊, 2⁻²⁰, within which a distance counts as near.
pub const NEAR: f64 = 1.0 / 1_048_576.0;

/// The counts and extremes of a stream; the counts of its parts add up.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Tally {
    /// The number of pairs that were not decided, because a sub-pair was registered.
    pub ended: u64,
    /// The number of decisions by [`Verdict`].
    verdicts: [u64; Verdict::ALL.len()],
    /// The number of decisions that registered the pair.
    pub registered: u64,
    /// The number of decisions with a distance near T₋ or T₊.
    ///
    /// The distance is the pair's own if the pair has a tolerance, else the distance of a facet from the other simplex.
    pub near: u64,
    /// The largest error of a weight.
    pub weight_error: f64,
    /// The smallest quotient of a guarded quantity and its lower bound.
    pub room: Option<f64>,
    /// The first decision that broke the guarantee.
    pub first: Option<Violation>,
}

/// A decision that broke the guarantee.
#[derive(Clone, PartialEq, Debug)]
pub struct Violation {
    /// The broken clause of the guarantee.
    pub verdict: Verdict,
    /// The L of the tolerances.
    pub length: f64,
    /// Both simplices; in the plane, z is 0.
    pub pair: [Vec<[f64; 3]>; 2],
    /// The distance of the closed simplices: the square root of the exact square, rounded.
    pub distance: f64,
}

impl Tally {
    /// The number of answers with this verdict.
    #[must_use]
    pub fn count(&self, verdict: Verdict) -> u64 {
        self.verdicts[verdict as usize]
    }

    /// The number of decided pairs: those without a registered sub-pair.
    #[must_use]
    pub fn decisions(&self) -> u64 {
        self.verdicts.iter().sum()
    }

    /// The number of answers that broke the guarantee.
    #[must_use]
    pub fn violations(&self) -> u64 {
        Verdict::ALL.into_iter().filter(|verdict| !verdict.is_legal()).map(|verdict| self.count(verdict)).sum()
    }

    pub(super) fn note(&mut self, judgement: &Judgement, registered: bool, near: bool) {
        self.verdicts[judgement.verdict as usize] += 1;
        self.registered += u64::from(registered);
        self.near += u64::from(near);
        self.weight_error = self.weight_error.max(judgement.weight_error.unwrap_or(0.0));
        self.room = least(self.room, judgement.room.map(f64::sqrt));
    }

    /// The counts of two parts of a stream together, with this one first.
    #[must_use]
    pub fn plus(mut self, later: Tally) -> Tally {
        self.ended += later.ended;
        self.registered += later.registered;
        self.near += later.near;
        for (count, more) in self.verdicts.iter_mut().zip(later.verdicts) {
            *count += more;
        }
        self.weight_error = self.weight_error.max(later.weight_error);
        self.room = least(self.room, later.room);
        self.first = self.first.or(later.first);
        self
    }
}

fn least(a: Option<f64>, b: Option<f64>) -> Option<f64> {
    a.into_iter().chain(b).reduce(f64::min)
}
