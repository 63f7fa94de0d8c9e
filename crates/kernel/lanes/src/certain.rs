//! The sign of a formula for each query of a block, where it is certain.

#![allow(unsafe_code)]

use core::marker::PhantomData;

use predicament_predicates::{Sign, Vertex};

use crate::block::{BLOCK, Block, Numbers, Whole};
use crate::simd::{Kernel, dispatch};

/// The signs of a value of each query, and a bit mask of the queries that remain open.
///
/// `evaluate` returns the value and a bound: the sign is certain if the magnitude exceeds the bound. It gets the points
/// of a query, which are NaN for a vertex without a point, and the numbers of its vertices, which have the order of the
/// vertices. It is compiled for the widest registers of the machine and should not branch. The entry of an open query
/// in `out` has no meaning.
///
/// # Panics
/// If there are more than [`BLOCK`] queries, or fewer places for signs than queries.
#[inline]
pub fn signs_of<const D: usize, const N: usize>(
    points: &[[f64; D]],
    queries: &[[Vertex; N]],
    out: &mut [Sign],
    evaluate: impl Fn([[f64; D]; N], [f64; N]) -> (f64, f64),
) -> u64 {
    assert!(queries.len() <= BLOCK, "{} queries are more than {BLOCK}", queries.len());
    if queries.is_empty() {
        return 0;
    }
    dispatch(Of { points, queries, out: &mut out[..queries.len()], evaluate, dimension: PhantomData::<[(); D]> })
}

struct Of<'a, F, P, const D: usize, const N: usize> {
    points: &'a [[f64; D]],
    queries: &'a [[Vertex; N]],
    out: &'a mut [Sign],
    evaluate: F,
    dimension: PhantomData<P>,
}

impl<F, const D: usize, const N: usize> Kernel for Of<'_, F, [(); D], D, N>
where
    F: Fn([[f64; D]; N], [f64; N]) -> (f64, f64),
{
    type Output = u64;

    #[inline(always)]
    unsafe fn run<const WIDE: bool>(self) -> u64 {
        let Of { points, queries, out, evaluate, .. } = self;
        let mut block = Block::EMPTY;
        // SAFETY: the kernel runs wide only on processors with AVX-512F.
        unsafe { block.fetch::<Whole, D, WIDE>(points, queries) };
        let numbers = Numbers::of(queries);
        let (mut values, mut bounds) = ([0.0; BLOCK], [0.0; BLOCK]);
        for at in 0..BLOCK {
            (values[at], bounds[at]) = evaluate(block.query(at), numbers.query(at));
        }
        let (mut signs, mut open) = ([Sign::Zero; BLOCK], 0);
        for at in 0..BLOCK {
            signs[at] = if values[at] < 0.0 { Sign::Negative } else { Sign::Positive };
            // NaN is never certain.
            let certain = values[at].abs() > bounds[at];
            open |= u64::from(!certain) << at;
        }
        out.copy_from_slice(&signs[..queries.len()]);
        open & (u64::MAX >> (BLOCK - queries.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_and_what_is_open() {
        let points = [[1.0, 4.0], [2.0, -4.0], [3.0, 0.5], [5.0, 0.0]];
        let v = Vertex::input;
        // Every length, with blocks of eight and without; the last point, and a vertex without a point.
        for count in 0..=BLOCK {
            let query = |at: usize| match at % 5 {
                4 => [Vertex::constructed(at), v(1)],
                row => [v(row), v(1)],
            };
            let queries: Vec<[Vertex; 2]> = (0..count).map(query).collect();
            let mut out = vec![Sign::Zero; count];
            let open = signs_of(&points, &queries, &mut out, |[p, _], [number, _]| (p[1] * (number + 1.0), 1.75));
            for (at, sign) in out.into_iter().enumerate() {
                let certain = (open >> at & 1 == 0).then_some(sign);
                let expected = [Some(Sign::Positive), Some(Sign::Negative), None, None, None][at % 5];
                assert_eq!(certain, expected, "{at} of {count}");
            }
            assert!(count == BLOCK || open >> count == 0);
        }
    }

    #[test]
    #[should_panic(expected = "65 queries are more than 64")]
    fn too_many_are_refused() {
        signs_of(&[[0.0; 2]], &[[Vertex::input(0)]; 65], &mut [Sign::Zero; 65], |[p], _| (p[0], 0.0));
    }
}
