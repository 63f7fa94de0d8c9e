//! The ties of a block, for backends that break them: on points that have been fetched.

#![allow(clippy::needless_range_loop)]

use predicament_lanes::{BLOCK, Block, Numbers};
use predicament_predicates::{Sign, Vertex};

/// The least number of ties in a block for which vector registers pay off.
pub(super) const MANY: u32 = 8;

/// The method that breaks ties, if any does.
pub trait Ties<const D: usize, const N: usize> {
    /// False if ties remain zero.
    const BREAKS: bool;

    /// A number with the sign of a tie; zero or NaN if it remains open.
    ///
    /// The numbers of the vertices have their order. The method is called for queries that are no ties as well, and
    /// for points that are not finite. It should not branch, and must be `#[inline(always)]` to run on wide registers.
    fn sign(&self, points: [[f64; D]; N], numbers: [f64; N]) -> f64;
}

/// Ties remain zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Unbroken;

impl<const D: usize, const N: usize> Ties<D, N> for Unbroken {
    const BREAKS: bool = false;

    fn sign(&self, _: [[f64; D]; N], _: [f64; N]) -> f64 {
        0.0
    }
}

/// The breaking of all ties of a block.
pub(super) trait BreakZeros<const D: usize, const N: usize>: Ties<D, N> {
    /// Replaces the zeros in `out` that the method decides.
    #[inline(always)]
    fn break_zeros(&self, block: &Block<D, N>, queries: &[[Vertex; N]], out: &mut [Sign]) {
        let numbers = Numbers::of(queries);
        let mut values = [0.0; BLOCK];
        for at in 0..BLOCK {
            values[at] = self.sign(block.query(at), numbers.query(at));
        }
        for (sign, value) in out.iter_mut().zip(values) {
            let broken = if value > 0.0 {
                Sign::Positive
            } else if value < 0.0 {
                Sign::Negative
            } else {
                Sign::Zero
            };
            *sign = if *sign == Sign::Zero { broken } else { *sign };
        }
    }
}

impl<T: Ties<D, N>, const D: usize, const N: usize> BreakZeros<D, N> for T {}
