//! Location of a vertex at a corner of the mesh, for sessions that move one of the two.
//!
//! The triangles around the corner decide alone: the moved vertex is as close to them as the move is small, and all
//! others are further away, unless they contain the corner. A ray along the surface would pass many cells.
//!
//! If the session moves the second mesh as a whole, by δ = (ε, ε², ε³), then the vertex is at δ or −δ from the corner.
//! Seen along x, it is off the corner by (ε², ε³) only. There the x of a triangle differs from the corner's by some
//! slope times ε², which is less than ε, unless its image is a line. So if the image of exactly one triangle around the
//! corner holds that of the vertex, the vertex is on the side of that triangle to which it has moved along x.

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};
use smallvec::SmallVec;

use super::{Location, MeshIndex};

/// A cache of the last few turns of edges.
#[derive(Default)]
pub(super) struct Spokes {
    edges: [Option<([Vertex; 2], Sign)>; 8],
    next: usize,
}

impl Spokes {
    /// The turn of an edge, from the cache or computed by `ask`.
    pub(super) fn turn(&mut self, [u, v]: [Vertex; 2], ask: impl FnOnce() -> Sign) -> Sign {
        for ([a, b], sign) in self.edges.iter().flatten() {
            match (*a == u && *b == v, *a == v && *b == u) {
                (true, _) => return *sign,
                (_, true) => return -*sign,
                _ => {}
            }
        }
        let sign = ask();
        self.edges[self.next % self.edges.len()] = Some(([u, v], sign));
        self.next += 1;
        sign
    }
}

impl MeshIndex {
    /// Locates a moved vertex at a corner of the mesh by the triangles around that corner; `entries` has all triangles
    /// that contain its position. `None` if a sign is zero, if not exactly one of these triangles is over or under the
    /// vertex as seen along an axis, or if another triangle may contain the corner.
    pub(super) fn at_corner<P: Predicates + ?Sized>(
        &self,
        session: &P,
        q: Vertex,
        corner: Vertex,
        entries: &[u32],
    ) -> Option<Location> {
        let points: &[[f64; 3]] = session.scene().coordinates().as_chunks().0;
        let (p, mesh, moves) = (points[q.index()], self.mesh(), session.moves_second_mesh());
        let mut around: SmallVec<[(u32, [Vertex; 3]); 12]> = SmallVec::new();
        for &triangle in entries {
            if !self.shadows()[triangle as usize].has(p[0], p[1]) {
                continue;
            }
            let corners = mesh.triangles()[triangle as usize];
            if let Some(corners) = from(points, corners, p) {
                around.push((triangle, corners));
                continue;
            }
            let [a, b, c] = corners;
            let is_away = is_beside(corners.map(|v| points[v.index()]), p)
                || moves && !session.orient3d(a, b, c, corner).is_zero();
            if !is_away {
                return None;
            }
        }
        let by_slopes = if moves { self.by_slopes(session, q, corner, &around) } else { None };
        by_slopes.or_else(|| self.by_turns(session, q, &around))
    }

    /// Locates a vertex that a move of the second mesh as a whole takes off a corner.
    fn by_slopes<P: Predicates + ?Sized>(
        &self,
        session: &P,
        q: Vertex,
        corner: Vertex,
        around: &[(u32, [Vertex; 3])],
    ) -> Option<Location> {
        let points: &[[f64; 3]] = session.scene().coordinates().as_chunks().0;
        let (p, forward, mut found) = (points[q.index()], session.compare(Axis::X, q, corner), None);
        for &(triangle, [a, b, c]) in around {
            // The side, seen along x, of the direction in which the vertex moves; negative is to the right of it.
            let side = |v: Vertex| {
                let [_, y, z] = points[v.index()];
                let left = if z == p[2] { y < p[1] } else { z > p[2] };
                left == (forward == Sign::Positive)
            };
            let [is_left_b, is_left_c] = [side(b), side(c)];
            if is_left_b == is_left_c {
                continue;
            }
            let turn = session.orient2d(Plane::Yz, a, b, c);
            if turn.is_zero() || forward.is_zero() {
                return None;
            }
            let holds = is_left_c == (turn == Sign::Positive);
            if holds && found.replace((triangle, turn == forward)).is_some() {
                return None;
            }
        }
        found.map(|(triangle, is_in_front)| {
            Location::In(self.mesh().sides()[triangle as usize][usize::from(!is_in_front)])
        })
    }

    /// Locates a moved vertex by its side of the one triangle around the corner that is over or under it, seen along
    /// an axis.
    fn by_turns<P: Predicates + ?Sized>(
        &self,
        session: &P,
        q: Vertex,
        around: &[(u32, [Vertex; 3])],
    ) -> Option<Location> {
        let points: &[[f64; 3]] = session.scene().coordinates().as_chunks().0;
        let plane = across(around.first()?.1.map(|v| points[v.index()]));
        let (mut spokes, mut over) = (Spokes::default(), None);
        for &(triangle, [a, b, c]) in around {
            let mut turn = |u: Vertex, v: Vertex| spokes.turn([u, v], || session.orient2d(plane, u, v, q));
            let turns = [turn(a, b), turn(c, a)];
            if turns.contains(&Sign::Zero) {
                return None;
            }
            if turns[0] != turns[1] || session.orient2d(plane, b, c, q) != turns[0] {
                continue;
            }
            let side = session.orient3d(a, b, c, q);
            if side.is_zero() || over.replace((triangle, side)).is_some() {
                return None;
            }
        }
        over.map(|(triangle, side)| {
            Location::In(self.mesh().sides()[triangle as usize][usize::from(side == Sign::Positive)])
        })
    }
}

/// The corners of a triangle from the one at p on, if one is there.
#[inline]
fn from(points: &[[f64; 3]], [a, b, c]: [Vertex; 3], p: [f64; 3]) -> Option<[Vertex; 3]> {
    let at = |v: Vertex| points[v.index()] == p;
    match (at(a), at(b), at(c)) {
        (true, ..) => Some([a, b, c]),
        (_, true, _) => Some([b, c, a]),
        (.., true) => Some([c, a, b]),
        _ => None,
    }
}

/// True if the box of a triangle does not contain p.
fn is_beside(triangle: [[f64; 3]; 3], p: [f64; 3]) -> bool {
    (0..3).any(|axis| triangle.iter().all(|v| v[axis] < p[axis]) || triangle.iter().all(|v| v[axis] > p[axis]))
}

/// The coordinate plane in which a triangle has about the largest area.
fn across([a, b, c]: [[f64; 3]; 3]) -> Plane {
    let area = |i: usize, j: usize| ((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i])).abs();
    let (xy, yz, zx) = (area(0, 1), area(1, 2), area(2, 0));
    if xy >= yz && xy >= zx {
        Plane::Xy
    } else if yz >= zx {
        Plane::Yz
    } else {
        Plane::Zx
    }
}
