//! Where edges of one mesh pass through triangles of the other: `orient3d` of input vertices, and nothing else.
//!
//! An edge passes through a triangle iff its ends are on two sides of the triangle's plane, and it passes the three edges of the
//! triangle on the same side. Whatever the signs are, each edge of a triangle is asked about in one direction for all
//! triangles that have it, so that none falls between two triangles.

use predicament_grid::Bounds;
use predicament_grid::two_level::{Sizes, TwoLevel};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};
use rayon::prelude::*;

use super::near::{Near, number};
use super::planted::Wrong;
use super::{Touch, Zeros};

/// Triangles that one thread takes at a time.
const PART: usize = 256;

/// An edge that passes through a triangle of the other mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Hit {
    pub edge: u32,
    /// Its place among those that are near.
    pub triangle: u32,
    /// Whether the edge begins behind the triangle, and ends in front of it.
    pub is_first_behind: bool,
}

/// What is asked about in one direction: the edges of one mesh, and the triangles of the other.
pub(super) struct Question<'a> {
    pub session: &'a dyn Predicates,
    /// The mesh of the edges, 0 or 1.
    pub mesh: u8,
    pub edges: &'a Near,
    pub of: &'a MaterialMesh,
    pub triangles: &'a Near,
    pub zeros: Zeros,
    pub wrong: Wrong,
}

impl Question<'_> {
    /// All edges that pass through triangles, by triangle, then by edge.
    ///
    /// # Errors
    /// An edge that touches a triangle where zeros are refused: the first by triangle.
    pub fn hits(&self) -> Result<Vec<Hit>, Touch> {
        let scene = self.session.scene();
        let edges = &self.edges.edges;
        let box_of = |ends: &[Vertex; 2]| Bounds::of(ends.map(|v| scene.point3(v)));
        let boxes: Vec<Bounds<3>> = edges.par_iter().with_min_len(PART).map(box_of).collect();
        let grid = TwoLevel::new(&boxes, Sizes::of(&boxes));
        let part = |part: usize| {
            let mut asked = Asked::default();
            let (mut hits, count) = (Vec::new(), self.triangles.triangles.len());
            for place in part * PART..count.min((part + 1) * PART) {
                self.through(place, &grid, &boxes, &mut asked, &mut hits)?;
            }
            Ok(hits)
        };
        let parts = crate::parallel::each(self.triangles.triangles.len().div_ceil(PART), &part);
        let mut all = Vec::new();
        for part in parts {
            all.extend(part?);
        }
        Ok(all)
    }

    /// The edges that pass through one triangle.
    fn through(
        &self,
        place: usize,
        grid: &TwoLevel,
        boxes: &[Bounds<3>],
        asked: &mut Asked,
        hits: &mut Vec<Hit>,
    ) -> Result<(), Touch> {
        let triangle = self.of.triangles()[self.triangles.triangles[place] as usize];
        let scene = self.session.scene();
        let bounds = Bounds::of(triangle.map(|v| scene.point3(v)));
        asked.edges.clear();
        grid.within(&bounds, |_, entries| asked.edges.extend_from_slice(entries));
        asked.edges.retain(|&edge| boxes[edge as usize].is_near(&bounds, 0.0));
        asked.edges.sort_unstable();
        asked.edges.dedup();
        asked.ask(self.session, &self.edges.edges, triangle);
        for &edge in &asked.edges {
            let ends = self.edges.edges[edge as usize];
            let sides = ends.map(|v| asked.side(v));
            let touch = || Touch { mesh: self.mesh, edge: ends, triangle: self.triangles.triangles[place] };
            let passes = match self.zeros {
                Zeros::Positive => {
                    let sides = sides.map(or_positive);
                    sides[0] != sides[1] && is_one_sign(self.turns(ends, triangle).map(or_positive))
                }
                Zeros::Refused => {
                    if !sides[0].is_zero() && sides[0] == sides[1] {
                        continue;
                    }
                    if sides == [Sign::Zero; 2] {
                        if is_apart(self.session, ends, triangle) {
                            continue;
                        }
                        return Err(touch());
                    }
                    let turns = self.turns(ends, triangle);
                    if turns.contains(&Sign::Positive) && turns.contains(&Sign::Negative) {
                        continue;
                    }
                    if turns.contains(&Sign::Zero) || sides.contains(&Sign::Zero) {
                        return Err(touch());
                    }
                    true
                }
            };
            if passes {
                let is_first_behind = or_positive(sides[0]) == Sign::Positive;
                hits.push(Hit { edge, triangle: number(place), is_first_behind });
            }
        }
        Ok(())
    }

    /// On which sides the line of an edge passes the edges of a triangle.
    fn turns(&self, [p, q]: [Vertex; 2], [a, b, c]: [Vertex; 3]) -> [Sign; 3] {
        let side = |u: Vertex, v: Vertex| {
            if u < v { self.session.orient3d(p, q, u, v) } else { -self.session.orient3d(p, q, v, u) }
        };
        if self.wrong == Wrong::LooksAtTwoSides {
            let turn = side(a, b);
            return [turn, side(b, c), turn];
        }
        [side(a, b), side(b, c), side(c, a)]
    }
}

/// What is asked about one triangle; kept to be used again.
#[derive(Default)]
struct Asked {
    edges: Vec<u32>,
    ends: Vec<Vertex>,
    signs: Vec<Sign>,
}

impl Asked {
    /// Asks on which side of a triangle's plane the ends of all edges are, each vertex once.
    fn ask(&mut self, session: &dyn Predicates, edges: &[[Vertex; 2]], triangle: [Vertex; 3]) {
        self.ends.clear();
        self.ends.extend(self.edges.iter().flat_map(|&edge| edges[edge as usize]));
        self.ends.sort_unstable();
        self.ends.dedup();
        self.signs.clear();
        self.signs.resize(self.ends.len(), Sign::Zero);
        session.orient3d_plane(triangle, &self.ends, &mut self.signs);
    }

    fn side(&self, v: Vertex) -> Sign {
        self.ends.binary_search(&v).map_or(Sign::Zero, |at| self.signs[at])
    }
}

fn or_positive(sign: Sign) -> Sign {
    if sign.is_zero() { Sign::Positive } else { sign }
}

fn is_one_sign([a, b, c]: [Sign; 3]) -> bool {
    a == b && b == c
}

/// Whether an edge in the plane of a triangle is apart from it: a line through two of the five vertices has all others of
/// the triangle, or of the edge, on its far side.
fn is_apart(session: &dyn Predicates, [p, q]: [Vertex; 2], triangle: [Vertex; 3]) -> bool {
    let [a, b, c] = triangle;
    let seen = [Plane::Xy, Plane::Yz, Plane::Zx]
        .into_iter()
        .map(|plane| (plane, session.orient2d(plane, a, b, c)))
        .find(|(_, sign)| !sign.is_zero());
    let Some((plane, inside)) = seen else { return false };
    let beyond = |u: Vertex, v: Vertex| [p, q].map(|w| session.orient2d(plane, u, v, w)) == [-inside; 2];
    if beyond(a, b) || beyond(b, c) || beyond(c, a) {
        return true;
    }
    let sides = triangle.map(|v| session.orient2d(plane, p, q, v));
    !sides[0].is_zero() && is_one_sign(sides)
}
