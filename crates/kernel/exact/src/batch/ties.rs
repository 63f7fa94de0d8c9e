//! The ties of a block, for backends that break them: on points that have been fetched.

#![allow(clippy::needless_range_loop)]

use predicament_lanes::{BLOCK, Block};
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
pub struct Unbroken;

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
        let mut numbers = [[0.0; BLOCK]; N];
        for (at, query) in queries.iter().enumerate() {
            for row in 0..N {
                #[allow(clippy::cast_precision_loss)] // 32 bits
                let number = query[row].index() as f64;
                numbers[row][at] = number;
            }
        }
        let mut values = [0.0; BLOCK];
        for at in 0..BLOCK {
            let mut query = [0.0; N];
            for row in 0..N {
                query[row] = numbers[row][at];
            }
            values[at] = self.sign(block.query(at), query);
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
