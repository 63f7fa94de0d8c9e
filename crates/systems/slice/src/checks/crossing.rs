//! Checks for edges of a part that pass through its triangles.

use std::cell::OnceCell;
use std::cmp::Ordering;

use predicament_judge::boxes::{Boxes, Extent, extent};

use super::exact::Point;
use super::homogeneous::{Plane, Rows};
use super::rounded::Rounded;
use super::{Check, Expected, Flaws, Part, Piece, Slices};

impl Slices {
    /// Compares triangles of each part with those near them: they may touch, but not pass through each other. Covers of
    /// open loops are not planar and may pass through anything.
    pub(super) fn crossings(&self, near: &Near<'_>, expected: Expected, flaws: &mut Flaws) {
        let step = self.triangles().div_ceil(expected.triangles_crossed.max(1)).max(1);
        let mut number = 0;
        for (at, part) in self.parts.iter().enumerate() {
            let Some((index, reach)) = near.index(part) else { continue };
            let mut others = Vec::new();
            for (place, &triangle) in part.triangles.iter().enumerate() {
                number += 1;
                if number % step != 0 || part.pieces[place] == Piece::Cover {
                    continue;
                }
                index.near(&index.all()[place], reach, &mut others);
                let plane = near.across(triangle);
                for other in others.iter().map(|&other| other as usize) {
                    if other == place || part.pieces[other] == Piece::Cover {
                        continue;
                    }
                    let other = part.triangles[other];
                    if near.pass(&plane, other, expected) {
                        flaws.add(Check::SelfIntersection, &[triangle, other].concat(), || {
                            format!("two triangles of part {at} pass through each other")
                        });
                    }
                }
            }
        }
    }
}

/// Points of triangles near each other: rounded, and as integers where rounding may have changed a sign.
pub(super) struct Near<'a> {
    rounded: Rounded,
    pub(super) rows: Rows<'a>,
}

impl<'a> Near<'a> {
    pub(super) fn of(points: &'a [Point]) -> Near<'a> {
        Near { rounded: Rounded::of(points), rows: Rows::of(points) }
    }

    /// The boxes of the triangles, and a bound on their error.
    fn index(&self, part: &Part) -> Option<(Boxes<3>, f64)> {
        let mut largest = 0.0_f64;
        let boxes = part.triangles.iter().map(|triangle| {
            let points = triangle.map(|p| self.rounded.point(p));
            points.as_flattened().iter().for_each(|x| largest = largest.max(x.abs()));
            extent(points)
        });
        let boxes: Vec<Extent<3>> = boxes.collect();
        // The relative rounding error of coordinates is below 2^-52.
        (!boxes.is_empty()).then(|| (Boxes::new(boxes), largest * 2.0_f64.powi(-50)))
    }

    /// Records a triangle without area.
    pub(super) fn needs_area(&self, triangle: [u32; 3], flaws: &mut Flaws) {
        let is_certain = |axis| self.rounded.area(triangle, axis).is_some();
        if !(0..3).any(is_certain) && self.rows.plane(triangle).axis().is_none() {
            flaws.add(Check::Degenerate, &triangle, || "a triangle has no area".to_owned());
        }
    }

    /// True if an edge of one triangle passes through the inside of the other, or edges of both cross in a common
    /// plane. Faces of a part without volume may lie on each other; breaking ties makes such parts.
    fn pass(&self, plane: &Across<'_>, second: [u32; 3], expected: Expected) -> bool {
        let first = plane.corners;
        if first.iter().all(|p| second.contains(p)) {
            return false;
        }
        let of_second = second.map(|p| plane.side(p));
        if of_second == [Ordering::Equal; 3] {
            return expected.has_areas && self.overlap(plane, second, expected.may_stand);
        }
        // A triangle on one side of the plane has no inner point in the plane.
        if !(of_second.contains(&Ordering::Less) && of_second.contains(&Ordering::Greater)) {
            return false;
        }
        let other = self.across(second);
        let of_first = first.map(|p| other.side(p));
        let pierces = |edges: [u32; 3], sides: [Ordering; 3], triangle: [u32; 3]| {
            (0..3).any(|i| {
                let j = (i + 1) % 3;
                let through = sides[i] != Ordering::Equal && sides[i] == sides[j].reverse();
                through && self.is_inside([edges[i], edges[j]], triangle)
            })
        };
        pierces(second, of_second, first) || pierces(first, of_first, second)
    }

    /// The side of a point on the plane of a triangle; the triangle's own corners are on it.
    fn side_of(&self, corners: [u32; 3], p: u32) -> Ordering {
        self.across(corners).side(p)
    }

    /// The plane of three points.
    pub(super) fn across(&self, corners: [u32; 3]) -> Across<'_> {
        Across { near: self, corners, plane: OnceCell::new() }
    }

    /// True if the line through an edge meets the inside of a triangle.
    fn is_inside(&self, [p, q]: [u32; 2], [a, b, c]: [u32; 3]) -> bool {
        let turns = [[a, b], [b, c], [c, a]].map(|[x, y]| self.side_of([p, q, x], y));
        turns[0] != Ordering::Equal && turns == [turns[0]; 3]
    }

    /// True if edges of two triangles in one plane cross, or a corner of one is inside the other, unless they may lie
    /// on each other: see [`Expected::may_stand`].
    ///
    /// Along any axis along which the plane's normal is not zero, all turns are those in the plane, or all are turned
    /// over, and turns are only compared with each other.
    fn overlap(&self, plane: &Across<'_>, second: [u32; 3], may_stand: bool) -> bool {
        let first = plane.corners;
        let seen = (0..3).find(|&axis| self.rounded.area(first, axis).is_some());
        let Some(axis) = seen.or_else(|| plane.plane().axis()) else { return false };
        let turn = |[a, b]: [u32; 2], c: u32| {
            let exact = || self.rows.area([a, b, c], axis);
            if c == a || c == b { Ordering::Equal } else { self.rounded.area([a, b, c], axis).unwrap_or_else(exact) }
        };
        let looks = |[a, b, c]: [u32; 3]| turn([a, b], c);
        let has_edge = first.iter().filter(|p| second.contains(p)).count() == 2;
        if may_stand && !has_edge && looks(first) == looks(second).reverse() {
            return false;
        }
        let opposite = |x: Ordering, y: Ordering| x != Ordering::Equal && x == y.reverse();
        let edges = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]];
        // The turns of one triangle's corners by each edge of the other.
        let of = |triangle: [u32; 3], points: [u32; 3]| edges(triangle).map(|edge| points.map(|p| turn(edge, p)));
        let (by_first, by_second) = (of(first, second), of(second, first));
        let is_in = |turns: &[[Ordering; 3]; 3], at: usize| {
            let of_point = turns.map(|by_edge| by_edge[at]);
            of_point[0] != Ordering::Equal && of_point == [of_point[0]; 3]
        };
        if (0..3).any(|at| is_in(&by_first, at) || is_in(&by_second, at)) {
            return true;
        }
        let pairs = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
        let next = |i: usize| (i + 1) % 3;
        pairs.into_iter().any(|(i, j)| {
            opposite(by_first[i][j], by_first[i][next(j)]) && opposite(by_second[j][i], by_second[j][next(i)])
        })
    }
}

/// The plane of three points, made exactly when rounding may have changed a side.
pub(super) struct Across<'n> {
    near: &'n Near<'n>,
    pub(super) corners: [u32; 3],
    plane: OnceCell<Plane>,
}

impl Across<'_> {
    /// The side of a point: `Greater` in the direction of the normal.
    pub(super) fn side(&self, p: u32) -> Ordering {
        if self.corners.contains(&p) {
            return Ordering::Equal;
        }
        self.near.rounded.side(self.corners, p).unwrap_or_else(|| self.near.rows.side(self.plane(), p))
    }

    /// The plane in integers.
    pub(super) fn plane(&self) -> &Plane {
        self.plane.get_or_init(|| self.near.rows.plane(self.corners))
    }
}

#[cfg(test)]
mod tests {
    use rug::Rational;

    use super::*;

    #[test]
    fn boxes_reach_as_far_as_coordinates_may_be_rounded() {
        let at = |x: i32, y: i32, z: i32| [x, y, z].map(|x| Rational::from((x, 3)));
        let points = vec![at(0, 0, 0), at(24, 0, 1), at(0, -48, 2), at(1, 1, 4)];
        let part = Part { triangles: vec![[0, 1, 2], [0, 1, 3]], pieces: vec![Piece::Face(0); 2], ..Part::default() };
        let slices = Slices { points, parts: vec![part, Part::default()], ..Slices::default() };
        let near_points = Near::of(&slices.points);
        let (index, reach) = near_points.index(&slices.parts[0]).expect("two triangles");
        assert_eq!(index.all().len(), 2);
        assert_eq!(reach.to_bits(), (1023 + 4 - 50) << 52, "a part in 2^50 of 16");
        assert!(near_points.index(&slices.parts[1]).is_none(), "no triangle");
        let mut near = Vec::new();
        index.near(&index.all()[1], reach, &mut near);
        assert_eq!(near.iter().collect::<std::collections::BTreeSet<_>>().len(), 2);
    }
}
