//! Winding numbers of a surface on both sides of its faces.
//!
//! Faces that meet at an edge without other faces have equal numbers. In each such patch, one face computes them by a
//! ray from a point of it that is off everything else: from a corner v the point v + ε(a − v) + ε²(b − v), with the
//! other two corners a and b, and ε small enough. Its projection is on no line of two others, as that would be an
//! equation with three zeros: signs are those of v, if these are zero those of a, and then those of b. So nothing is
//! constructed, and no number has more digits than the corners have.

use predicament_grid::{Bounds, BoxIndex};
use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::faces::{Face, side, turn};
use crate::algorithm::limit::Places;
use crate::algorithm::limit::sheets::view;
use crate::algorithm::overlay::{SurfaceContradiction, Undone};

/// For each face, the winding number in front of it; behind it the number is larger by the times that the face is
/// passed.
pub(super) fn in_front(session: &dyn Predicates, places: &Places, faces: &[Face]) -> Result<Vec<i32>, Undone> {
    let leaders = patches(faces)?;
    let scene = session.scene();
    let bounds = |face: &Face| Bounds::of(face.corners.map(|v| places.nearest(scene, v)));
    let boxes: Vec<Bounds<3>> = faces.iter().map(bounds).collect();
    let around = boxes.iter().fold(Bounds::NOTHING, |sum, one| sum.union(one));
    let index = BoxIndex::new(boxes);
    let mut numbers: Vec<Option<i32>> = vec![None; faces.len()];
    let mut found = Vec::new();
    let mut all = Vec::with_capacity(faces.len());
    for leader in leaders {
        let known = match numbers[leader] {
            Some(known) => known,
            None => {
                let ray = Ray::of(session, places, faces[leader])?;
                let mut column = Bounds::of([places.nearest(scene, ray.from[0])]);
                column.high[ray.axis.index()] = around.high[ray.axis.index()];
                index.near(&column, 0.0, &mut found);
                let mut sum = 0;
                for &at in found.iter().filter(|&&at| at as usize != leader) {
                    sum += ray.leaves(session, faces[at as usize])?;
                }
                *numbers[leader].insert(if ray.is_in_front { sum } else { sum - faces[leader].times })
            }
        };
        all.push(known);
    }
    Ok(all)
}

/// For each face, the first face of its patch.
fn patches(faces: &[Face]) -> Result<Vec<usize>, Undone> {
    let mut edges: Vec<([Vertex; 2], usize, i32)> = Vec::with_capacity(3 * faces.len());
    for (at, Face { corners: [a, b, c], times }) in faces.iter().enumerate() {
        let directed = [[*a, *b], [*b, *c], [*c, *a]];
        edges.extend(directed.map(|[a, b]| ([a.min(b), a.max(b)], at, if a < b { *times } else { -times })));
    }
    edges.sort_unstable();
    let mut leaders: Vec<usize> = (0..faces.len()).collect();
    let leader = |leaders: &mut Vec<usize>, mut at: usize| {
        while leaders[at] != at {
            leaders[at] = leaders[leaders[at]];
            at = leaders[at];
        }
        at
    };
    for uses in edges.chunk_by(|a, b| a.0 == b.0) {
        if uses.iter().map(|(_, _, times)| times).sum::<i32>() != 0 {
            return Err(Undone::Broken(SurfaceContradiction::PartsClosed.into()));
        }
        if let [(_, first, _), (_, second, _)] = uses {
            let [first, second] = [*first, *second].map(|at| leader(&mut leaders, at));
            leaders[first.max(second)] = first.min(second);
        }
    }
    Ok((0..faces.len()).map(|at| leader(&mut leaders, at)).collect())
}

/// A ray along an axis from a point of a face.
struct Ray {
    axis: Axis,
    /// The plane across the ray.
    plane: Plane,
    /// The start of the ray: the first vertex, moved towards the second, and by less towards the third.
    from: [Vertex; 3],
    /// True if the ray begins in front of the face.
    is_in_front: bool,
}

impl Ray {
    fn of(session: &dyn Predicates, places: &Places, face: Face) -> Result<Ray, Undone> {
        let (plane, turn) = view(session, places, face.corners)?;
        let axis = match plane {
            Plane::Xy => Axis::Z,
            Plane::Yz => Axis::X,
            Plane::Zx => Axis::Y,
        };
        Ok(Ray { axis, plane, from: face.corners, is_in_front: turn == Sign::Positive })
    }

    /// The first of three signs that is not zero.
    fn first(&self, sign: impl FnMut(Vertex) -> Sign) -> Result<Sign, Undone> {
        self.from
            .into_iter()
            .map(sign)
            .find(|sign| !sign.is_zero())
            .ok_or(Undone::Broken(SurfaceContradiction::Faces.into()))
    }

    /// The decrease of the winding number when the ray passes a face.
    fn leaves(&self, session: &dyn Predicates, face: Face) -> Result<i32, Undone> {
        let [a, b, c] = face.corners;
        let up = turn(session, self.plane, [a, b, c]);
        if up.is_zero() {
            return Ok(0);
        }
        for [p, q] in [[a, b], [b, c], [c, a]] {
            if self.first(|v| turn(session, self.plane, [p, q, v]))? != up {
                return Ok(0);
            }
        }
        // The point is below: behind a face that looks up, in front of a face that looks down.
        let is_below = self.first(|v| side(session, face.corners, v))? == up;
        Ok(match (is_below, up) {
            (false, _) => 0,
            (true, Sign::Positive) => face.times,
            (true, _) => -face.times,
        })
    }
}
