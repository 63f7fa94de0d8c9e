//! All crossings of a set of segments, sorted along each segment, with vertices constructed at run time.
//!
//! Two segments cross if the ends of each are strictly on both sides of the other. First, all crossings are found in
//! parallel. Then their points are constructed in one call, in the order of the segments, so that ids do not depend on
//! threads. Then the crossings of each segment are sorted along it by comparing constructed points. Nothing is rounded
//! unless the session rounds.

use predicament_grid::{Columns, parallel};
use predicament_predicates::{Axis, Construction, Plane, Predicates, Refused, Sign, Vertex};

/// The crossings of one segment from its first end to its second: groups of
/// segments that cross it in one point, ascending.
pub type Along = Vec<Vec<u32>>;

/// The crossings of all segments, sorted along each.
///
/// # Errors
/// [`Refused`] if the session does not construct a crossing.
///
/// # Panics
/// If there are 2^32 segments.
pub fn crossings<P: Predicates + ?Sized>(session: &mut P, segments: &[[Vertex; 2]]) -> Result<Vec<Along>, Refused> {
    let pairs = crossing_pairs(&*session, segments);
    let definitions: Vec<Construction> =
        pairs.iter().map(|&[i, j]| Construction::Ssi([segments[i as usize], segments[j as usize]])).collect();
    let points = session.construct(&definitions)?;
    let mut of: Vec<Vec<(Vertex, u32)>> = vec![Vec::new(); segments.len()];
    for (&[i, j], &point) in pairs.iter().zip(&points) {
        of[i as usize].push((point, j));
        of[j as usize].push((point, i));
    }
    let session = &*session;
    Ok(parallel::each(segments.len(), &|at| sorted(session, segments[at], of[at].clone())))
}

/// The pairs of segments that cross, each by its indices, ascending.
fn crossing_pairs<P: Predicates + ?Sized>(session: &P, segments: &[[Vertex; 2]]) -> Vec<[u32; 2]> {
    let scene = session.scene();
    let place = |v: Vertex| [Axis::X, Axis::Y].map(|axis| scene.coordinate(axis, v));
    let ends: Vec<[[f64; 2]; 2]> = segments.iter().map(|segment| segment.map(place)).collect();
    // Segments whose closed boxes are apart do not meet. A perturbation can make only touching segments cross.
    let columns = Columns::new(&ends);
    let is_crossing = |&[i, j]: &[u32; 2]| cross(session, segments[i as usize], segments[j as usize]);
    let of = |column: usize| -> Vec<[u32; 2]> { columns.overlaps(column).filter(is_crossing).collect() };
    let mut pairs = parallel::each(columns.count(), &of).concat();
    pairs.sort_unstable();
    pairs
}

/// True if each segment's ends are strictly on both sides of the other.
fn cross<P: Predicates + ?Sized>(session: &P, [a, b]: [Vertex; 2], [p, q]: [Vertex; 2]) -> bool {
    let side = |[u, v]: [Vertex; 2], w| session.orient2d(Plane::Xy, u, v, w);
    let opposite = |one: Sign, other: Sign| one != Sign::Zero && one == -other;
    opposite(side([a, b], p), side([a, b], q)) && opposite(side([p, q], a), side([p, q], b))
}

/// The crossings in their order along a segment; crossings in one point are one group.
fn sorted<P: Predicates + ?Sized>(session: &P, [a, b]: [Vertex; 2], mut found: Vec<(Vertex, u32)>) -> Along {
    let axes = [Axis::X, Axis::Y];
    let forward = axes.map(|axis| session.compare(axis, b, a));
    let order = |u: Vertex, v: Vertex| {
        let along = |(axis, forward): (Axis, Sign)| match forward {
            // A segment perpendicular to this axis has no order along it.
            Sign::Zero => Sign::Zero,
            forward => session.compare(axis, u, v) * forward,
        };
        let signs = axes.into_iter().zip(forward).map(along);
        signs.into_iter().find(|sign| *sign != Sign::Zero).unwrap_or(Sign::Zero)
    };
    // Signs of an inconsistent session are not an order; the sort must terminate anyway.
    insertion_sort(&mut found, |u, v| order(u.0, v.0) == Sign::Negative);
    let mut along: Along = Vec::new();
    for (at, &(point, other)) in found.iter().enumerate() {
        match along.last_mut() {
            Some(group) if order(found[at - 1].0, point) == Sign::Zero => group.push(other),
            _ => along.push(vec![other]),
        }
    }
    along.iter_mut().for_each(|group| group.sort_unstable());
    along
}

/// Binary insertion sort: its number of steps does not depend on `before`.
fn insertion_sort<T: Copy>(items: &mut [T], before: impl Fn(T, T) -> bool) {
    for end in 1..items.len() {
        let item = items[end];
        let place = items[..end].partition_point(|&other| !before(item, other));
        items[place..=end].rotate_right(1);
    }
}
