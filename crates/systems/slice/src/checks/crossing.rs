//! Checks for edges of a part that pass through its triangles.

use std::cmp::Ordering;

use predicament_judge::boxes::{Boxes, Extent, extent};

use super::exact::{Plane, area, side};
use super::{Check, Expected, Flaws, Part, Piece, Slices};

impl Slices {
    /// Compares triangles of each part with those near them: they may touch, but not pass through each other. Covers of
    /// open loops are not planar and may pass through anything.
    pub(super) fn crossings(&self, expected: Expected, flaws: &mut Flaws) {
        let step = self.triangles().div_ceil(expected.triangles_crossed.max(1)).max(1);
        let mut number = 0;
        for (at, part) in self.parts.iter().enumerate() {
            let Some((index, reach)) = self.index(part) else { continue };
            let mut near = Vec::new();
            for (place, &triangle) in part.triangles.iter().enumerate() {
                number += 1;
                if number % step != 0 || part.pieces[place] == Piece::Cover {
                    continue;
                }
                index.near(&index.all()[place], reach, &mut near);
                let plane = Plane::of(self.points(triangle));
                for other in near.iter().map(|&other| other as usize) {
                    if other == place || part.pieces[other] == Piece::Cover {
                        continue;
                    }
                    let other = part.triangles[other];
                    if self.pass(&plane, triangle, other, expected) {
                        flaws.add(Check::SelfIntersection, &[triangle, other].concat(), || {
                            format!("two triangles of part {at} pass through each other")
                        });
                    }
                }
            }
        }
    }

    /// The boxes of the triangles, and a bound on their error.
    fn index(&self, part: &Part) -> Option<(Boxes<3>, f64)> {
        let mut largest = 0.0_f64;
        let boxes = part.triangles.iter().map(|triangle| {
            let points = self.points(*triangle).map(|p| [0, 1, 2].map(|i| p[i].to_f64()));
            points.as_flattened().iter().for_each(|x| largest = largest.max(x.abs()));
            extent(points)
        });
        let boxes: Vec<Extent<3>> = boxes.collect();
        // The relative rounding error of coordinates is below 2^-52.
        (!boxes.is_empty()).then(|| (Boxes::new(boxes), largest * 2.0_f64.powi(-50)))
    }

    /// True if an edge of one triangle passes through the inside of the other, or edges of both cross in a common
    /// plane. Faces of a part without volume may lie on each other; breaking ties makes such parts. `plane` is the
    /// plane of the first triangle.
    fn pass(&self, plane: &Plane, first: [u32; 3], second: [u32; 3], expected: Expected) -> bool {
        if first.iter().all(|p| second.contains(p)) {
            return false;
        }
        let of_second = self.sides_of(plane, first, second);
        if of_second == [Ordering::Equal; 3] {
            return expected.has_areas && self.overlap(plane, first, second);
        }
        // A triangle on one side of the plane has no inner point in the plane.
        if !(of_second.contains(&Ordering::Less) && of_second.contains(&Ordering::Greater)) {
            return false;
        }
        let of_first = self.sides_of(&Plane::of(self.points(second)), second, first);
        let pierces = |edges: [u32; 3], sides: [Ordering; 3], triangle: [u32; 3]| {
            (0..3).any(|i| {
                let j = (i + 1) % 3;
                let through = sides[i] != Ordering::Equal && sides[i] == sides[j].reverse();
                through && self.is_inside([edges[i], edges[j]], triangle)
            })
        };
        pierces(second, of_second, first) || pierces(first, of_first, second)
    }

    /// The sides of points on the plane of a triangle; the triangle's own corners are on it.
    fn sides_of(&self, plane: &Plane, corners: [u32; 3], points: [u32; 3]) -> [Ordering; 3] {
        points.map(|p| if corners.contains(&p) { Ordering::Equal } else { plane.side(&self.points[p as usize]) })
    }

    /// True if the line through an edge meets the inside of a triangle.
    fn is_inside(&self, [p, q]: [u32; 2], [a, b, c]: [u32; 3]) -> bool {
        let turn = |x: u32, y: u32| {
            let [p, q, x, y] = self.points([p, q, x, y]);
            side([p, q, x], y)
        };
        let turns = [turn(a, b), turn(b, c), turn(c, a)];
        turns[0] != Ordering::Equal && turns == [turns[0]; 3]
    }

    /// True if edges of two triangles in one plane cross, or a corner of one is inside the other.
    fn overlap(&self, plane: &Plane, first: [u32; 3], second: [u32; 3]) -> bool {
        let Some(axis) = plane.axis() else { return false };
        let turn = |a: u32, b: u32, c: u32| area(self.points([a, b, c]), axis).cmp0();
        let opposite = |x: Ordering, y: Ordering| x != Ordering::Equal && x == y.reverse();
        let edges = |[a, b, c]: [u32; 3]| [[a, b], [b, c], [c, a]];
        let is_in = |p: u32, triangle: [u32; 3]| {
            let turns = edges(triangle).map(|[a, b]| turn(a, b, p));
            turns[0] != Ordering::Equal && turns == [turns[0]; 3]
        };
        if first.into_iter().any(|p| is_in(p, second)) || second.into_iter().any(|p| is_in(p, first)) {
            return true;
        }
        edges(first).into_iter().any(|[a, b]| {
            edges(second)
                .into_iter()
                .any(|[p, q]| opposite(turn(a, b, p), turn(a, b, q)) && opposite(turn(p, q, a), turn(p, q, b)))
        })
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
        let (index, reach) = slices.index(&slices.parts[0]).expect("two triangles");
        assert_eq!(index.all().len(), 2);
        assert_eq!(reach.to_bits(), (1023 + 4 - 50) << 52, "a part in 2^50 of 16");
        assert!(slices.index(&slices.parts[1]).is_none(), "no triangle");
        let mut near = Vec::new();
        index.near(&index.all()[1], reach, &mut near);
        assert_eq!(near.iter().collect::<std::collections::BTreeSet<_>>().len(), 2);
    }
}
