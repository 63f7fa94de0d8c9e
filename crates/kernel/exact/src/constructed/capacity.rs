//! Upper bounds on the limbs that computations about constructed vertices need.
//!
//! Accumulators are arrays on the stack, zeroed before use: a few limbs for ordinary coordinates, a thousand if
//! exponents span the whole range of doubles.

/// The largest capacity, which suffices for all vertices whose lines and planes go through input vertices.
///
/// Coordinates of one scene span 2098 bits, so with the alignment of [`Rows`](super::rows::Rows) they are multiples of
/// 2^(64·l) with l ≥ −32 and span 33 limbs. The rows of [`points`](super::points) have degree 7 at most: they end at
/// limb −7·32 and begin below limb 7. Four of them span 924 limbs, three of them and three times an input vertex 792.
pub(super) const LARGEST: usize = 1024;
const _: () = assert!(4 * (7 * 32 + 7) < LARGEST && 3 * (7 * 32 + 7) + 3 * 33 < LARGEST);

/// Evaluates an expression with a capacity constant: the least capacity for the number of limbs.
macro_rules! with_capacity {
    ($limbs:expr, $capacity:ident => $value:expr) => {
        match $limbs {
            0..=9 => {
                const $capacity: usize = 9;
                $value
            }
            10..=18 => {
                const $capacity: usize = 18;
                $value
            }
            19..=36 => {
                const $capacity: usize = 36;
                $value
            }
            37..=128 => {
                const $capacity: usize = 128;
                $value
            }
            _ => {
                const $capacity: usize = $crate::constructed::capacity::LARGEST;
                $value
            }
        }
    };
}
