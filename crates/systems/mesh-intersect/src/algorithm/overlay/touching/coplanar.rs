//! Two triangles in one plane.
//!
//! Their intersection is convex. Its corners are corners of either triangle in the other, and points where an edge of
//! one crosses an edge of the other. The part of an edge in the other triangle is between the two corners on it.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::found::{Found, Pair, Simplex};
use super::triangle::Triangle;

/// The turns of corners at the edges of the other triangle.
struct Turns<'a> {
    session: &'a dyn Predicates,
    plane: Plane,
    /// The orientation of each triangle in the plane.
    orientations: [Sign; 2],
}

impl Turns<'_> {
    /// The side of an edge of a triangle on which a vertex is: positive inside.
    fn of(&self, mesh: usize, [a, b]: [Vertex; 2], v: Vertex) -> Sign {
        if v == a || v == b { Sign::Zero } else { self.session.orient2d(self.plane, a, b, v) * self.orientations[mesh] }
    }
}

/// Adds the points of two triangles in one plane.
pub(super) fn add(session: &dyn Predicates, triangles: [&Triangle; 2], found: &mut Found) {
    let turn = |plane: Plane, mesh: usize| {
        let [a, b, c] = triangles[mesh].corners;
        session.orient2d(plane, a, b, c)
    };
    let seen = [Plane::Xy, Plane::Yz, Plane::Zx].into_iter().map(|plane| (plane, turn(plane, 0)));
    let Some((plane, first)) = seen.into_iter().find(|(_, turn)| !turn.is_zero()) else { return };
    let turns = Turns { session, plane, orientations: [first, turn(plane, 1)] };
    // For each mesh, the sides of the other's edges on which its corners are.
    let sides: [[[Sign; 3]; 3]; 2] = [0, 1].map(|mesh: usize| {
        let [a, b, c] = triangles[1 - mesh].corners;
        let edges = [[a, b], [b, c], [c, a]];
        triangles[mesh].corners.map(|v| edges.map(|ends| turns.of(1 - mesh, ends, v)))
    });
    let is_beyond = |corners: &[[Sign; 3]; 3], edge: usize| corners.iter().all(|of| of[edge] == Sign::Negative);
    if sides.iter().any(|corners| (0..3).any(|edge| is_beyond(corners, edge))) {
        return;
    }
    // Each point with the edges of both triangles through it, a bit for each.
    let mut points: Vec<(Pair, [u8; 2])> = Vec::with_capacity(6);
    let around = |corner: usize| 1_u8 << corner | 1 << ((corner + 2) % 3);
    for mesh in [0, 1] {
        let (own, other) = (triangles[mesh], triangles[1 - mesh]);
        for (corner, of) in sides[mesh].iter().enumerate() {
            if of.contains(&Sign::Negative) {
                continue;
            }
            let v = own.corners[corner];
            let through = (0..3).fold(0, |bits, edge| bits | u8::from(of[edge].is_zero()) << edge);
            let there = match through.trailing_zeros() as usize {
                _ if through.count_ones() > 1 => Simplex::Vertex(v),
                edge @ 0..3 => Simplex::Edge(other.edges[edge]),
                _ => Simplex::Triangle(other.place),
            };
            if mesh == 1 && there == Simplex::Vertex(v) {
                // Found as a corner of the first triangle.
                continue;
            }
            let (pair, edges) = ([Simplex::Vertex(v), there], [around(corner), through]);
            points.push(if mesh == 0 { (pair, edges) } else { ([pair[1], pair[0]], [edges[1], edges[0]]) });
        }
    }
    for i in 0..3 {
        for j in 0..3 {
            let crosses = |mesh: usize, corner: usize, edge: usize| {
                let [from, to] = [corner, (corner + 1) % 3].map(|corner| sides[mesh][corner][edge]);
                !from.is_zero() && from == -to
            };
            if crosses(0, i, j) && crosses(1, j, i) {
                points.push((
                    [Simplex::Edge(triangles[0].edges[i]), Simplex::Edge(triangles[1].edges[j])],
                    [1 << i, 1 << j],
                ));
            }
        }
    }
    found.points.extend(points.iter().map(|(pair, _)| *pair));
    for mesh in [0, 1] {
        for edge in 0..3 {
            let mut on = points.iter().filter(|(_, edges)| edges[mesh] >> edge & 1 == 1);
            let (Some(from), Some(to)) = (on.next(), on.next()) else { continue };
            let both = from.1[1 - mesh] & to.1[1 - mesh];
            let other = triangles[1 - mesh];
            let there = match both.trailing_zeros() as usize {
                other_edge @ 0..3 => Simplex::Edge(other.edges[other_edge]),
                _ => Simplex::Triangle(other.place),
            };
            let own = Simplex::Edge(triangles[mesh].edges[edge]);
            let of = if mesh == 0 { [own, there] } else { [there, own] };
            found.add(of, [from.0, to.0]);
        }
    }
}
