//! Insertion: all triangles whose circle contains the vertex are replaced by triangles with it.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::chain::{self, is_between};
use super::locate::{Place, locate};
use super::mesh::{Edge, INFINITE, Mesh};
use super::{Contradiction, Triangulation};

/// The number of vertices that are prefetched at once.
const AHEAD: usize = 8;

/// Prefetches the points of the next vertices into the cache: the predicates read them one by one, in random order of
/// memory, and would wait each time.
#[inline]
fn touch(points: &[[f64; 2]], next: &[Vertex]) {
    for v in next.iter().take(AHEAD) {
        std::hint::black_box(points.get(v.index()));
        std::hint::black_box(points.get(v.index()).map(|point| point[0]));
    }
}

impl Triangulation {
    /// The triangulation of these vertices, inserted in this order.
    pub(super) fn in_order<P: Predicates + ?Sized>(session: &P, vertices: &[Vertex]) -> Triangulation {
        let mut triangulation =
            Triangulation { mesh: Mesh::with_capacity(2 * vertices.len()), ..Triangulation::default() };
        let Some(&first) = vertices.first() else { return triangulation };
        // Three vertices that are not collinear come first.
        let second = vertices.iter().copied().find(|&v| v != first && chain::order(session, first, v) != Sign::Zero);
        let third = second.and_then(|second| {
            let side = |v: Vertex| session.orient2d(Plane::Xy, first, second, v);
            vertices.iter().copied().filter(|&v| v != first && v != second).find(|&v| side(v) != Sign::Zero)
        });
        let (Some(second), Some(third)) = (second, third) else {
            (triangulation.chain, triangulation.copies) = chain::sorted(session, vertices);
            return triangulation;
        };
        let points = session.scene().coordinates().as_chunks::<2>().0;
        for (at, v) in [first, second, third].into_iter().chain(vertices.iter().copied()).enumerate() {
            if at % AHEAD == 0 {
                touch(points, vertices.get(at..).unwrap_or_default());
            }
            let is_first = v == first || v == second || v == third;
            if is_first && !triangulation.mesh.is_empty() {
                continue;
            }
            if let Err(broken) = triangulation.insert(session, v) {
                triangulation.broken = Some(broken);
                break;
            }
        }
        triangulation
    }

    /// Inserts a vertex.
    ///
    /// # Errors
    /// The invariant that does not hold, if signs contradict each other; the triangulation is then unchanged.
    #[inline]
    pub fn insert<P: Predicates + ?Sized>(&mut self, session: &P, v: Vertex) -> Result<(), Contradiction> {
        if self.mesh.is_empty() {
            self.insert_in_chain(session, v);
            return Ok(());
        }
        match locate(session, &self.mesh, self.near, v)? {
            Place::At(edge) => {
                self.stand_for(edge, v);
                Ok(())
            }
            Place::In(triangle) => self.replace(session, v, triangle, None),
        }
    }

    /// Replaces the triangles whose circle contains a vertex, starting from one of them. Constraints are not crossed,
    /// except the edge that the vertex is on.
    #[inline]
    pub(super) fn replace<P: Predicates + ?Sized>(
        &mut self,
        session: &P,
        v: Vertex,
        triangle: u32,
        on: Option<Edge>,
    ) -> Result<(), Contradiction> {
        self.mesh.unmark();
        self.region.fill::<true>(&mut self.mesh, triangle, |mesh, inside, outside| {
            if Some(inside) == on {
                return true;
            }
            if mesh.is_constrained(inside) {
                return false;
            }
            is_in_circle(session, mesh, outside, v)
        })?;
        // Wrong signs can keep point location from finding that the vertex is already there.
        if self.region.border.iter().any(|&outside| self.mesh.start(outside) == v) {
            return Err(Contradiction::Disc);
        }
        self.near = self.region.star(&mut self.mesh, v);
        Ok(())
    }

    fn insert_in_chain<P: Predicates + ?Sized>(&mut self, session: &P, v: Vertex) {
        if self.chain.contains(&v) {
            return;
        }
        let at = self.chain.partition_point(|&other| chain::order(session, other, v) == Sign::Negative);
        if let Some(&other) = self.chain.get(at)
            && chain::order(session, other, v) == Sign::Zero
        {
            self.chain[at] = other.min(v);
            self.copies.push([other.max(v), other.min(v)]);
            return;
        }
        let side = match self.chain[..] {
            [first, .., last] => session.orient2d(Plane::Xy, first, last, v),
            _ => Sign::Zero,
        };
        if side == Sign::Zero {
            self.chain.insert(at, v);
            return;
        }
        chain::fan(&mut self.mesh, &self.chain, v, side);
        self.chain.clear();
        self.near = 0;
    }

    /// Merges two vertices in one place: the smaller represents both.
    fn stand_for(&mut self, edge: Edge, v: Vertex) {
        let other = self.mesh.apex(edge);
        if v < other {
            self.mesh.rename(edge, v);
        }
        if v != other {
            self.copies.push([v.max(other), v.min(other)]);
        }
    }
}

/// True if a vertex is in the circle of the triangle beyond an edge.
///
/// The circle of an infinite triangle is a half-plane, with the part of its line between the edge's ends. If the vertex
/// is on the circle, the edge is marked round.
///
/// An edge between two new triangles is never round. If its four vertices are on one circle, which is empty, they were
/// a face before the new vertex came, and the triangles of that face stay.
#[inline(always)]
fn is_in_circle<P: Predicates + ?Sized>(session: &P, mesh: &mut Mesh, outside: Edge, v: Vertex) -> bool {
    let [a, b, c] = mesh.corners(outside.triangle());
    if c != INFINITE {
        let sign = session.incircle(a, b, c, v);
        mesh.set_round(outside, sign == Sign::Zero);
        return sign == Sign::Positive;
    }
    match session.orient2d(Plane::Xy, a, b, v) {
        Sign::Positive => true,
        Sign::Negative => false,
        Sign::Zero => is_between(session, a, b, v),
    }
}
