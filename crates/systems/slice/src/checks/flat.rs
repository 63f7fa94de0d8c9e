//! Checks of pieces of faces and of caps: plane, orientation and area.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use rug::Rational;

use super::crossing::{Across, Near};
use super::exact::Plane;
use super::{Check, Expected, Flaws, Piece, Slices};
use predicament_judge::sum::sum;

impl Slices {
    /// Checks that caps are in their planes and face away from their part; `sides` are the sides of parts on planes.
    pub(super) fn caps(&self, near: &Near<'_>, sides: &BTreeMap<(usize, usize), Ordering>, flaws: &mut Flaws) {
        let planes: Vec<Across<'_>> = self.planes.iter().map(|&plane| near.across(plane)).collect();
        for (at, part) in self.parts.iter().enumerate() {
            for (triangle, piece) in part.triangles.iter().zip(&part.pieces) {
                let Piece::Cap(place) = *piece else { continue };
                let plane = &planes[place];
                if triangle.iter().any(|&p| plane.side(p) != Ordering::Equal) {
                    flaws.add(Check::CapInPlane, triangle, || {
                        let plane = Plane::of(self.points(self.planes[place]));
                        let off = self.points(*triangle).map(|p| plane.distance(p)).into_iter().fold(0.0, f64::max);
                        format!("a cap of part {at} is {off:e} off plane {place}")
                    });
                }
                // A cap that is off its plane may also be turned over.
                let turns = near.rows.plane(*triangle).along(plane.plane());
                // Away from the part: along the normal where the part is below the plane.
                if turns != Ordering::Equal && turns == sides[&(at, place)] {
                    flaws.add(Check::CapOrientation, triangle, || {
                        format!("a cap of part {at} in plane {place} faces into the part")
                    });
                }
            }
        }
    }

    /// Checks that pieces of a face are in its plane, face in its direction, and have its area together.
    pub(super) fn faces(&self, near: &Near<'_>, expected: Expected, flaws: &mut Flaws) {
        let mut pieces: Vec<Vec<[u32; 3]>> = vec![Vec::new(); self.faces.len()];
        for part in &self.parts {
            for (triangle, piece) in part.triangles.iter().zip(&part.pieces) {
                match *piece {
                    Piece::Face(face) => pieces[face].push(*triangle),
                    Piece::Cap(_) if expected.has_areas => near.needs_area(*triangle, flaws),
                    Piece::Cap(_) | Piece::Cover => {}
                }
            }
        }
        for (face, (corners, pieces)) in self.faces.iter().zip(&pieces).enumerate() {
            if !is_whole(corners, pieces) {
                self.pieces(near, face, pieces, expected, flaws);
            }
        }
    }

    fn pieces(&self, near: &Near<'_>, face: usize, pieces: &[[u32; 3]], expected: Expected, flaws: &mut Flaws) {
        let corners = &self.faces[face];
        let fan = || corners.windows(2).skip(1).map(|next| [corners[0], next[0], next[1]]);
        // In a polygon, no three corners need to turn as it does; the sum over a fan does.
        let of_axis = |axis| sum(fan().map(|triangle| near.rows.area_value(triangle, axis)).collect());
        // Seen along the axis with the largest area: pieces that rounding has moved out of the plane keep their turn.
        let seen = (0..3).map(|axis| (axis, of_axis(axis))).filter(|(_, whole)| !whole.is_zero());
        let Some((axis, whole)) = seen.max_by_key(|(_, whole): &(usize, Rational)| whole.clone().abs()) else {
            return;
        };
        let plane = fan().map(|triangle| near.across(triangle)).find(|plane| plane.plane().axis().is_some());
        let mut areas = Vec::with_capacity(pieces.len());
        for triangle in pieces {
            let new = triangle.iter().filter(|place| !corners.contains(place));
            let is_off = |&place: &u32| plane.as_ref().is_some_and(|plane| plane.side(place) != Ordering::Equal);
            if new.copied().any(|place| is_off(&place)) {
                flaws.add(Check::PieceInFace, triangle, || {
                    let exact = plane.as_ref().map(|plane| Plane::of(self.points(plane.corners)));
                    let far =
                        |place: &u32| exact.as_ref().map_or(0.0, |plane| plane.distance(&self.points[*place as usize]));
                    let off = triangle.iter().map(far).fold(0.0, f64::max);
                    format!("a piece of face {face} is {off:e} off its plane")
                });
            }
            let area = near.rows.area_value(*triangle, axis);
            match area.cmp0().times(whole.cmp0()) {
                Ordering::Less => {
                    flaws.add(Check::PieceOrientation, triangle, || format!("a piece of face {face} is turned over"));
                }
                Ordering::Equal if expected.has_areas => near.needs_area(*triangle, flaws),
                _ => {}
            }
            areas.push(area);
        }
        let more = sum(areas) - &whole;
        if !more.is_zero() {
            flaws.add(Check::FaceArea, corners, || {
                let more = (more / whole).to_f64();
                format!("the {} pieces of face {face} have {more:e} more area than the face", pieces.len())
            });
        }
    }
}

/// True if the only piece of a triangle is the triangle.
fn is_whole(corners: &[u32], pieces: &[[u32; 3]]) -> bool {
    let (&[a, b, c], &[piece]) = (corners, pieces) else { return false };
    [[a, b, c], [b, c, a], [c, a, b]].contains(&piece)
}

trait Signed {
    /// The product of two signs.
    fn times(self, other: Self) -> Self;
}

impl Signed for Ordering {
    fn times(self, other: Ordering) -> Ordering {
        match self {
            Ordering::Less => other.reverse(),
            Ordering::Equal => Ordering::Equal,
            Ordering::Greater => other,
        }
    }
}
