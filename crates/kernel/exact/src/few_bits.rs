//! Queries in which doubles make no error, found from their points alone.
//!
//! Figures of small whole numbers, each at a scale of its own, have no common unit that suits the whole scene. Within
//! one figure a determinant in doubles is exact nevertheless, if the differences are multiples of some unit and less
//! than 2^b units, with degree·b + growth ≤ 53: every intermediate is then an integer of at most 53 bits times a power
//! of the unit, see [`determinant`](crate::determinant). The check costs less than the conversion to integers.

// Loops over indices stay in registers, whereas `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::power_of_two;

use crate::predicate::Predicate;

/// Returns true if the determinant in doubles is certainly exact.
///
/// It is false if a coordinate is not finite, all points coincide, or a product could underflow or overflow.
#[inline(always)]
pub(crate) fn doubles_are_exact<P: Predicate<D, N>, const D: usize, const N: usize>(points: &[[f64; D]; N]) -> bool {
    let form = P::DETERMINANT.form;
    let bits = (53 - form.growth) / form.degree;
    // The order of magnitudes is the order of their bits.
    let mut largest = 0;
    for row in 0..N - 1 {
        for axis in 0..D {
            largest = largest.max((points[row][axis] - points[N - 1][axis]).abs().to_bits());
        }
    }
    #[allow(clippy::cast_possible_truncation)] // 11 bits
    let top = (largest >> 52) as i32 - 1022;
    // Differences, if they are not rounded, are less than 2^top, and multiples of the unit if they have so few bits.
    let unit = top - bits;
    if form.degree * unit < -1022 || form.degree * top + form.growth > 1023 {
        return false;
    }
    // A number of at most 2^51 units is added to 1.5·2^52 units without rounding if and only if it is a multiple.
    let (shifter, limit) = (3.0 * power_of_two(unit + 51), power_of_two(unit + 51));
    let mut multiples = true;
    for row in 0..N {
        for axis in 0..D {
            let x = points[row][axis];
            multiples &= ((x + shifter) - shifter == x) & (x.abs() <= limit);
        }
    }
    multiples
}

#[cfg(test)]
mod tests {
    use predicament_arithmetic::Sign;

    use super::*;
    use crate::predicate::{Incircle, Insphere, Orient2d, Orient3d};

    /// The check for points whose differences need `bits` bits, and one more bit somewhere.
    fn edge<P: Predicate<D, N>, const D: usize, const N: usize>(scale: f64) -> [bool; 2] {
        let form = P::DETERMINANT.form;
        let bits = (53 - form.growth) / form.degree;
        let mut points = [[scale; D]; N];
        points[0][0] += scale * (power_of_two(bits) - 1.0);
        let short = doubles_are_exact::<P, D, N>(&points);
        points[1][D - 1] += scale * 0.5;
        [short, doubles_are_exact::<P, D, N>(&points)]
    }

    #[test]
    fn as_many_bits_as_are_exact() {
        for scale in [1.0, power_of_two(-150), power_of_two(150)] {
            assert_eq!(edge::<Orient2d, 2, 3>(scale), [true, false]);
            assert_eq!(edge::<Orient3d, 3, 4>(scale), [true, false]);
            assert_eq!(edge::<Incircle, 2, 4>(scale), [true, false]);
            assert_eq!(edge::<Insphere, 3, 5>(scale), [true, false]);
        }
    }

    #[test]
    fn what_is_out_of_range_is_not_exact() {
        let exact =
            |corner: f64| doubles_are_exact::<Orient3d, 3, 4>(&[[corner, 0.0, 0.0], [0.0; 3], [0.0; 3], [0.0; 3]]);
        assert!(exact(1.0) && exact(power_of_two(300)) && exact(power_of_two(-300)));
        for corner in [0.0, -0.0, f64::NAN, f64::INFINITY, f64::MAX, 1e-110, 5e-324, power_of_two(350)] {
            assert!(!exact(corner), "{corner}");
        }
        // Half a unit, at the place where adding the shifter would not round it away.
        let far = -power_of_two(52) + 0.5;
        assert!(!doubles_are_exact::<Orient2d, 2, 3>(&[[far, power_of_two(25)], [far, 0.0], [far, 0.0]]));
    }

    /// Whatever is called exact has the sign of the exact stages, and many ties are found.
    #[test]
    fn exact_determinants_have_the_right_sign() {
        let mut state = 1_u64;
        let mut below = |n: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            i32::try_from((state >> 33) % n).expect("small")
        };
        let (mut found, mut ties) = (0, 0);
        for _ in 0..predicament_effort::scaled(20_000) {
            let (size, scale) = (1 << (2 + below(18)), power_of_two(below(200) - 100));
            let points: [[f64; 2]; 4] = core::array::from_fn(|_| [0; 2].map(|_| f64::from(below(size)) * scale));
            if doubles_are_exact::<Incircle, 2, 4>(&points) {
                let sign = Sign::of(Incircle::estimate(points).determinant);
                assert_eq!(sign, Incircle::dyadic(points), "{points:?}");
                found += 1;
                ties += usize::from(sign.is_zero());
            }
        }
        assert!(found > predicament_effort::scaled(8_000) && ties > 0, "{found}, {ties}");
    }
}
