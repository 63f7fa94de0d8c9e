//! Many queries at once: the static filter on whole registers.
//!
//! Queries are processed one block at a time: their points are gathered, the determinants of the block are computed
//! lane by lane, and their signs are written where they are certain. The few uncertain queries are collected and climb
//! the ladder one by one, so that they don't delay the others.

#![allow(clippy::needless_range_loop)]
#![allow(unsafe_code)]

mod sweep;
#[cfg(test)]
mod tests;
mod ties;

use core::marker::PhantomData;

use predicament_lanes::{BLOCK, Block, Kernel, View, dispatch};
use predicament_predicates::{Sign, Vertex};

use crate::anywhere::Bounded;
use crate::predicate::Predicate;
use crate::stage;
pub(crate) use sweep::{Sweep, sweep};
use ties::BreakZeros;
pub use ties::Ties;
pub(crate) use ties::Unbroken;

/// The number of queries of a batch that each stage has settled, by the stage's index.
pub(crate) type Settled = [u64; stage::NAMES.len()];
/// The counts before the first query.
pub(crate) const NONE: Settled = [0; stage::NAMES.len()];

/// Queries of `N` vertices each, with the filter's bound and the function for open queries.
pub(crate) struct Batch<'a, B, C, T, const E: usize, const N: usize> {
    /// The bound of the static filter, or NaN.
    pub static_bound: f64,
    /// The points of the vertices; a query with a vertex without a point is never certain and climbs.
    pub points: &'a [[f64; E]],
    /// The vertices of each query.
    pub queries: &'a [[Vertex; N]],
    /// A place for each answer.
    pub out: &'a mut [Sign],
    /// Returns true if doubles make no error; called only if filters leave something open.
    pub is_double: B,
    /// Answers an open query, and returns the stage that settled it.
    pub climb: C,
    /// Breaks the ties of blocks where doubles make no error.
    pub ties: T,
}

/// Answers all queries with a predicate that sees points in this view.
#[inline]
pub(crate) fn run<P, V, const E: usize, const D: usize, const N: usize>(
    batch: Batch<'_, impl Fn() -> bool, impl Fn(&[Vertex; N]) -> (Sign, usize), impl Ties<D, N>, E, N>,
) -> Settled
where
    P: Predicate<D, N>,
    V: View<E, D>,
{
    dispatch(Of { batch, predicate: PhantomData::<(P, V, [(); D])> })
}

/// A batch of queries of one predicate.
struct Of<B, P> {
    batch: B,
    predicate: PhantomData<P>,
}

impl<P, V, B, C, T, const E: usize, const D: usize, const N: usize> Kernel
    for Of<Batch<'_, B, C, T, E, N>, (P, V, [(); D])>
where
    T: Ties<D, N>,
    P: Predicate<D, N>,
    V: View<E, D>,
    B: Fn() -> bool,
    C: Fn(&[Vertex; N]) -> (Sign, usize),
{
    type Output = Settled;

    #[inline(always)]
    unsafe fn run<const WIDE: bool>(self) -> Settled {
        let Batch { static_bound, points, queries, out, is_double, climb, ties } = self.batch;
        let mut settled = NONE;
        let mut block = Block::EMPTY;
        for (queries, out) in queries.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            if lack_points(queries, points.len()) {
                climb_all(queries, out, &mut settled, &climb);
                continue;
            }
            // SAFETY: the kernel runs wide only on processors with AVX-512F.
            unsafe { block.fetch::<V, E, WIDE>(points, queries) };
            let Filtered { signs, open, zeros } =
                filter(&block, |points| (P::estimate(points).determinant, static_bound));
            let open = open & (u64::MAX >> (BLOCK - queries.len()));
            // (Where the second filter is certain, the first one has found the same sign: the determinant is the same.)
            out.copy_from_slice(&signs[..queries.len()]);
            settled[stage::STATIC] += queries.len() as u64 - u64::from(open.count_ones());
            if open == 0 {
                continue;
            }
            // (The second filter is never certain of zero: if only zeros remain, it does not run.)
            let mut left = open;
            if open & !zeros != 0 {
                let second = filter(&block, |points| {
                    let Bounded { determinant, bound } = P::anywhere(points);
                    // Strictly beyond the bound; zero is not.
                    (determinant, if determinant.abs() > bound { 0.0 } else { f64::NAN })
                });
                left = open & second.open;
                settled[stage::SEMI_STATIC] += u64::from(open.count_ones() - left.count_ones());
                if left == 0 {
                    continue;
                }
            }
            // (Vertices without points have a NaN determinant, which is not zero.)
            if left & !zeros == 0 && is_double() {
                settled[stage::DOUBLE] += u64::from(left.count_ones());
                if T::BREAKS && left.count_ones() >= ties::MANY {
                    ties.break_zeros(&block, queries, out);
                }
                continue;
            }
            for at in ones(left) {
                let stage;
                (out[at], stage) = climb(&queries[at]);
                settled[stage] += 1;
            }
        }
        settled
    }
}

/// Returns true if each query has a vertex without a point: no filter on points can settle one of them.
///
/// In other blocks the first query is usually the only one that is looked at.
#[inline(always)]
fn lack_points<const N: usize>(queries: &[[Vertex; N]], points: usize) -> bool {
    queries.iter().all(|query| query.iter().any(|v| v.index() >= points))
}

/// Answers queries one by one.
#[inline]
pub(crate) fn climb_all<Q>(
    queries: &[Q],
    out: &mut [Sign],
    settled: &mut Settled,
    climb: impl Fn(&Q) -> (Sign, usize),
) {
    for (query, out) in queries.iter().zip(out) {
        let stage;
        (*out, stage) = climb(query);
        settled[stage] += 1;
    }
}

/// The positions of the ones in a mask, in order.
fn ones(mut mask: u64) -> impl Iterator<Item = usize> {
    core::iter::from_fn(move || {
        let at = mask.trailing_zeros() as usize;
        (mask != 0).then(|| mask &= mask - 1).map(|()| at)
    })
}

/// The results of a filter on a block.
struct Filtered {
    signs: [Sign; BLOCK],
    /// The queries whose signs are not certain, as bits of a mask.
    open: u64,
    /// The queries whose determinants are zero, as bits of a mask.
    zeros: u64,
}

/// Runs a filter on a block: `evaluate` gives a determinant and the magnitude from which on it is certain.
#[inline(always)]
fn filter<const D: usize, const N: usize>(
    block: &Block<D, N>,
    evaluate: impl Fn([[f64; D]; N]) -> (f64, f64),
) -> Filtered {
    let mut determinants = [0.0; BLOCK];
    let mut bounds = [0.0; BLOCK];
    for at in 0..BLOCK {
        (determinants[at], bounds[at]) = evaluate(block.query(at));
    }
    let mut signs = [Sign::Zero; BLOCK];
    let mut all_certain = true;
    for at in 0..BLOCK {
        signs[at] = if determinants[at] > 0.0 {
            Sign::Positive
        } else if determinants[at] < 0.0 {
            Sign::Negative
        } else {
            Sign::Zero
        };
        // With a NaN bound nothing is certain.
        all_certain &= determinants[at].abs() >= bounds[at];
    }
    let (mut open, mut zeros) = (0, 0);
    // Compilers read the shifted bits from memory, masked by lanes. If no bit is set, such a read does not bring its
    // page in, and costs hundreds of cycles each time that the page is absent: 40 ns a query in a shared library.
    if !all_certain {
        for at in 0..BLOCK {
            let certain = determinants[at].abs() >= bounds[at];
            open |= u64::from(!certain) << at;
            zeros |= u64::from(determinants[at] == 0.0) << at;
        }
    }
    Filtered { signs, open, zeros }
}
