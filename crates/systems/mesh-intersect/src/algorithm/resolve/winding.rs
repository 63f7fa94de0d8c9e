//! Winding numbers of a surface on both sides of its faces.
//!
//! Faces that meet at an edge without other faces have equal numbers. In each such patch, one face computes them by a
//! ray from a point of it that is off everything else ([`crate::algorithm::ray`]).

use predicament_grid::{Bounds, BoxIndex};
use predicament_predicates::{Predicates, Sign, Vertex};

use super::faces::Face;
use crate::algorithm::limit::Places;
use crate::algorithm::limit::sheets::view;
use crate::algorithm::overlay::{SurfaceContradiction, Undone};
use crate::algorithm::ray::Ray;

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
                let (plane, turn) = view(session, places, faces[leader].corners)?;
                let ray = Ray::new(faces[leader].corners, plane);
                let mut column = Bounds::of([places.nearest(scene, ray.from[0])]);
                column.high[ray.axis.index()] = around.high[ray.axis.index()];
                index.near(&column, 0.0, &mut found);
                let mut sum = 0;
                for &at in found.iter().filter(|&&at| at as usize != leader) {
                    let Face { corners, times } = faces[at as usize];
                    match ray.passes(session, corners)? {
                        Sign::Positive => sum += times,
                        Sign::Negative => sum -= times,
                        Sign::Zero => {}
                    }
                }
                let is_in_front = turn == Sign::Positive;
                *numbers[leader].insert(if is_in_front { sum } else { sum - faces[leader].times })
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
