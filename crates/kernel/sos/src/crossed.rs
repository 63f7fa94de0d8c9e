//! The sign of a component of a cross product of two differences of points.

use predicament_predicates::{Scene, Sign, Vertex};

use crate::whole;

/// The sign of ((q − p) × (v − u)) along an axis of a scene in space, exactly.
///
/// A filter decides first. Let u = 2^-53. A difference, a product and the last difference are each rounded by a
/// relative u at most, so the error is below 4·(1 + u)^3·u times the sum of both products' magnitudes. If this sum
/// overflows, or is so small that a product may have underflowed, integers of any length decide.
#[inline]
pub(crate) fn along(scene: &Scene, axis: usize, [p, q]: [Vertex; 2], [u, v]: [Vertex; 2]) -> Sign {
    let [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
    let points = scene.coordinates().as_chunks::<3>().0;
    let [p, q, u, v] = [points[p.index()], points[q.index()], points[u.index()], points[v.index()]];
    let filtered = filtered([q[i] - p[i], v[j] - u[j]], [q[j] - p[j], v[i] - u[i]]);
    filtered.unwrap_or_else(|| exactly([[q[i], p[i]], [v[j], u[j]]], [[q[j], p[j]], [v[i], u[i]]]))
}

/// The sign of a product of two rounded differences minus another; `None` if rounding may have changed it.
#[inline(always)]
fn filtered(first: [f64; 2], second: [f64; 2]) -> Option<Sign> {
    // A difference of doubles is zero only if it is exactly zero, and so are factors of a product.
    match [is_zero(first), is_zero(second)] {
        [true, true] => return Some(Sign::Zero),
        [true, false] => return Some(-sign_of(second)),
        [false, true] => return Some(sign_of(first)),
        [false, false] => {}
    }
    let [left, right] = [first, second].map(|[a, b]| a * b);
    let (difference, size) = (left - right, left.abs() + right.abs());
    // 8·u is twice what is needed; 2^-900 is far above the error of a product that underflows, over u.
    let is_certain = size > SMALLEST && difference.abs() > size * (4.0 * f64::EPSILON);
    is_certain.then_some(if difference > 0.0 { Sign::Positive } else { Sign::Negative })
}

/// The number 2^-900.
const SMALLEST: f64 = f64::from_bits((1023 - 900) << 52);

/// The exact sign of a product of two differences minus another.
#[cold]
#[inline(never)]
fn exactly(first: [[f64; 2]; 2], second: [[f64; 2]; 2]) -> Sign {
    let [[[q, p], [v, u]], [[s, r], [y, x]]] = [first, second];
    let [q, p, v, u, s, r, y, x] = whole::integers([q, p, v, u, s, r, y, x]);
    let left = &(&q - &p) * &(&v - &u);
    let right = &(&s - &r) * &(&y - &x);
    (&left - &right).cmp0().into()
}

fn is_zero([a, b]: [f64; 2]) -> bool {
    a == 0.0 || b == 0.0
}

fn sign_of([a, b]: [f64; 2]) -> Sign {
    if (a > 0.0) == (b > 0.0) { Sign::Positive } else { Sign::Negative }
}

#[cfg(test)]
mod tests {
    use predicament_predicates::Dimension;
    use rug::Rational;

    use super::*;

    /// Digits of a linear congruential generator: the test is the same each time.
    struct Digits(u64);

    impl Digits {
        fn below(&mut self, n: u64) -> u64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 33) % n
        }

        /// A random integer from -n to n, exactly representable.
        fn integer(&mut self, n: u32) -> f64 {
            f64::from(u32::try_from(self.below(2 * u64::from(n) + 1)).unwrap()) - f64::from(n)
        }
    }

    /// The true sign, by rationals alone.
    fn truth(points: &[[f64; 3]; 4], axis: usize) -> Sign {
        let [p, q, u, v] = points.map(|point| point.map(|x| Rational::from_f64(x).unwrap()));
        let [a, b] =
            [[&p, &q], [&u, &v]].map(|[from, to]| [0, 1, 2].map(|axis| Rational::from(&to[axis] - &from[axis])));
        let crossed = match axis {
            0 => Rational::from(&a[1] * &b[2]) - Rational::from(&a[2] * &b[1]),
            1 => Rational::from(&a[2] * &b[0]) - Rational::from(&a[0] * &b[2]),
            _ => Rational::from(&a[0] * &b[1]) - Rational::from(&a[1] * &b[0]),
        };
        crossed.cmp0().into()
    }

    /// Compares the sign with the truth, and counts each sign.
    fn agree(points: [[f64; 3]; 4], seen: &mut [usize; 3]) {
        let scene = Scene::new(Dimension::Three, points.as_flattened().to_vec()).unwrap();
        let [p, q, u, v] = [0, 1, 2, 3].map(Vertex::input);
        for axis in 0..3 {
            let found = along(&scene, axis, [p, q], [u, v]);
            assert_eq!(found, truth(&points, axis), "axis {axis} of {points:?}");
            seen[match found {
                Sign::Negative => 0,
                Sign::Zero => 1,
                Sign::Positive => 2,
            }] += 1;
        }
    }

    #[test]
    fn components_are_those_of_rationals() {
        let (mut digits, mut seen) = (Digits(1), [0; 3]);
        for _ in 0..2_000 {
            // Small integers: products of zeros, parallels, and all the rest.
            agree([(); 4].map(|()| [(); 3].map(|()| digits.integer(2))), &mut seen);
        }
        assert!(seen.iter().all(|&count| count > 500), "{seen:?}");
    }

    #[test]
    fn nearly_parallel_differences_are_told_apart() {
        let (mut digits, mut seen) = (Digits(2), [0; 3]);
        for round in 0..2_000 {
            // Multiples of one another except for the last bits, at all scales; at some scales the products leave the
            // range.
            let scale = f64::from_bits([1023, 1023 - 700, 1023 + 600, 60][round % 4] << 52);
            let d = [(); 3].map(|()| digits.integer(1 << 26));
            let times = digits.integer(3);
            let mut near = d.map(|x| x * times + digits.integer(1));
            if round % 3 == 0 {
                near = d.map(|x| x * times);
            }
            let points = [[0.0; 3], d, [0.0; 3], near].map(|point| point.map(|x| x * scale));
            agree(points, &mut seen);
        }
        assert!(seen.iter().all(|&count| count > 500), "{seen:?}");
    }

    #[test]
    fn the_filter_is_certain_where_rounding_is_small() {
        use Sign::{Negative, Positive, Zero};
        let (e, tiny) = (f64::EPSILON, f64::from_bits(1));
        for (first, second, sign) in [
            ([3.0, 2.0], [1.0, 5.0], Some(Positive)),
            ([1.0, 5.0], [3.0, 2.0], Some(Negative)),
            ([3.0, -2.0], [1.0, 5.0], Some(Negative)),
            ([3.0, -2.0], [-1.0, 7.0], Some(Positive)),
            ([0.0, 2.0], [1.0, 0.0], Some(Zero)),
            ([0.0, 2.0], [1.0, 5.0], Some(Negative)),
            ([tiny, tiny], [0.0, 5.0], Some(Positive)),
            ([-tiny, tiny], [5.0, 0.0], Some(Negative)),
            ([0.0, 5.0], [tiny, -tiny], Some(Positive)),
            // Differences of twelve and of four times the possible error of the products' sum.
            ([1.0 + 12.0 * e, 1.0], [1.0, 1.0], Some(Positive)),
            ([1.0, 1.0], [1.0 + 12.0 * e, 1.0], Some(Negative)),
            ([1.0 + 4.0 * e, 1.0], [1.0, 1.0], None),
            ([1.0, 1.0], [1.0, 1.0], None),
            // Just above the floor, and just below it.
            ([SMALLEST, 1.5], [SMALLEST, -0.5], Some(Positive)),
            ([SMALLEST, 0.5], [SMALLEST, -0.25], None),
            // Products that overflow.
            ([f64::MAX, 2.0], [f64::MAX, 1.0], None),
        ] {
            assert_eq!(filtered(first, second), sign, "{first:?} {second:?}");
        }
        assert_eq!(SMALLEST * SMALLEST.recip(), 1.0);
        assert_eq!(SMALLEST.log2(), -900.0);
    }
}
