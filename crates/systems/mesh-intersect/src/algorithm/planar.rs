//! Triangulations of points in the plane that contain given edges.
//!
//! A sweep over the points, from left to right, adds each to the convex hull of those before it. Then edges are flipped
//! until the given edges exist (Sloan, *A fast algorithm for generating constrained Delaunay triangulations*, 1993).
//! Isolated points and chains with a free end need no special treatment, as they would with loops.

use crate::algorithm::overlay::SurfaceContradiction;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

/// Points seen in a coordinate plane.
pub(crate) struct Points<'a> {
    pub session: &'a dyn Predicates,
    pub plane: Plane,
    /// The vertices, all at different positions.
    pub vertices: &'a [Vertex],
}

impl Points<'_> {
    fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        let [a, b, c] = [a, b, c].map(|at| self.vertices[at as usize]);
        self.session.orient2d(self.plane, a, b, c)
    }

    /// The indices of all points, from left to right, and from bottom to top if their x is equal.
    fn sorted(&self) -> Vec<u32> {
        let mut order: Vec<u32> = (0..).take(self.vertices.len()).collect();
        let [first, second] = self.plane.axes();
        predicament_grid::sort::sort_by_sign(&mut order, |a, b| {
            let [a, b] = [a, b].map(|at| self.vertices[at as usize]);
            match self.session.compare(first, a, b) {
                Sign::Zero => self.session.compare(second, a, b),
                sign => sign,
            }
        });
        order
    }

    /// Triangles of the convex hull, counterclockwise, as indices of points; each given edge is an edge of a triangle.
    ///
    /// # Errors
    /// The invariant that signs break.
    pub fn triangulated(&self, edges: &[[u32; 2]]) -> Result<Vec<[u32; 3]>, SurfaceContradiction> {
        let mut mesh = self.swept();
        let wanted: BTreeSet<[u32; 2]> = edges.iter().map(|&[a, b]| [a.min(b), a.max(b)]).collect();
        for &[a, b] in &wanted {
            self.enforce(&mut mesh, [a, b], &wanted)?;
        }
        Ok(mesh.triangles())
    }

    /// The triangulation of the sweep; without triangles if all points are on one line.
    fn swept(&self) -> Mesh {
        let order = self.sorted();
        let mut mesh = Mesh::default();
        let off = (2..order.len()).find(|&at| !self.turn(order[0], order[1], order[at]).is_zero());
        let Some(off) = off else { return mesh };
        // The hull, counterclockwise: the next and the previous point of each point.
        let mut hull: Vec<u32> = order[..off].to_vec();
        let is_left = self.turn(order[0], order[1], order[off]) == Sign::Positive;
        if !is_left {
            hull.reverse();
        }
        hull.windows(2).for_each(|pair| mesh.add([pair[0], pair[1], order[off]]));
        hull.push(order[off]);
        let mut around = Hull { next: vec![0; order.len()], before: vec![0; order.len()] };
        hull.iter().zip(hull.iter().cycle().skip(1)).for_each(|(&a, &b)| around.link(a, b));
        let mut last = order[off];
        for (at, &point) in order.iter().enumerate().skip(off + 1) {
            let (mut ahead, mut back) = (last, last);
            // Its left neighbour is on the hull, so a part of the hull is not visible.
            for _ in 0..at {
                let next = around.next[ahead as usize];
                if self.turn(ahead, next, point) != Sign::Negative {
                    break;
                }
                mesh.add([next, ahead, point]);
                ahead = next;
            }
            for _ in 0..at {
                let before = around.before[back as usize];
                if self.turn(before, back, point) != Sign::Negative {
                    break;
                }
                mesh.add([back, before, point]);
                back = before;
            }
            around.link(back, point);
            around.link(point, ahead);
            last = point;
        }
        mesh
    }

    /// Flips edges until the given edge exists.
    fn enforce(
        &self,
        mesh: &mut Mesh,
        [a, b]: [u32; 2],
        wanted: &BTreeSet<[u32; 2]>,
    ) -> Result<(), SurfaceContradiction> {
        if mesh.has([a, b]) {
            return Ok(());
        }
        let mut crossed = self.crossed(mesh, [a, b])?;
        if crossed.iter().any(|&[u, w]| wanted.contains(&[u.min(w), u.max(w)])) {
            return Err(SurfaceContradiction::Planar);
        }
        // Each pass over the edges leaves fewer of them.
        let mut left = 16 + crossed.len().saturating_pow(2).saturating_mul(4);
        while let Some([u, w]) = crossed.pop_front() {
            left = left.checked_sub(1).ok_or(SurfaceContradiction::Planar)?;
            let (Some(c), Some(d)) = (mesh.across([u, w]), mesh.across([w, u])) else {
                return Err(SurfaceContradiction::Planar);
            };
            let is_convex = self.turn(c, u, d) == Sign::Positive && self.turn(d, w, c) == Sign::Positive;
            if !is_convex {
                crossed.push_back([u, w]);
                continue;
            }
            mesh.flip([u, w], [c, d]);
            let is_end = |v: u32| v == a || v == b;
            if !is_end(c) && !is_end(d) && self.turn(a, b, c) == -self.turn(a, b, d) {
                crossed.push_back([c, d]);
            }
        }
        mesh.has([a, b]).then_some(()).ok_or(SurfaceContradiction::Planar)
    }

    /// The edges that cross the segment from one point to another.
    fn crossed(&self, mesh: &Mesh, [a, b]: [u32; 2]) -> Result<VecDeque<[u32; 2]>, SurfaceContradiction> {
        let is_ahead =
            |&(u, w): &(u32, u32)| self.turn(a, u, b) == Sign::Positive && self.turn(a, w, b) == Sign::Negative;
        let (mut right, mut left) = mesh.around(a).find(is_ahead).ok_or(SurfaceContradiction::Planar)?;
        let mut crossed = VecDeque::new();
        loop {
            crossed.push_back([right, left]);
            let beyond = mesh.across([left, right]).ok_or(SurfaceContradiction::Planar)?;
            if beyond == b {
                return Ok(crossed);
            }
            match self.turn(a, b, beyond) {
                Sign::Positive => left = beyond,
                Sign::Negative => right = beyond,
                Sign::Zero => return Err(SurfaceContradiction::Planar),
            }
            if crossed.len() > mesh.apices.len() {
                return Err(SurfaceContradiction::Planar);
            }
        }
    }
}

/// The border of a convex hull, counterclockwise.
struct Hull {
    next: Vec<u32>,
    before: Vec<u32>,
}

impl Hull {
    fn link(&mut self, a: u32, b: u32) {
        self.next[a as usize] = b;
        self.before[b as usize] = a;
    }
}

/// Triangles by their edges.
#[derive(Default)]
struct Mesh {
    /// For each edge in the direction of a triangle, its third corner.
    apices: BTreeMap<(u32, u32), u32>,
}

impl Mesh {
    fn add(&mut self, [a, b, c]: [u32; 3]) {
        self.apices.extend([((a, b), c), ((b, c), a), ((c, a), b)]);
    }

    fn has(&self, [a, b]: [u32; 2]) -> bool {
        self.apices.contains_key(&(a, b)) || self.apices.contains_key(&(b, a))
    }

    fn across(&self, [a, b]: [u32; 2]) -> Option<u32> {
        self.apices.get(&(a, b)).copied()
    }

    /// The other two corners of each triangle at a point.
    fn around(&self, a: u32) -> impl Iterator<Item = (u32, u32)> {
        self.apices.range((a, 0)..=(a, u32::MAX)).map(|(&(_, u), &w)| (u, w))
    }

    /// Replaces the edge of two triangles by the one between their other corners.
    fn flip(&mut self, [u, w]: [u32; 2], [c, d]: [u32; 2]) {
        self.apices.remove(&(u, w));
        self.apices.remove(&(w, u));
        self.add([u, d, c]);
        self.add([d, w, c]);
    }

    /// The triangles, each once, ascending by the least corner, which comes first.
    fn triangles(&self) -> Vec<[u32; 3]> {
        let all = self.apices.iter().map(|(&(a, b), &c)| [a, b, c]);
        all.filter(|[a, b, c]| a < b && a < c).collect()
    }
}
