//! A triangle of one mesh, and the search for all pairs of triangles that meet.

use predicament_grid::Bounds;
use predicament_grid::two_level::{Sizes, TwoLevel};
use predicament_predicates::{Predicates, Sign, Vertex};

use super::found::Found;
use super::{coplanar, skew};
use crate::algorithm::overlay::meet::do_meet;
use crate::algorithm::overlay::near::{Near, number};

/// The number of triangles in one thread's work item.
const PART: usize = 128;

/// A near triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle {
    /// Its index among the near triangles.
    pub place: u32,
    /// Its corners, by representatives.
    pub corners: [Vertex; 3],
    /// Its edges; the first is between the first two corners.
    pub edges: [u32; 3],
}

/// The near triangles of one mesh.
pub(super) struct Triangles<'a> {
    pub near: &'a Near,
    /// The corners of each, by representatives.
    pub corners: &'a [[Vertex; 3]],
    /// True for each triangle that both meshes have.
    pub is_twin: &'a [bool],
}

impl Triangles<'_> {
    pub fn at(&self, place: u32) -> Triangle {
        let at = place as usize;
        Triangle { place, corners: self.corners[at], edges: self.near.edges_of[at] }
    }
}

/// Finds all points and segments of both meshes. A triangle of both meshes has only vertices and edges in common with
/// the others of either, so a pair of two such triangles is left out.
pub(super) fn found(session: &dyn Predicates, meshes: [&Triangles<'_>; 2]) -> Found {
    let scene = session.scene();
    let box_of = |corners: &[Vertex; 3]| Bounds::of(corners.map(|v| scene.point3(v)));
    let boxes: Vec<Bounds<3>> = meshes[1].corners.iter().map(box_of).collect();
    let grid = TwoLevel::new(&boxes, Sizes::of(&boxes));
    let count = meshes[0].corners.len();
    let part = |part: usize| {
        let mut found = Found::default();
        let mut asked = Asked::default();
        for place in part * PART..count.min((part + 1) * PART) {
            let first = meshes[0].at(number(place));
            let bounds = box_of(&first.corners);
            asked.others.clear();
            grid.within(&bounds, |_, entries| {
                let meets = |&&other: &&u32| {
                    do_meet(&boxes[other as usize], &bounds)
                        && !(meshes[0].is_twin[place] && meshes[1].is_twin[other as usize])
                };
                asked.others.extend(entries.iter().filter(meets));
            });
            asked.others.sort_unstable();
            asked.others.dedup();
            asked.ask(session, first.corners, meshes[1].corners);
            for at in 0..asked.others.len() {
                let second = meshes[1].at(asked.others[at]);
                let of_second = second.corners.map(|v| asked.side(v));
                if is_beside(of_second) {
                    continue;
                }
                if of_second == [Sign::Zero; 3] {
                    coplanar::add(session, [&first, &second], &mut found);
                    continue;
                }
                let of_first = sides(session, second.corners, first.corners);
                if !is_beside(of_first) {
                    skew::add(session, [&first, &second], [of_first, of_second], &mut found);
                }
            }
        }
        found
    };
    Found::joined(predicament_grid::parallel::each(count.div_ceil(PART), &part))
}

/// True if three corners are strictly on one side.
fn is_beside([a, b, c]: [Sign; 3]) -> bool {
    !a.is_zero() && a == b && b == c
}

/// The sides of a plane on which the corners of a triangle are: positive behind the plane; zero for its own vertices.
fn sides(session: &dyn Predicates, plane: [Vertex; 3], corners: [Vertex; 3]) -> [Sign; 3] {
    let mut signs = [Sign::Zero; 3];
    if corners.iter().any(|v| plane.contains(v)) {
        for (sign, v) in signs.iter_mut().zip(corners).filter(|(_, v)| !plane.contains(v)) {
            *sign = session.orient3d(plane[0], plane[1], plane[2], v);
        }
    } else {
        session.orient3d_plane(plane, &corners, &mut signs);
    }
    signs
}

/// The sides of one triangle's plane, each vertex asked once; the memory is reused.
#[derive(Default)]
struct Asked {
    others: Vec<u32>,
    vertices: Vec<Vertex>,
    signs: Vec<Sign>,
}

impl Asked {
    fn ask(&mut self, session: &dyn Predicates, plane: [Vertex; 3], corners: &[[Vertex; 3]]) {
        self.vertices.clear();
        let others = self.others.iter().flat_map(|&other| corners[other as usize]);
        self.vertices.extend(others.filter(|v| !plane.contains(v)));
        self.vertices.sort_unstable();
        self.vertices.dedup();
        self.signs.clear();
        self.signs.resize(self.vertices.len(), Sign::Zero);
        session.orient3d_plane(plane, &self.vertices, &mut self.signs);
    }

    /// The side of a vertex; zero for a corner of the plane's triangle.
    fn side(&self, v: Vertex) -> Sign {
        self.vertices.binary_search(&v).map_or(Sign::Zero, |at| self.signs[at])
    }
}
