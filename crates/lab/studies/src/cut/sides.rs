//! The side of each vertex of the lattice, from the contacts registered on its edges.

use predicament_contacts::algorithm::pairs::Contacts;
use predicament_mesh::{Complex, Simplex};
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

/// The consequences of contacts for vertices and edges of the lattice.
#[derive(Clone, PartialEq, Debug)]
pub struct Sides {
    /// For each vertex, true if it is inside; `None` if it is on the surface.
    pub inside: Vec<Option<bool>>,
    /// The points where the surface passes through each edge: shares of the way from its first end, ascending.
    pub points: Vec<Vec<f64>>,
    /// For each edge, true if a simplex more degenerate than a triangle passes through it.
    ///
    /// Then a point need not be a change of sides.
    pub degenerate: Vec<bool>,
    /// The indices of edges whose points contradict the sides of their ends.
    pub contradicted: Vec<u32>,
    /// The number of vertex sets that no edge connects: a vertex of each was located.
    pub located: usize,
    /// The number of unknown vertices, where no connected vertex could be located.
    pub unknown: usize,
}

/// The sides of vertices from contacts.
///
/// An edge with an even number of piercings has its ends on one side, with an odd number on both. Edges with an end on
/// the surface, or that meet its vertices or edges, give no information. An edge is also ignored if all its faces are
/// pierced an odd number of times along their boundary: then the edge itself is wrong. `session` locates one vertex of
/// each set that the other edges connect, by a ray upwards.
///
/// # Panics
/// If the contacts are of other complexes.
pub fn sides<S: Predicates + ?Sized>(session: &S, [lattice, surface]: [&Complex; 2], contacts: &Contacts) -> Sides {
    let edges = lattice.edges();
    let mut on = vec![false; lattice.vertices().len()];
    let mut points = vec![Vec::new(); edges.len()];
    let mut degenerate = vec![false; edges.len()];
    for contact in &contacts.registered {
        let Simplex { rank, index } = contact.a;
        match rank {
            0 => on[index as usize] = true,
            1 => {
                // The second weight is the share of the way to the second end.
                points[index as usize].push(contact.on_a[1]);
                degenerate[index as usize] |= contact.b.rank < 2;
            }
            _ => {}
        }
    }
    points.iter_mut().for_each(|points| points.sort_unstable_by(f64::total_cmp));
    let place = |v: Vertex| lattice.vertices().binary_search(&v).expect("an edge's vertex");
    let says = |at: usize| !degenerate[at] && edges[at].iter().all(|&v| !on[place(v)]);
    let trusted = trusted(lattice, &points, says);
    let mut around: Vec<Vec<(usize, usize)>> = vec![Vec::new(); on.len()];
    for (at, edge) in edges.iter().enumerate() {
        let [p, q] = edge.map(place);
        if says(at) && trusted[at] {
            around[p].push((at, q));
            around[q].push((at, p));
        }
    }
    let mut found =
        Sides { inside: vec![None; on.len()], points, degenerate, contradicted: Vec::new(), located: 0, unknown: 0 };
    let mut set_of = vec![false; on.len()];
    for start in 0..on.len() {
        if on[start] || set_of[start] {
            continue;
        }
        // Sides relative to the side of the start.
        let mut relative = vec![(start, false)];
        set_of[start] = true;
        let mut next = 0;
        while let Some(&(at, other)) = relative.get(next) {
            next += 1;
            for &(edge, to) in &around[at] {
                if !set_of[to] {
                    set_of[to] = true;
                    relative.push((to, other != (found.points[edge].len() % 2 == 1)));
                }
            }
        }
        let known = relative
            .iter()
            .find_map(|&(at, other)| locate(session, surface, lattice.vertices()[at]).map(|inside| inside != other));
        found.located += 1;
        match known {
            Some(first) => relative.iter().for_each(|&(at, other)| found.inside[at] = Some(first != other)),
            None => found.unknown += relative.len(),
        }
    }
    for (at, edge) in edges.iter().enumerate() {
        if let ([Some(p), Some(q)], false) = (edge.map(place).map(|at| found.inside[at]), found.degenerate[at])
            && (p != q) != (found.points[at].len() % 2 == 1)
        {
            found.contradicted.push(u32::try_from(at).expect("a complex holds so many edges"));
        }
    }
    found
}

/// For each edge, true if a face has a boundary that is pierced an even number of times, or no face gives information.
fn trusted(lattice: &Complex, points: &[Vec<f64>], says: impl Fn(usize) -> bool) -> Vec<bool> {
    let (mut even, mut odd) = (vec![false; points.len()], vec![false; points.len()]);
    for &[a, b, c] in lattice.triangles() {
        let edges = [[a, b], [a, c], [b, c]]
            .map(|edge| lattice.find(&edge).expect("a complex has the faces of its simplices").index as usize);
        if edges.iter().all(|&edge| says(edge)) {
            let count: usize = edges.iter().map(|&edge| points[edge].len()).sum();
            let seen = if count.is_multiple_of(2) { &mut even } else { &mut odd };
            edges.iter().for_each(|&edge| seen[edge] = true);
        }
    }
    even.into_iter().zip(odd).map(|(even, odd)| even || !odd).collect()
}

/// Returns true if a ray upwards passes through the surface an odd number of times.
///
/// `None` if it passes through an edge, or the vertex is on a triangle.
fn locate<S: Predicates + ?Sized>(session: &S, surface: &Complex, q: Vertex) -> Option<bool> {
    let mut inside = false;
    for &[a, b, c] in surface.triangles() {
        let around = [[a, b], [b, c], [c, a]].map(|[u, v]| session.orient2d(Plane::Xy, u, v, q));
        let [some, other] =
            [Sign::Positive, Sign::Negative].map(|sign| around.iter().all(|&side| side == sign || side == Sign::Zero));
        if !some && !other {
            continue;
        }
        if around.contains(&Sign::Zero) {
            return None;
        }
        // The triangle is above if it sees the vertex as it sees a point far below.
        let turn = if some { Sign::Positive } else { Sign::Negative };
        match session.orient3d(a, b, c, q) * turn {
            Sign::Zero => return None,
            side => inside ^= side == BELOW,
        }
    }
    Some(inside)
}

/// The sign of `orient3d` for a triangle wound positively, seen from above, and a point below it.
const BELOW: Sign = Sign::Positive;
