//! Signs of determinants of rational points in floating point, where rounding cannot have changed them.
//!
//! Most triangles that are compared are far from a tie, and exact products of coordinates take most of a judge's time.
//!
//! # Bounds
//! Let M be the largest magnitude of a coordinate of the points, and D the largest computed difference of two of them.
//! A coordinate is rounded by 2^-52 of itself at most, so a difference is off by e = 2^-50·M: twice 2^-52·M, and its
//! own rounding.
//!
//! * An area has two products. Each is off by 2De + e² and one rounding, 2^-53·(D + e)²; the last sum adds 2^-52·(D +
//!   e)². All of it is below 2^3·(De + e²) + 2^-50·D².
//! * A volume has six products of three. Each is off by 3D²e + 3De² + e³, and goes through five roundings at most. All
//!   of it is below 2^5·(D²e + De² + e³) + 2^-47·D³.
//!
//! A product that underflows is off by 2^-1075, times D at most. That is far less than a bound above 2^-900, as the
//! bound of a volume has the cube of D. If a bound is less or not a number, exact numbers decide.

use std::cmp::Ordering;

use super::exact::Point;

/// The rounding of a difference, over the largest coordinate: 2^-50.
const DIFFERENCE: f64 = 4.0 * f64::EPSILON;
/// A bound that underflow cannot matter for: 2^-900.
const LEAST: f64 = f64::from_bits((1023 - 900) << 52);

/// Points rounded to doubles.
pub(super) struct Rounded(Vec<[f64; 3]>);

impl Rounded {
    pub(super) fn of(points: &[Point]) -> Rounded {
        Rounded(points.iter().map(|p| [0, 1, 2].map(|i| p[i].to_f64())).collect())
    }

    /// A rounded point.
    pub(super) fn point(&self, p: u32) -> [f64; 3] {
        self.0[p as usize]
    }

    /// The differences of points to the last one, the largest of them, and the error of each.
    fn differences<const N: usize>(&self, points: [u32; N]) -> ([[f64; 3]; N], f64, f64) {
        let all = points.map(|p| self.0[p as usize]);
        let by = all.map(|p| [0, 1, 2].map(|i| p[i] - all[N - 1][i]));
        let largest = |of: &[[f64; 3]; N]| of.as_flattened().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        (by, largest(&by), DIFFERENCE * largest(&all))
    }

    /// The sign of one component of the area vector of a triangle; `None` if rounding may have changed it.
    pub(super) fn area(&self, triangle: [u32; 3], axis: usize) -> Option<Ordering> {
        let ([u, v, _], d, e) = self.differences(triangle);
        let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
        certain(u[j] * v[k] - u[k] * v[j], 8.0 * (d * e + e * e) + DIFFERENCE * d * d)
    }

    /// The side of a point on the plane of a triangle; `None` if rounding may have changed it.
    pub(super) fn side(&self, [a, b, c]: [u32; 3], p: u32) -> Option<Ordering> {
        let ([u, v, w, _], d, e) = self.differences([a, b, c, p]);
        let minor = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let volume = w[0] * minor(1, 2) + w[1] * minor(2, 0) + w[2] * minor(0, 1);
        // (The normal is that of a, b, c, and u, v, w go from p to the triangle.)
        certain(-volume, 32.0 * (d * d * e + d * e * e + e * e * e) + 8.0 * DIFFERENCE * d * d * d)
    }
}

/// The sign of a value that is off by less than `bound`.
fn certain(value: f64, bound: f64) -> Option<Ordering> {
    (bound > LEAST && value.abs() > bound).then(|| value.total_cmp(&0.0))
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::super::exact::{Plane, normal};
    use super::*;

    /// Points with many bits, nearly in a plane or on a line, at the origin or far from it: rounded signs are those of
    /// rationals, and some are not certain.
    #[test]
    fn certain_signs_are_right_and_ties_are_not_certain() {
        let mut state = 7_u64;
        let mut next = |bound: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % bound
        };
        let mut counts = [[0; 2]; 2];
        for round in 0..2000_u32 {
            let scale = [1_u64, 1 << 20, 1 << 31][round as usize % 3];
            let far = Rational::from([0_u64, 1 << 40][round as usize / 3 % 2]);
            let mut points: Vec<Point> =
                (0..3).map(|_| [0, 1, 2].map(|_| Rational::from((next(scale) + 1, next(999) + 1)) + &far)).collect();
            // The centre of the triangle or of one side, or that and a little more.
            let tiny = Rational::from((next(3), 1_u64 << (next(63) + 1)));
            for of in [3_u32, 2] {
                points.push([0, 1, 2].map(|i| {
                    let sum: Rational = points.iter().take(of as usize).map(|point| &point[i]).sum();
                    sum / of + &tiny * Rational::from(i + 1)
                }));
            }
            let rounded = Rounded::of(&points);
            let [a, b, c, p, q] = [0, 1, 2, 3, 4].map(|i| &points[i]);
            let plane = Plane::of([a, b, c]);
            let sides = [(3, p), (4, q)].map(|(at, p)| (rounded.side([0, 1, 2], at), plane.side(p)));
            let areas = [0, 1].map(|axis| (rounded.area([0, 1, 4], axis), normal([a, b, q])[axis].cmp0()));
            for (of, count) in [sides, areas].into_iter().zip(&mut counts) {
                for (found, truth) in of {
                    assert!(found.is_none_or(|sign| sign == truth), "{points:?}");
                    count[usize::from(found.is_some())] += 1;
                }
            }
        }
        assert!(counts.iter().all(|[open, certain]| *open > 300 && *certain > 300), "{counts:?}");
    }

    #[test]
    fn numbers_out_of_range_are_not_certain() {
        for power in [-320_i32, 400] {
            let at =
                |x: i32| if power < 0 { Rational::from(x) >> power.unsigned_abs() } else { Rational::from(x) << power };
            let points: Vec<Point> =
                [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|p| p.map(at)).into_iter().collect();
            assert_eq!(Rounded::of(&points).side([0, 1, 2], 3), None);
        }
    }
}
