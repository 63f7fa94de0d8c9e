//! The sign of a formula for each query of a batch, without a certificate.

#![allow(unsafe_code)]
// Loops over indices stay in registers.
#![allow(clippy::needless_range_loop)]

use core::marker::PhantomData;

use predicament_predicates::{Sign, Vertex};

use crate::block::{BLOCK, Block, View};
use crate::simd::{Kernel, dispatch};

/// Answers all queries of a batch by the sign of `evaluate` on the points of the query; NaN gives zero.
///
/// The points are seen in the view `V`. `evaluate` is compiled for the widest registers of the machine, and should not
/// branch.
///
/// `elsewhere` answers queries with a vertex that has no point in `points`, one by one.
#[inline]
pub fn answer<V: View<E, D>, const E: usize, const D: usize, const N: usize>(
    points: &[[f64; E]],
    queries: &[[Vertex; N]],
    out: &mut [Sign],
    evaluate: impl Fn([[f64; D]; N]) -> f64,
    elsewhere: impl Fn([Vertex; N]) -> Sign,
) {
    dispatch(Of { points, queries, out, evaluate, elsewhere, view: PhantomData::<(V, [(); D])> });
}

struct Of<'a, F, L, P, const E: usize, const N: usize> {
    points: &'a [[f64; E]],
    queries: &'a [[Vertex; N]],
    out: &'a mut [Sign],
    evaluate: F,
    elsewhere: L,
    view: PhantomData<P>,
}

impl<V, F, L, const E: usize, const D: usize, const N: usize> Kernel for Of<'_, F, L, (V, [(); D]), E, N>
where
    V: View<E, D>,
    F: Fn([[f64; D]; N]) -> f64,
    L: Fn([Vertex; N]) -> Sign,
{
    type Output = ();

    #[inline(always)]
    unsafe fn run<const WIDE: bool>(self) {
        let Of { points, queries, out, evaluate, elsewhere, .. } = self;
        let mut block = Block::EMPTY;
        for (queries, out) in queries.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            // SAFETY: the kernel runs wide only on processors with AVX-512F.
            let all_have_points = unsafe { block.fetch::<V, E, WIDE>(points, queries) };
            let mut values = [0.0; BLOCK];
            for at in 0..BLOCK {
                values[at] = evaluate(block.query(at));
            }
            let mut signs = [Sign::Zero; BLOCK];
            for at in 0..BLOCK {
                signs[at] = if values[at] > 0.0 {
                    Sign::Positive
                } else if values[at] < 0.0 {
                    Sign::Negative
                } else {
                    Sign::Zero
                };
            }
            out.copy_from_slice(&signs[..queries.len()]);
            // (A NaN value does not prove a missing point: finite points can give NaN.)
            if !all_have_points {
                for (query, out) in queries.iter().zip(out) {
                    if query.iter().any(|v| v.index() >= points.len()) {
                        *out = elsewhere(*query);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::block::{Whole, Zx};
    use crate::simd::{Width, run_on};

    const POINTS: usize = 30;

    /// A formula whose result depends on the order of its operations.
    fn formula([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
        a * d - b * c + (a - c)
    }

    fn check<V: View<E, 2>, const E: usize>(points: &[[f64; E]], vertices: &[Vertex]) {
        let queries = vertices.as_chunks::<2>().0;
        let one = |query: &[Vertex; 2]| {
            let seen = query.map(|v| points.get(v.index()).map(|point| V::see(*point)));
            let [Some(p), Some(q)] = seen else { return Sign::Zero };
            Sign::of(formula([p, q]))
        };
        let expected: Vec<Sign> = queries.iter().map(one).collect();
        for width in Width::ALL.into_iter().filter(|width| width.is_available()) {
            let mut out = vec![Sign::Zero; queries.len()];
            let elsewhere = |_| Sign::Zero;
            let view = PhantomData::<(V, [(); 2])>;
            run_on(width, Of { points, queries, out: &mut out, evaluate: formula, elsewhere, view });
            assert_eq!(out, expected, "{width:?}");
        }
    }

    proptest! {
        #[test]
        fn every_width_answers_as_one_query_at_a_time(
            points in prop::collection::vec(prop::array::uniform3(-1.0..1.0_f64), POINTS),
            // The last few vertices have no points.
            vertices in prop::collection::vec((0..POINTS + 2).prop_map(Vertex::input), 0..400),
        ) {
            // Memory ends at the last point, where a checker of memory sees a read beyond it.
            let flat: Box<[[f64; 2]]> = points.iter().map(|[x, y, _]| [*x, *y]).collect();
            let points = points.into_boxed_slice();
            let with_points: Vec<Vertex> = vertices.iter().copied().filter(|v| v.index() < POINTS).collect();
            for vertices in [vertices, with_points] {
                check::<Zx, 3>(&points, &vertices);
                check::<Whole, 2>(&flat, &vertices);
            }
        }
    }
}
