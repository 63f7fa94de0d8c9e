//! Batches of a value for which the caller provides the formula, with one filter.

#![allow(unsafe_code)]

use core::marker::PhantomData;

use predicament_lanes::{BLOCK, Block, Kernel, View, dispatch};
use predicament_predicates::{Sign, Vertex};

use super::{Filtered, NONE, Settled, climb_all, filter, lack_points, ones};

/// Queries of `N` vertices each, with the formula and the function for open queries.
pub(crate) struct Sweep<'a, F, C, const E: usize, const N: usize> {
    /// The value whose sign is the answer, from the points, and the magnitude from which on its sign is certain.
    pub evaluate: F,
    /// The points of the vertices; a query with a vertex without a point is never certain and climbs.
    pub points: &'a [[f64; E]],
    /// The vertices of each query.
    pub queries: &'a [[Vertex; N]],
    /// A place for each answer.
    pub out: &'a mut [Sign],
    /// The stage of the filter.
    pub stage: usize,
    /// Answers an open query, and returns the stage that settled it.
    pub climb: C,
}

/// Answers all queries, with points seen in this view.
#[inline]
pub(crate) fn sweep<V: View<E, D>, const E: usize, const D: usize, const N: usize>(
    sweep: Sweep<'_, impl Fn([[f64; D]; N]) -> (f64, f64), impl Fn(&[Vertex; N]) -> (Sign, usize), E, N>,
) -> Settled {
    dispatch(In { sweep, view: PhantomData::<(V, [(); D])> })
}

/// Queries about points in a view.
pub(super) struct In<B, V> {
    pub sweep: B,
    pub view: PhantomData<V>,
}

impl<V, F, C, const E: usize, const D: usize, const N: usize> Kernel for In<Sweep<'_, F, C, E, N>, (V, [(); D])>
where
    V: View<E, D>,
    F: Fn([[f64; D]; N]) -> (f64, f64),
    C: Fn(&[Vertex; N]) -> (Sign, usize),
{
    type Output = Settled;

    #[inline(always)]
    unsafe fn run<const WIDE: bool>(self) -> Settled {
        let Sweep { evaluate, points, queries, out, stage, climb } = self.sweep;
        let mut settled = NONE;
        let mut block = Block::EMPTY;
        for (queries, out) in queries.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            if lack_points(queries, points.len()) {
                climb_all(queries, out, &mut settled, &climb);
                continue;
            }
            // SAFETY: the kernel runs wide only on processors with AVX-512F.
            unsafe { block.fetch::<V, E, WIDE>(points, queries) };
            let Filtered { signs, open, .. } = filter(&block, &evaluate);
            let open = open & (u64::MAX >> (BLOCK - queries.len()));
            out.copy_from_slice(&signs[..queries.len()]);
            settled[stage] += queries.len() as u64 - u64::from(open.count_ones());
            for at in ones(open) {
                let stage;
                (out[at], stage) = climb(&queries[at]);
                settled[stage] += 1;
            }
        }
        settled
    }
}
