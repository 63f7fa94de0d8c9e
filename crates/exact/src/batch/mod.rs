//! Many queries at once: the static filter on whole registers.
//!
//! Queries are taken a block at a time: their points are gathered, the
//! determinants of the block are computed lane by lane, and their signs are
//! written where they are certain. The few that are not are collected and
//! climb the ladder one by one, so that they don't hold up the others.

mod simd;

use predicament_predicates::{Sign, Vertex};

use crate::ladder::Prepared;
use crate::predicate::Predicate;
use simd::{Kernel, dispatch};

/// The queries of a block: a bit each in a mask.
const BLOCK: usize = 64;

/// Answers queries on points by index; `settled` is told of each block how many
/// the static filter settled, and of each query that climbed where it ended.
///
/// # Panics
/// If a query names a point that there is not, or `out` is shorter than `queries`.
pub(crate) fn by_index<P: Predicate<D, N>, const D: usize, const N: usize>(
    prepared: &Prepared,
    points: &[[f64; D]],
    queries: &[[Vertex; N]],
    out: &mut [Sign],
    settled: impl FnMut(usize, u64),
) {
    let fetch = |v: Vertex| points[v.index()];
    dispatch(Batch { prepared, queries, out, fetch, settled, predicate: std::marker::PhantomData::<P> });
}

struct Batch<'a, P, Q, F, S> {
    prepared: &'a Prepared,
    queries: &'a [Q],
    out: &'a mut [Sign],
    fetch: F,
    settled: S,
    predicate: std::marker::PhantomData<P>,
}

impl<P, Q, F, S, const D: usize, const N: usize> Kernel for Batch<'_, P, [Q; N], F, S>
where
    P: Predicate<D, N>,
    Q: Copy,
    F: Fn(Q) -> [f64; D],
    S: FnMut(usize, u64),
{
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let mut block = [[[0.0; D]; BLOCK]; N];
        let chunks = self.queries.chunks(BLOCK).zip(self.out.chunks_mut(BLOCK));
        for (queries, out) in chunks {
            for (at, query) in queries.iter().enumerate() {
                for row in 0..N {
                    block[row][at] = (self.fetch)(query[row]);
                }
            }
            let (signs, open) = filter::<P, D, N>(&block, self.prepared.static_bound);
            out.copy_from_slice(&signs[..queries.len()]);
            let mut open = open & (u64::MAX >> (BLOCK - queries.len()));
            (self.settled)(self.prepared.static_stage, queries.len() as u64 - u64::from(open.count_ones()));
            while open != 0 {
                let at = open.trailing_zeros() as usize;
                let (sign, stage) = self.prepared.climb::<P, D, N>(std::array::from_fn(|row| block[row][at]));
                out[at] = sign;
                (self.settled)(stage, 1);
                open &= open - 1;
            }
        }
    }
}

/// The signs of a block, and a mask of those that are not certain.
#[inline(always)]
fn filter<P: Predicate<D, N>, const D: usize, const N: usize>(
    block: &[[[f64; D]; BLOCK]; N],
    bound: f64,
) -> ([Sign; BLOCK], u64) {
    let mut determinants = [0.0; BLOCK];
    for (at, determinant) in determinants.iter_mut().enumerate() {
        *determinant = P::estimate(std::array::from_fn(|row| block[row][at])).determinant;
    }
    let mut signs = [Sign::Zero; BLOCK];
    let mut open = 0;
    for (at, (sign, determinant)) in signs.iter_mut().zip(determinants).enumerate() {
        *sign = if determinant > 0.0 {
            Sign::Positive
        } else if determinant < 0.0 {
            Sign::Negative
        } else {
            Sign::Zero
        };
        // With a bound that is NaN nothing is certain.
        let certain = determinant.abs() >= bound;
        open |= u64::from(!certain) << at;
    }
    (signs, open)
}
