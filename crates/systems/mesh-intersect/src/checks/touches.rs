//! Whether two meshes touch: whether an edge of one meets a triangle of the other at an end, at the border, or along a
//! part.
//!
//! All pairs are compared, by a sweep along one axis and in rationals.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use predicament_predicates::Vertex;
use rug::Rational;

use super::{Laws, Point};

impl Laws<'_> {
    /// True if a vertex of one mesh is on the other mesh, or two edges meet.
    #[must_use]
    pub fn touches(&self) -> bool {
        (0..2).any(|mesh| self.edge_touches(mesh))
    }

    /// True if an edge of a mesh touches a triangle of the other one.
    fn edge_touches(&self, mesh: usize) -> bool {
        let triangles = self.meshes[1 - mesh].triangles();
        let edges: BTreeSet<[Vertex; 2]> = self.meshes[mesh]
            .triangles()
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        let low = |vertices: &[Vertex], axis: usize| -> f64 {
            vertices.iter().map(|&v| self.scene.point3(v)[axis]).fold(f64::INFINITY, f64::min)
        };
        let high = |vertices: &[Vertex], axis: usize| -> f64 {
            vertices.iter().map(|&v| self.scene.point3(v)[axis]).fold(f64::NEG_INFINITY, f64::max)
        };
        let mut sorted: Vec<(f64, &[Vertex; 3])> = triangles.iter().map(|t| (low(t, 0), t)).collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        edges.iter().any(|edge| {
            let end = sorted.partition_point(|(from, _)| *from <= high(edge, 0));
            sorted[..end].iter().any(|(_, triangle)| {
                (0..3).all(|axis| {
                    low(&triangle[..], axis) <= high(edge, axis) && low(edge, axis) <= high(&triangle[..], axis)
                }) && touch(edge.map(|v| &self.points[v.index()]), triangle.map(|v| &self.points[v.index()]))
            })
        })
    }
}

/// Six times the volume of a tetrahedron.
fn volume([a, b, c, d]: [&Point; 4]) -> Rational {
    let side = |p: &Point| [0, 1, 2].map(|axis: usize| Rational::from(&p[axis] - &d[axis]));
    let [p, q, r] = [side(a), side(b), side(c)];
    let minor = |i: usize, j: usize| Rational::from(&p[i] * &q[j]) - Rational::from(&p[j] * &q[i]);
    minor(1, 2) * &r[0] + minor(2, 0) * &r[1] + minor(0, 1) * &r[2]
}

fn sign(of: [&Point; 4]) -> i32 {
    match volume(of).cmp0() {
        Ordering::Less => -1,
        Ordering::Equal => 0,
        Ordering::Greater => 1,
    }
}

/// True if a closed edge meets a closed triangle, except if it passes from one side through the inside.
fn touch([p, q]: [&Point; 2], [a, b, c]: [&Point; 3]) -> bool {
    let sides = [sign([a, b, c, p]), sign([a, b, c, q])];
    if sides[0] * sides[1] > 0 {
        return false;
    }
    if sides == [0, 0] {
        return flat_touch([p, q], [a, b, c]);
    }
    let turns = [[a, b], [b, c], [c, a]].map(|[u, v]| sign([p, q, u, v]));
    let is_outside = turns.contains(&1) && turns.contains(&-1);
    !is_outside && (turns.contains(&0) || sides.contains(&0))
}

/// True if an edge meets a triangle in one plane: it ends in the triangle, or meets an edge of it.
fn flat_touch([p, q]: [&Point; 2], [a, b, c]: [&Point; 3]) -> bool {
    let turn = |[i, j]: [usize; 2], a: &Point, b: &Point, c: &Point| {
        let product = |i: usize, j: usize| Rational::from(&b[i] - &a[i]) * Rational::from(&c[j] - &a[j]);
        product(i, j).cmp(&product(j, i)) as i32
    };
    let Some(axes) = [[0, 1], [1, 2], [2, 0]].into_iter().find(|&axes| turn(axes, a, b, c) != 0) else { return true };
    let turn = |a: &Point, b: &Point, c: &Point| turn(axes, a, b, c);
    let inside = turn(a, b, c);
    let edges = [[a, b], [b, c], [c, a]];
    let is_in = |p: &Point| edges.iter().all(|[u, v]| turn(u, v, p) * inside >= 0);
    let is_across = |[u, v]: [&Point; 2], [p, q]: [&Point; 2]| turn(u, v, p) * turn(u, v, q) <= 0;
    // Two segments of one line meet if an end of one is in the other: then, of an edge without an end in the triangle,
    // corners are between its ends.
    let meets = |edge: [&Point; 2]| {
        let is_in_line = turn(p, q, edge[0]) == 0 && turn(p, q, edge[1]) == 0;
        let is_between = |v: &Point| (0..3).all(|k| (p[k] <= v[k] && v[k] <= q[k]) || (q[k] <= v[k] && v[k] <= p[k]));
        if is_in_line { edge.iter().any(|v| is_between(v)) } else { is_across(edge, [p, q]) && is_across([p, q], edge) }
    };
    is_in(p) || is_in(q) || edges.into_iter().any(meets)
}
