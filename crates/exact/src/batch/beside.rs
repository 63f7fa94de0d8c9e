//! Many points beside one line or plane.

#![allow(unsafe_code)]

use std::marker::PhantomData;

use predicament_predicates::{Sign, Vertex};

use super::block::{BLOCK, Block, View};
use super::simd::{Kernel, dispatch};
use super::{filter, ones};
use crate::side::Side;

/// Points beside one line or plane, and what to do about them.
pub(crate) struct Beside<'a, S, C, const E: usize, const D: usize> {
    /// The line or plane.
    pub side: Side<D>,
    /// The magnitude from which on a determinant is certain.
    pub bound: f64,
    /// The points of the vertices. With what has none nothing is certain, and
    /// the vertex is seen to where it climbs.
    pub points: &'a [[f64; E]],
    /// Which points are asked about.
    pub vertices: &'a [Vertex],
    /// A place for each answer.
    pub out: &'a mut [Sign],
    /// Told how many vertices of a block the filter has settled.
    pub settled: S,
    /// Answers for a vertex that it leaves open.
    pub climb: C,
}

/// Answers for all vertices, whose points are seen in this view.
#[inline]
pub(crate) fn run_beside<V: View<E, D>, const E: usize, const D: usize>(
    beside: Beside<'_, impl Fn(u64), impl Fn(Vertex) -> Sign, E, D>,
) {
    dispatch(Of { beside, view: PhantomData::<V> });
}

/// Points seen in a view.
pub(super) struct Of<B, V> {
    pub beside: B,
    pub view: PhantomData<V>,
}

impl<V, S, C, const E: usize, const D: usize> Kernel for Of<Beside<'_, S, C, E, D>, V>
where
    V: View<E, D>,
    S: Fn(u64),
    C: Fn(Vertex) -> Sign,
{
    type Output = ();

    #[inline(always)]
    unsafe fn run<const WIDE: bool>(self) {
        let Beside { side, bound, points, vertices, out, settled, climb } = self.beside;
        let mut block = Block::EMPTY;
        for (vertices, out) in vertices.as_chunks::<1>().0.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            // SAFETY: the kernel is run wide where the processor has AVX-512F.
            unsafe { block.fetch::<V, E, WIDE>(points, vertices) };
            let (signs, open) = filter(&block, |[point]| (side.determinant(point), bound));
            let open = open & (u64::MAX >> (BLOCK - vertices.len()));
            out.copy_from_slice(&signs[..vertices.len()]);
            settled(vertices.len() as u64 - u64::from(open.count_ones()));
            for at in ones(open) {
                out[at] = climb(vertices[at][0]);
            }
        }
    }
}
