//! Determinants of differences in rationals, by the textbook's expansion along the last column.

use rug::Rational;

/// The coordinates of a point.
pub(super) type Point<'p> = &'p [Rational];

/// The vector p − q along these axes.
pub(super) fn minus<const D: usize>(p: Point, q: Point, axes: [usize; D]) -> [Rational; D] {
    axes.map(|axis| Rational::from(&p[axis] - &q[axis]))
}

/// The determinant of two rows.
pub(super) fn two([p, q]: [&[Rational]; 2]) -> Rational {
    Rational::from(&p[0] * &q[1]) - Rational::from(&p[1] * &q[0])
}

/// The determinant of three rows.
pub(super) fn three([p, q, r]: [&[Rational]; 3]) -> Rational {
    two([q, r]) * &p[2] - two([p, r]) * &q[2] + two([p, q]) * &r[2]
}

/// The determinant of four rows.
pub(super) fn four([p, q, r, s]: [&[Rational]; 4]) -> Rational {
    three([p, q, r]) * &s[3] - three([p, q, s]) * &r[3] + three([p, r, s]) * &q[3] - three([q, r, s]) * &p[3]
}

/// The vector with its squared length as one more coordinate.
pub(super) fn lifted<const D: usize>(vector: [Rational; D]) -> Vec<Rational> {
    let lift: Rational = vector.iter().map(|x| Rational::from(x * x)).sum();
    vector.into_iter().chain([lift]).collect()
}
