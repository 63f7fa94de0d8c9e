//! The flaws of a map: where it is not a tiling.

use predicament_predicates::{Plane, Predicates, Scene, Sign, Vertex};
use rayon::prelude::*;

use super::Edges;
use super::edge::{Place, place};

/// An edge by its two vertices, the smaller index first.
pub type Edge = [Vertex; 2];

/// The flaws of a map, each list sorted.
///
/// A tiling whose regions share their borders by vertex has no flaws. Under a perturbation that moves vertices by
/// identity, each flaw can open a gap or an overlap as thin as the perturbation.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Flaws {
    /// Distinct vertices with equal coordinates: each with the first of its group.
    pub duplicates: Vec<[Vertex; 2]>,
    /// A vertex of the map between the ends of an edge that does not contain it as an end.
    pub junctions: Vec<(Edge, Vertex)>,
    /// Edges that cross in one point between the ends of both.
    pub crossings: Vec<[Edge; 2]>,
    /// Edges on one line that have more than a point in common.
    pub overlaps: Vec<[Edge; 2]>,
}

impl Flaws {
    /// The number of flaws of all kinds.
    #[must_use]
    pub fn len(&self) -> usize {
        self.duplicates.len() + self.junctions.len() + self.crossings.len() + self.overlaps.len()
    }

    /// True if the map has no flaws.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Finds every flaw of the map with these edges.
///
/// `exact` must return exact signs; otherwise the result means nothing. The time grows with the number of pairs of
/// edges whose boxes meet.
///
/// # Panics
/// If the session's scene is not the one of the edges.
#[must_use]
pub fn map_flaws<P: Predicates + ?Sized>(edges: &Edges, exact: &P) -> Flaws {
    let vertices = used_vertices(edges);
    let mut flaws = Flaws {
        duplicates: duplicates(exact.scene(), &vertices),
        junctions: junctions(edges, exact, &vertices),
        ..Flaws::default()
    };
    let pairs: Vec<(Meeting, [Edge; 2])> = (0..edges.len())
        .into_par_iter()
        .flat_map_iter(|at| {
            let one = edges.all()[at].0;
            edges.meeting(at).filter_map(move |other| Some((meeting(exact, [one, other])?, [one, other])))
        })
        .collect();
    for (meeting, [e, f]) in pairs {
        let pair = [e.min(f), e.max(f)];
        match meeting {
            Meeting::Crossing => flaws.crossings.push(pair),
            Meeting::Overlap => flaws.overlaps.push(pair),
        }
    }
    flaws.crossings.sort_unstable();
    flaws.overlaps.sort_unstable();
    flaws
}

fn used_vertices(edges: &Edges) -> Vec<Vertex> {
    let mut vertices: Vec<Vertex> = edges.all().iter().flat_map(|(ends, _)| *ends).collect();
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

fn duplicates(scene: &Scene, vertices: &[Vertex]) -> Vec<[Vertex; 2]> {
    // adding zero makes −0 the same as 0, to the total order too
    let mut placed: Vec<([f64; 2], Vertex)> =
        vertices.iter().map(|&v| (scene.point2(Plane::Xy, v).map(|c| c + 0.0), v)).collect();
    placed.sort_unstable_by(|(a, v), (b, w)| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(v.cmp(w)));
    let groups = placed.chunk_by(|(a, _), (b, _)| a == b);
    let mut pairs: Vec<[Vertex; 2]> =
        groups.flat_map(|group| group[1..].iter().map(|(_, other)| [group[0].1, *other])).collect();
    pairs.sort_unstable();
    pairs
}

fn junctions<P: Predicates + ?Sized>(edges: &Edges, exact: &P, vertices: &[Vertex]) -> Vec<(Edge, Vertex)> {
    let mut found: Vec<(Edge, Vertex)> = vertices
        .par_iter()
        .flat_map_iter(|&vertex| {
            let point = exact.scene().point2(Plane::Xy, vertex);
            let above = edges.above(point).into_iter().map(|edge| edges.all()[edge as usize].0);
            above.filter(move |&ends| place(exact, ends, vertex) == Place::Between).map(move |ends| (ends, vertex))
        })
        .collect();
    found.sort_unstable();
    found
}

enum Meeting {
    Crossing,
    Overlap,
}

fn meeting<P: Predicates + ?Sized>(exact: &P, [[a, b], [c, d]]: [Edge; 2]) -> Option<Meeting> {
    let side = |p, q, r| exact.orient2d(Plane::Xy, p, q, r);
    let (of_c, of_d) = (side(a, b, c), side(a, b, d));
    if of_c.is_zero() && of_d.is_zero() {
        return share_length(exact.scene(), [[a, b], [c, d]]).then_some(Meeting::Overlap);
    }
    let crosses = of_c * of_d == Sign::Negative && side(c, d, a) * side(c, d, b) == Sign::Negative;
    crosses.then_some(Meeting::Crossing)
}

/// True if two edges on one line have more than a point in common. The order of raw coordinates is exact.
fn share_length(scene: &Scene, edges: [Edge; 2]) -> bool {
    let axis_with_extent = |axis: usize| {
        let [e, f] = edges.map(|edge| edge.map(|v| scene.point2(Plane::Xy, v)[axis]));
        e[0].min(e[1]).max(f[0].min(f[1])) < e[0].max(e[1]).min(f[0].max(f[1]))
    };
    axis_with_extent(0) || axis_with_extent(1)
}

#[cfg(test)]
mod tests;
