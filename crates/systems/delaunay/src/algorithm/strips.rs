//! Large scenes: triangulations of vertical strips, in parallel, joined by flips.
//!
//! The cuts depend on the points alone, so the answer of any session does not depend on the number of threads. Two
//! triangulations with a line between them are joined in two steps. First, the corridor between their hulls, from the
//! lower to the upper common tangent, is filled with triangles. Then edges are flipped, from the corridor outwards,
//! until every edge is Delaunay (Lawson 1977).
//!
//! Points with one x are in one strip. Exact signs therefore separate the strips, and so do the signs of perturbed
//! points. If a strip is broken or has only collinear vertices, or if signs contradict each other, the caller inserts
//! all vertices one by one.

use predicament_grid::parallel;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::mesh::{Edge, INFINITE, Mesh};
use super::{Contradiction, Triangulation, order};

/// The number of sampled points for each cut.
const SAMPLED: usize = 256;

/// The triangulation; `None` if strips can't be joined.
pub(super) fn in_strips<P: Predicates + ?Sized>(session: &P, count: usize) -> Option<Triangulation> {
    let points = session.scene().coordinates().as_chunks().0;
    if points.is_empty() {
        return None;
    }
    let ends = [vec![f64::NEG_INFINITY], cuts(points, count), vec![f64::INFINITY]].concat();
    built(session, points, &ends)
}

/// The abscissas between strips of about equal numbers of points, ascending; a strip includes its left cut.
fn cuts(points: &[[f64; 2]], count: usize) -> Vec<f64> {
    let mut sample: Vec<f64> =
        points.iter().step_by((points.len() / (count * SAMPLED)).max(1)).map(|point| point[0]).collect();
    sample.sort_unstable_by(f64::total_cmp);
    let mut cuts: Vec<f64> = (1..count).map(|at| sample[at * sample.len() / count]).collect();
    cuts.dedup();
    cuts
}

/// The triangulation of adjacent strips between these ends.
fn built<P: Predicates + ?Sized>(session: &P, points: &[[f64; 2]], ends: &[f64]) -> Option<Triangulation> {
    if let [low, high] = ends {
        let strip = points.iter().zip(0..).filter(|([x, _], _)| low <= x && x < high).map(|(_, at)| at);
        let triangulation = Triangulation::in_order(session, &order::insertion_order(points, strip.collect()));
        return (triangulation.broken.is_none() && !triangulation.mesh.is_empty()).then_some(triangulation);
    }
    let middle = ends.len() / 2;
    let [left, right] =
        parallel::both(&|| built(session, points, &ends[..=middle]), &|| built(session, points, &ends[middle..]));
    joined(session, left?, right?).ok()
}

/// Joins two triangulations, the first left of the second.
fn joined<P: Predicates + ?Sized>(
    session: &P,
    mut left: Triangulation,
    right: Triangulation,
) -> Result<Triangulation, Contradiction> {
    let mut corners = [utmost(session, &left.mesh, Sign::Positive)?, utmost(session, &right.mesh, Sign::Negative)?];
    let offset = left.mesh.append(right.mesh);
    corners[1] += offset;
    left.copies.extend(right.copies);
    let mut open = fill(session, &mut left.mesh, corners)?;
    flip(session, &mut left.mesh, &mut open)?;
    Ok(left)
}

/// The infinite triangle beyond the hull edge that goes counterclockwise.
///
/// It begins at the vertex that is utmost along x; of several such vertices, at any of them.
fn utmost<P: Predicates + ?Sized>(session: &P, mesh: &Mesh, side: Sign) -> Result<u32, Contradiction> {
    let is_hull = |&triangle: &u32| mesh.is_infinite(triangle) && from(mesh, triangle) != INFINITE;
    let first = (0..mesh.len()).find(is_hull).ok_or(Contradiction::Hull)?;
    let hull = std::iter::successors(Some(first), |&at| Some(next(mesh, at)).filter(|&next| next != first));
    let mut best = first;
    for at in hull.take(mesh.len() as usize) {
        let axis = predicament_predicates::Axis::X;
        if session.compare(axis, from(mesh, at), from(mesh, best)) == side {
            best = at;
        }
    }
    Ok(best)
}

// An infinite triangle stands for its hull edge, which goes counterclockwise around the hull.

fn from(mesh: &Mesh, hull: u32) -> Vertex {
    mesh.corners(hull)[1]
}

fn to(mesh: &Mesh, hull: u32) -> Vertex {
    mesh.corners(hull)[0]
}

/// The hull edge that begins where this one ends.
fn next(mesh: &Mesh, hull: u32) -> u32 {
    mesh.across(Edge::new(hull, 1)).triangle()
}

/// The hull edge that ends where this one begins.
fn previous(mesh: &Mesh, hull: u32) -> u32 {
    mesh.across(Edge::new(hull, 0)).triangle()
}

/// Links two hull edges as neighbours on the hull.
fn follow(mesh: &mut Mesh, hull: u32, next: u32) {
    mesh.link(Edge::new(hull, 1), Edge::new(next, 0));
}

/// Fills the corridor between two hulls with triangles, and returns their edges.
///
/// The hull edges given begin at the rightmost vertex of the left hull and at the leftmost vertex of the right one.
fn fill<P: Predicates + ?Sized>(
    session: &P,
    mesh: &mut Mesh,
    [mut a, mut b]: [u32; 2],
) -> Result<Vec<Edge>, Contradiction> {
    let turn = |a, b, c| session.orient2d(Plane::Xy, a, b, c);
    let mut steps = 0..mesh.len();
    // Down to the lower tangent: a begins at its left end, and b at its right end.
    loop {
        steps.next().ok_or(Contradiction::Hull)?;
        let [l, r] = [from(mesh, a), from(mesh, b)];
        if turn(l, r, from(mesh, previous(mesh, a))) == Sign::Negative {
            a = previous(mesh, a);
        } else if turn(l, r, to(mesh, b)) == Sign::Negative {
            b = next(mesh, b);
        } else {
            break;
        }
    }
    let (before, after) = (previous(mesh, a), b);
    let [mut l, mut r] = [from(mesh, a), from(mesh, b)];
    // Upwards, b is the hull edge that ends at the right end.
    b = previous(mesh, b);
    let mut base = mesh.add(INFINITE, r, l);
    let bottom = base.triangle();
    let mut filled = Vec::new();
    loop {
        steps.next().ok_or(Contradiction::Hull)?;
        let [left, right] = [to(mesh, a), from(mesh, b)];
        let [is_left, is_right] = [left, right].map(|v| turn(l, r, v) == Sign::Positive);
        if !is_left && !is_right {
            break;
        }
        let is_left = is_left && !(is_right && session.incircle(l, r, left, right) == Sign::Positive);
        // A hull whose edges are all passed has no upper tangent.
        if a == before || b == after {
            return Err(Contradiction::Hull);
        }
        let (passed, apex) = if is_left { (a, left) } else { (b, right) };
        let inner = mesh.across(Edge::new(passed, 2));
        [a, b] = if is_left { [next(mesh, a), b] } else { [a, previous(mesh, b)] };
        mesh.free(passed);
        let edge = mesh.add(apex, l, r);
        mesh.link(edge, base);
        filled.extend([edge, edge.next(), edge.previous()]);
        if is_left {
            mesh.link(edge.previous(), inner);
            (l, base) = (apex, edge.next());
        } else {
            mesh.link(edge.next(), inner);
            (r, base) = (apex, edge.previous());
        }
    }
    let edge = mesh.add(INFINITE, l, r);
    mesh.link(edge, base);
    let top = edge.triangle();
    follow(mesh, before, bottom);
    follow(mesh, bottom, after);
    follow(mesh, b, top);
    follow(mesh, top, a);
    Ok(filled)
}

/// Flips edges until all are Delaunay, beginning with those that are `open`.
fn flip<P: Predicates + ?Sized>(session: &P, mesh: &mut Mesh, open: &mut Vec<Edge>) -> Result<(), Contradiction> {
    // With signs that do not contradict each other, no edge comes back once it is flipped.
    let mut steps = 0..u64::from(mesh.len()) << 6;
    while let Some(edge) = open.pop() {
        steps.next().ok_or(Contradiction::Flips)?;
        let outside = mesh.across(edge);
        let (Some([a, b, c]), Some(_)) = (mesh.solid(edge.triangle()), mesh.solid(outside.triangle())) else {
            continue;
        };
        let sign = session.incircle(a, b, c, mesh.apex(outside));
        mesh.set_round(edge, sign == Sign::Zero);
        mesh.set_round(outside, sign == Sign::Zero);
        if sign == Sign::Positive {
            open.extend(mesh.flip(edge));
        }
    }
    Ok(())
}
