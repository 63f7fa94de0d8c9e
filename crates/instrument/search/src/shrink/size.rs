//! The size of a scene, which shrinking reduces.

use predicament_corpus::{Items, Spelled};
use predicament_formats::bits::lowest_bit;

/// The size of a scene that is written out: first its pieces, then the cost of its coordinates.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Size {
    /// The number of points, constructions, items and everything that these name or hold.
    pub pieces: usize,
    /// The cost of all coordinates: bits of significands, bits of exponents, minus signs.
    pub digits: u64,
}

impl Size {
    /// Computes the size of a scene.
    #[must_use]
    pub fn of(spelled: &Spelled) -> Size {
        let of_lists: usize = spelled.lists.iter().map(|list| items(&list.items)).sum();
        let of_points: usize = spelled.points.iter().map(|point| 1 + point.len()).sum();
        let of_constructions: usize = spelled.constructions.iter().map(|one| 1 + one.flats().flatten().count()).sum();
        let digits = spelled.rows().into_iter().flatten().map(|&x| cost(x)).sum();
        Size { pieces: of_points + of_constructions + of_lists, digits }
    }
}

fn items(items: &Items) -> usize {
    match items {
        Items::Vertices(all) => all.len(),
        Items::Tuples(all) | Items::Loops(all) | Items::Labelled { tuples: all, .. } => {
            all.iter().map(|one| 1 + one.len()).sum()
        }
        Items::Rows(all) => all.iter().map(|one| 1 + one.len()).sum(),
        Items::Polygons(all) => {
            all.iter().map(|rings| 1 + rings.iter().map(|ring| 1 + 3 * ring.len()).sum::<usize>()).sum()
        }
    }
}

/// The cost of a coordinate: 0 for zero, otherwise the bits of its odd significand, the bits of its exponent, and one
/// for a minus sign.
#[must_use]
pub fn cost(x: f64) -> u64 {
    let Some(lowest) = lowest_bit(x) else { return u64::from(x.is_sign_negative()) };
    let highest = i64::from(exponent(x));
    let significand = (highest - lowest).unsigned_abs() + 1;
    let of_exponent = 64 - lowest.unsigned_abs().leading_zeros();
    significand + u64::from(of_exponent) + u64::from(x < 0.0)
}

/// The value floor(log2 |x|) of a nonzero number.
pub(super) fn exponent(x: f64) -> i32 {
    let bits = x.to_bits() << 1 >> 1;
    match i32::try_from(bits >> 52).unwrap_or(0) {
        0 => -1074 + 63 - i32::try_from(bits.leading_zeros()).unwrap_or(63),
        biased => biased - 1023,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simpler_numbers_cost_less() {
        assert_eq!([0.0, 1.0, -1.0, 2.0, 0.5, 3.0].map(cost), [0, 1, 2, 2, 2, 2]);
        assert_eq!(cost(f64::from_bits(1)), 1 + 11);
        assert_eq!(cost(-0.0), 1);
        assert!(cost(0.1) > cost(0.125) && cost(f64::MAX) > cost(1e300) - 60);
        assert_eq!([1.0, 1.5, 4.0, f64::from_bits(1), f64::MIN_POSITIVE].map(exponent), [0, 0, 2, -1074, -1022]);
    }
}
