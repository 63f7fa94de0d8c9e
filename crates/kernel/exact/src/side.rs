//! Many points against one line or plane: their common terms are computed once.
//!
//! Rows are relative to the first point of the line or plane, not to the last point of the query. All but one row of
//! the determinant then belong to the line or plane alone. Expanded along the remaining row, the determinant is the
//! product of a normal with a difference.
//!
//! # The filter
//! Terms go through as many roundings as those of `estimate::orient2d` and `orient3d`, so their constants hold here
//! too: three terms of seven roundings, of which the last sum costs nothing and the one before counts half. The
//! permanent uses the extents of the scene for the difference: one bound serves all points. It is at most that of the
//! static filter, so open determinants are as small as there.

// Loops over indices stay in registers, whereas `map` on arrays goes through memory.
#![allow(clippy::needless_range_loop)]

use predicament_arithmetic::Number;

use crate::estimate::Estimate;

/// A line in the plane, or a plane in space, directed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Side<const D: usize, T = f64> {
    /// The vector that differences to the pivot are multiplied with.
    pub normal: [T; D],
    /// A point of the line or plane.
    pub pivot: [T; D],
    /// An upper bound of the permanent of any point of the scene.
    pub permanent: T,
}

impl<const D: usize, T: Number> Side<D, T> {
    /// The determinant of a point against the line or plane.
    #[inline(always)]
    #[must_use]
    pub fn determinant(&self, p: [T; D]) -> T {
        let mut sum = self.normal[0] * (self.pivot[0] - p[0]);
        for axis in 1..D {
            sum = sum + self.normal[axis] * (self.pivot[axis] - p[axis]);
        }
        sum
    }
}

impl<T: Number> Side<2, T> {
    /// The side of the line from a to b: positive to its left.
    ///
    /// `extent` is that of the scene's axes.
    #[must_use]
    pub fn of_line([a, b]: [[T; 2]; 2], extent: [T; 2]) -> Side<2, T> {
        let normal = [b[1] - a[1], a[0] - b[0]];
        let permanent = normal[0].abs() * extent[0] + normal[1].abs() * extent[1];
        Side { normal, pivot: a, permanent }
    }
}

impl<T: Number> Side<3, T> {
    /// The side of the plane of a, b and c: positive below it, where they are seen clockwise.
    ///
    /// `extent` is that of the scene's axes.
    #[must_use]
    pub fn of_plane([a, b, c]: [[T; 3]; 3], extent: [T; 3]) -> Side<3, T> {
        let row = |p: [T; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
        let (b, c) = (row(b), row(c));
        let minor = |i: usize, j: usize| {
            let (left, right) = (b[i] * c[j], b[j] * c[i]);
            Estimate { determinant: left - right, permanent: left.abs() + right.abs() }
        };
        let minors = [minor(1, 2), minor(2, 0), minor(0, 1)];
        let [x, y, z] = minors.map(|minor| minor.permanent);
        let permanent = x * extent[0] + y * extent[1] + z * extent[2];
        Side { normal: minors.map(|minor| minor.determinant), pivot: a, permanent }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Differences from 1, 2, 3 and sums by hand, in small integers that differ in each place.
    #[test]
    fn normals_and_permanents_by_hand() {
        let line = Side::of_line([[1.0, 2.0], [6.0, 13.0]], [3.0, 7.0]);
        assert_eq!((line.normal, line.pivot), ([11.0, -5.0], [1.0, 2.0]));
        assert_eq!(line.permanent, 11.0 * 3.0 + 5.0 * 7.0);
        assert_eq!(line.determinant([1.0, 3.0]), 5.0, "to the left");

        // b − a is (2, 3, 5) and c − a is (7, −11, 13).
        let plane = Side::of_plane([[1.0, 2.0, 3.0], [3.0, 5.0, 8.0], [8.0, -9.0, 16.0]], [17.0, 19.0, 23.0]);
        assert_eq!(plane.normal, [3.0 * 13.0 + 5.0 * 11.0, 5.0 * 7.0 - 2.0 * 13.0, -2.0 * 11.0 - 3.0 * 7.0]);
        assert_eq!(plane.pivot, [1.0, 2.0, 3.0]);
        let minors = [3.0 * 13.0 + 5.0 * 11.0, 5.0 * 7.0 + 2.0 * 13.0, 2.0 * 11.0 + 3.0 * 7.0];
        assert_eq!(plane.permanent, minors[0] * 17.0 + minors[1] * 19.0 + minors[2] * 23.0);
        assert_eq!(plane.determinant([2.0, 4.0, 6.0]), -94.0 - 2.0 * 9.0 + 3.0 * 43.0);
    }
}
