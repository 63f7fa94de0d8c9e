//! Detection of edges of one mesh that pass through triangles of the other, by `orient3d` of input vertices only.
//!
//! An edge passes through a triangle iff its ends are on two sides of the triangle's plane, and it passes the three
//! edges of the triangle on the same side. Whatever the signs are, each edge of a triangle is tested in one direction
//! for all triangles that have it, so no edge falls between two triangles.

use std::sync::atomic::{AtomicBool, Ordering};

use predicament_grid::Bounds;
use predicament_grid::two_level::{Sizes, TwoLevel};
use predicament_mesh::MaterialMesh;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};
use rayon::prelude::*;

use super::Zeros;
use super::near::{Near, number};

/// The number of triangles in one thread's work item.
const PART: usize = 256;

/// An edge that passes through a triangle of the other mesh.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Hit {
    pub edge: u32,
    /// The triangle's index among the near triangles.
    pub triangle: u32,
    /// True if the edge begins behind the triangle, and ends in front of it.
    pub is_first_behind: bool,
}

/// The edges of one mesh and the triangles of the other, to be tested in one direction.
pub(super) struct Question<'a> {
    pub session: &'a dyn Predicates,
    pub edges: &'a Near,
    pub of: &'a MaterialMesh,
    pub triangles: &'a Near,
    pub zeros: Zeros,
}

impl Question<'_> {
    /// All edges that pass through triangles, by triangle, then by edge.
    ///
    /// # Errors
    /// [`Touches`] if an edge touches a triangle, and a zero is a zero.
    pub fn hits(&self) -> Result<Vec<Hit>, Touches> {
        let scene = self.session.scene();
        let edges = &self.edges.edges;
        let box_of = |ends: &[Vertex; 2]| Bounds::of(ends.map(|v| scene.point3(v)));
        let boxes: Vec<Bounds<3>> = edges.par_iter().with_min_len(PART).map(box_of).collect();
        let grid = TwoLevel::new(&boxes, Sizes::of(&boxes));
        // The other threads stop at a contact, too.
        let touches = AtomicBool::new(false);
        let part = |part: usize| {
            let mut asked = Asked::default();
            let (mut hits, count) = (Vec::new(), self.triangles.triangles.len());
            if touches.load(Ordering::Relaxed) {
                return Err(Touches);
            }
            for place in part * PART..count.min((part + 1) * PART) {
                let through = self.through(place, &grid, &boxes, &mut asked, &mut hits);
                through.inspect_err(|_| touches.store(true, Ordering::Relaxed))?;
            }
            Ok(hits)
        };
        let parts = predicament_grid::parallel::each(self.triangles.triangles.len().div_ceil(PART), &part);
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
    ) -> Result<(), Touches> {
        let triangle = self.of.triangles()[self.triangles.triangles[place] as usize];
        let scene = self.session.scene();
        let bounds = Bounds::of(triangle.map(|v| scene.point3(v)));
        asked.edges.clear();
        grid.within(&bounds, |_, entries| {
            // Without branches: they would be unpredictable, as nearness of boxes is nearly random.
            let mut count = asked.edges.len();
            asked.edges.resize(count + entries.len(), 0);
            for &edge in entries {
                asked.edges[count] = edge;
                count += usize::from(do_meet(&boxes[edge as usize], &bounds));
            }
            asked.edges.truncate(count);
        });
        asked.edges.sort_unstable();
        asked.edges.dedup();
        asked.ask(self.session, &self.edges.edges, triangle);
        if asked.are_beside() {
            return Ok(());
        }
        for (&edge, &places) in asked.edges.iter().zip(&asked.places) {
            let ends = self.edges.edges[edge as usize];
            let sides = places.map(|place| asked.signs[place as usize]);
            let passes = match self.zeros {
                Zeros::Positive => {
                    let sides = sides.map(or_positive);
                    sides[0] != sides[1] && self.turns(ends, triangle, or_positive).is_ok_and(is_one_sign)
                }
                Zeros::Zero => {
                    if !sides[0].is_zero() && sides[0] == sides[1] {
                        continue;
                    }
                    if sides == [Sign::Zero; 2] {
                        if is_apart(self.session, ends, triangle) {
                            continue;
                        }
                        return Err(Touches);
                    }
                    let Ok(turns) = self.turns(ends, triangle, |sign| sign) else { continue };
                    if turns.contains(&Sign::Zero) || sides.contains(&Sign::Zero) {
                        return Err(Touches);
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

    /// The sides on which the line of an edge passes the edges of a triangle, with zeros as in `seen`. The line misses
    /// the triangle if two sides are opposite.
    fn turns(
        &self,
        [p, q]: [Vertex; 2],
        [a, b, c]: [Vertex; 3],
        seen: impl Fn(Sign) -> Sign,
    ) -> Result<[Sign; 3], PassesBy> {
        let side = |u: Vertex, v: Vertex| {
            seen(if u < v { self.session.orient3d(p, q, u, v) } else { -self.session.orient3d(p, q, v, u) })
        };
        let is_opposite = |a: Sign, b: Sign| !a.is_zero() && a == -b;
        let first = side(a, b);
        let second = side(b, c);
        if is_opposite(first, second) {
            return Err(PassesBy);
        }
        let third = side(c, a);
        if is_opposite(first, third) || is_opposite(second, third) {
            return Err(PassesBy);
        }
        Ok([first, second, third])
    }
}

/// The result for an edge and a triangle that touch: with an end, at the border, or along a part.
pub(super) struct Touches;

/// The result for a line that meets the plane of a triangle outside it.
struct PassesBy;

/// The tests of one triangle; the memory is reused.
#[derive(Default)]
struct Asked {
    edges: Vec<u32>,
    /// For each edge, the indices of its ends.
    places: Vec<[u32; 2]>,
    /// The ends of all edges, each vertex once.
    ends: Vec<Vertex>,
    signs: Vec<Sign>,
    /// A hash table by vertex with linear probing: index plus one, or zero. Its size is a power of two; half of it is
    /// empty.
    table: Vec<u32>,
}

impl Asked {
    /// Finds the sides of all edges' ends on a triangle's plane, each vertex once.
    fn ask(&mut self, session: &dyn Predicates, edges: &[[Vertex; 2]], triangle: [Vertex; 3]) {
        let size = (4 * self.edges.len()).next_power_of_two();
        self.table.clear();
        self.table.resize(size, 0);
        self.ends.clear();
        self.places.clear();
        for at in 0..self.edges.len() {
            let places = edges[self.edges[at] as usize].map(|v| self.place(v));
            self.places.push(places);
        }
        self.signs.clear();
        self.signs.resize(self.ends.len(), Sign::Zero);
        session.orient3d_plane(triangle, &self.ends, &mut self.signs);
    }

    /// The index of a vertex among the ends; a new vertex is appended.
    fn place(&mut self, v: Vertex) -> u32 {
        // (An odd number near 2^64 divided by the golden ratio; any other would do.)
        let mixed = v.index().wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
        let mut slot = mixed & (self.table.len() - 1);
        loop {
            match self.table[slot].checked_sub(1) {
                Some(place) if self.ends[place as usize] == v => return place,
                Some(_) => slot = (slot + 1) & (self.table.len() - 1),
                None => {
                    self.ends.push(v);
                    self.table[slot] = number(self.ends.len());
                    return number(self.ends.len() - 1);
                }
            }
        }
    }

    /// True if all ends are on one side.
    fn are_beside(&self) -> bool {
        self.signs.first().is_none_or(|first| !first.is_zero() && self.signs.iter().all(|sign| sign == first))
    }
}

/// True if two closed boxes have a point in common.
#[inline(always)]
pub(super) fn do_meet(a: &Bounds<3>, b: &Bounds<3>) -> bool {
    let along = |axis: usize| (a.low[axis] <= b.high[axis]) & (b.low[axis] <= a.high[axis]);
    along(0) & along(1) & along(2)
}

fn or_positive(sign: Sign) -> Sign {
    if sign.is_zero() { Sign::Positive } else { sign }
}

fn is_one_sign([a, b, c]: [Sign; 3]) -> bool {
    a == b && b == c
}

/// True if an edge in the plane of a triangle is apart from it: on a line through two of the five vertices, all others
/// of the triangle, or of the edge, are on the far side.
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
