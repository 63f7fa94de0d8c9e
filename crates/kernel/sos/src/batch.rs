//! The ties of a batch: found among its answers and broken, many at once if there are enough.

use predicament_lanes::BLOCK;
use predicament_predicates::Sign;

use crate::leading::Decided;

/// The method to break a predicate's ties: one by one, and up to a block at once.
pub(crate) trait Ties<Q> {
    /// Breaks one tie.
    fn one(&self, tie: Q) -> Decided;

    /// Writes the signs of some ties; returns a bit mask of the ties that remain open.
    fn many(&self, ties: &[Q], out: &mut [Sign]) -> u64;
}

/// A function breaks ties one by one.
impl<Q, F: Fn(Q) -> Decided> Ties<Q> for F {
    #[inline(always)]
    fn one(&self, tie: Q) -> Decided {
        self(tie)
    }

    #[inline(always)]
    fn many(&self, _: &[Q], _: &mut [Sign]) -> u64 {
        u64::MAX
    }
}

impl<Q, F: Fn(Q) -> Decided, M: Fn(&[Q], &mut [Sign]) -> u64> Ties<Q> for (F, M) {
    #[inline(always)]
    fn one(&self, tie: Q) -> Decided {
        self.0(tie)
    }

    #[inline(always)]
    fn many(&self, ties: &[Q], out: &mut [Sign]) -> u64 {
        self.1(ties, out)
    }
}

/// The least number of ties in a block for which vector registers pay off.
const MANY: usize = 8;

/// Breaks all ties of a batch.
#[inline(always)]
pub(crate) fn break_all<Q: Copy>(queries: &[Q], out: &mut [Sign], ties: impl Ties<Q>, rest: impl Fn(Q) -> Sign) {
    let one = |query: Q| match ties.one(query) {
        Some((sign, _)) => sign,
        None => rest(query),
    };
    for (queries, out) in queries.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
        // Tested for whole registers at once: most blocks have no tie.
        if !out.iter().fold(false, |any, sign| any | sign.is_zero()) {
            continue;
        }
        // Ties occur at random: those of a block are found without a branch for each.
        let (mut places, mut count) = ([0; BLOCK], 0);
        for (at, sign) in (0_u8..).zip(out.iter()) {
            places[count] = at;
            count += usize::from(sign.is_zero());
        }
        let places = places[..count].iter().map(|&at| usize::from(at));
        if count < MANY {
            places.for_each(|at| out[at] = one(queries[at]));
            continue;
        }
        if count == queries.len() {
            let mut open = ties.many(queries, out) & (u64::MAX >> (BLOCK - count));
            while open != 0 {
                let at = open.trailing_zeros() as usize;
                out[at] = one(queries[at]);
                open &= open - 1;
            }
            continue;
        }
        let (mut tied, mut signs) = ([queries[0]; BLOCK], [Sign::Zero; BLOCK]);
        places.clone().zip(&mut tied).for_each(|(at, tie)| *tie = queries[at]);
        let open = ties.many(&tied[..count], &mut signs[..count]);
        for (tie, at) in places.enumerate() {
            out[at] = if open >> tie & 1 == 0 { signs[tie] } else { one(queries[at]) };
        }
    }
}
