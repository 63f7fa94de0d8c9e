//! Many queries at once: the static filter on whole registers.
//!
//! Queries are taken a block at a time: their points are gathered, the
//! determinants of the block are computed lane by lane, and their signs are
//! written where they are certain. The few that are not are collected and
//! climb the ladder one by one, so that they don't hold up the others.

#![allow(clippy::needless_range_loop)]

mod simd;

use std::marker::PhantomData;

use predicament_predicates::Sign;

use crate::estimate::Estimate;
use crate::predicate::Predicate;
use simd::{Kernel, dispatch};

/// The queries of a block: a bit each in a mask.
const BLOCK: usize = 64;

/// Queries of `N` points each, and what to do about them.
pub(crate) struct Batch<'a, Q, F, S, C> {
    /// The bounds of the static and of the semi-static filter.
    pub bounds: [f64; 2],
    /// What is asked.
    pub queries: &'a [Q],
    /// A place for each answer.
    pub out: &'a mut [Sign],
    /// Gives the coordinates of a point.
    pub point: F,
    /// Told how many queries of a block each of the two has settled.
    pub settled: S,
    /// Answers a query that it leaves open.
    pub climb: C,
}

/// Answers all queries.
///
/// # Panics
/// If a query names a point that there is not.
#[inline]
pub(crate) fn run<P, V, const D: usize, const N: usize>(
    batch: Batch<'_, [V; N], impl Fn(V) -> [f64; D], impl Fn([u64; 2]), impl Fn(&[V; N]) -> Sign>,
) where
    P: Predicate<D, N>,
    V: Copy,
{
    dispatch(Of { batch, predicate: PhantomData::<P> });
}

/// A batch of queries of one predicate.
struct Of<B, P> {
    batch: B,
    predicate: PhantomData<P>,
}

impl<P, V, F, S, C, const D: usize, const N: usize> Kernel for Of<Batch<'_, [V; N], F, S, C>, P>
where
    P: Predicate<D, N>,
    V: Copy,
    F: Fn(V) -> [f64; D],
    S: Fn([u64; 2]),
    C: Fn(&[V; N]) -> Sign,
{
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Batch { bounds: [static_bound, semi_static_bound], queries, out, point, settled, climb } = self.batch;
        let mut block = [[[0.0; D]; BLOCK]; N];
        for (queries, out) in queries.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            // Row by row and not with `map` on arrays, which goes through memory.
            for (at, query) in queries.iter().enumerate() {
                for row in 0..N {
                    block[row][at] = point(query[row]);
                }
            }
            let (mut signs, open) = filter::<P, D, N>(&block, |_| static_bound);
            let open = open & (u64::MAX >> (BLOCK - queries.len()));
            let by_static = queries.len() as u64 - u64::from(open.count_ones());
            let mut left = open;
            if open != 0 {
                // (A determinant that is large enough for the one has the same sign for the other.)
                let (again, still) = filter::<P, D, N>(&block, |permanent| semi_static_bound * permanent);
                signs = again;
                left = open & still;
            }
            out.copy_from_slice(&signs[..queries.len()]);
            settled([by_static, u64::from(open.count_ones() - left.count_ones())]);
            let mut open = left;
            while open != 0 {
                let at = open.trailing_zeros() as usize;
                out[at] = climb(&queries[at]);
                open &= open - 1;
            }
        }
    }
}

/// The signs of a block, and a mask of those that are not certain: whose
/// magnitude is not at least the bound that comes from the permanent.
#[inline(always)]
fn filter<P: Predicate<D, N>, const D: usize, const N: usize>(
    block: &[[[f64; D]; BLOCK]; N],
    bound: impl Fn(f64) -> f64,
) -> ([Sign; BLOCK], u64) {
    let mut determinants = [0.0; BLOCK];
    let mut bounds = [0.0; BLOCK];
    for at in 0..BLOCK {
        let Estimate { determinant, permanent } = P::estimate(std::array::from_fn(|row| block[row][at]));
        determinants[at] = determinant;
        bounds[at] = bound(permanent);
    }
    let mut signs = [Sign::Zero; BLOCK];
    let mut open = 0;
    for at in 0..BLOCK {
        signs[at] = if determinants[at] > 0.0 {
            Sign::Positive
        } else if determinants[at] < 0.0 {
            Sign::Negative
        } else {
            Sign::Zero
        };
        // With a bound that is NaN nothing is certain.
        let certain = determinants[at].abs() >= bounds[at];
        open |= u64::from(!certain) << at;
    }
    (signs, open)
}
