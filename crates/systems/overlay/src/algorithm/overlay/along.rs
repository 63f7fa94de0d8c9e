//! The vertices on each segment: crossings and touches, and their order along it.
//!
//! Vertices are sorted by rounded coordinates first, and then by signs. In most cases the signs change nothing, and all
//! neighbours are compared in one batch.

use predicament_grid::sort::merge_runs;
use predicament_predicates::{Axis, Construction, Plane, Predicates, Refused, Scene, Sign, Vertex};

use super::groups::grouped;
use super::meet::{Meetings, Pair};
use super::supports::Supports;
use super::view::{Along, View};
use super::{NONE, number, partial};

/// The inner vertices of each segment, unsorted.
pub(super) struct OnSegments {
    pub first: Vec<u32>,
    pub vertices: Vec<Inner>,
    /// Pairs of vertices at one position.
    pub same: Vec<[Vertex; 2]>,
    /// The segments of each crossing, in the order of the constructed vertices if these ascend.
    pub crossings: Vec<Pair>,
    /// True if some segments have more than a point in common.
    pub has_overlaps: bool,
    /// True if some of the vertices can coincide with an end of their segment.
    pub may_be_ends: bool,
    /// True if the definitions of all constructed vertices are known to ascend.
    pub are_ascending: bool,
}

/// A vertex on a segment, and the other segment of its definition; `NONE` if that has to be looked up.
type Inner = (Vertex, u32);

impl OnSegments {
    /// The vertices of a segment.
    pub fn of(&self, segment: usize) -> &[Inner] {
        &self.vertices[self.first[segment] as usize..self.first[segment + 1] as usize]
    }

    /// Constructs the crossings, in the order of the segments.
    pub fn new(session: &mut dyn Predicates, supports: &Supports, meetings: Meetings) -> Result<OnSegments, Refused> {
        let Meetings { crossings, mut touches, same, overlaps, bundles, .. } = meetings;
        let are_ascending = bundles.is_empty() && session.scene().constructions().is_empty();
        let count = supports.ends.len();
        let (first, vertices) = if bundles.is_empty() && supports.are_whole {
            let points = constructed(session, &supports.ends, crossings.iter().copied())?;
            let all = crossings.iter().zip(&points);
            let all = all.flat_map(|(&[i, j], &point)| [(i, (point, j)), (j, (point, i))]);
            grouped(
                count,
                (Vertex::input(0), NONE),
                all.chain(touches.iter().map(|&(segment, v)| (segment, (v, NONE)))),
            )
        } else {
            // A bundle's point is defined by its first segment and the first that crosses it.
            let mut defined: Vec<(Pair, Option<&[u32]>)> = crossings.iter().map(|&pair| (pair, None)).collect();
            for bundle in &bundles {
                let view = View::new(&*session);
                let [a, b] = supports.ends[bundle[0] as usize];
                let ends = |other: u32| supports.ends[other as usize];
                let leaves = |&&other: &&u32| ends(other).iter().any(|&v| view.turn(a, b, v) != Sign::Zero);
                if let Some(&other) = bundle[1..].iter().find(leaves) {
                    defined.push(([bundle[0], other], Some(bundle)));
                }
            }
            if !bundles.is_empty() {
                defined.sort();
            }
            let points = constructed(session, &supports.ends, defined.iter().map(|&(pair, _)| pair))?;
            let mut on: Vec<(u32, Vertex)> = Vec::with_capacity(2 * points.len() + touches.len());
            for ((pair, bundle), &point) in defined.iter().zip(&points) {
                match bundle {
                    None => on.extend(pair.map(|at| (at, point))),
                    Some(bundle) => on.extend(bundle.iter().map(|&at| (at, point))),
                }
            }
            on.append(&mut touches);
            if !supports.are_whole {
                partial::keep_what_edges_reach(&*session, supports, &overlaps, &mut on);
            }
            grouped(count, (Vertex::input(0), NONE), on.iter().map(|&(segment, v)| (segment, (v, NONE))))
        };
        let (has_overlaps, may_be_ends) = (!overlaps.is_empty(), !bundles.is_empty());
        Ok(OnSegments { first, vertices, same, crossings, has_overlaps, may_be_ends, are_ascending })
    }
}

/// The number of vertices that are constructed together.
const TOGETHER: usize = 1 << 16;

/// The vertices where pairs of segments cross. If there are none, a session without constructions suffices.
fn constructed(
    session: &mut dyn Predicates,
    ends: &[[Vertex; 2]],
    pairs: impl ExactSizeIterator<Item = Pair>,
) -> Result<Vec<Vertex>, Refused> {
    let mut points = Vec::with_capacity(pairs.len());
    let mut definitions = Vec::with_capacity(pairs.len().min(TOGETHER));
    let mut pairs = pairs.peekable();
    while pairs.peek().is_some() {
        definitions.clear();
        let lines = |[i, j]: Pair| Construction::Ssi([ends[i as usize], ends[j as usize]]);
        definitions.extend(pairs.by_ref().take(TOGETHER).map(lines));
        let made = session.construct(&definitions).map_err(|refused| match refused {
            Refused::Definition { index, definition, reason } => {
                Refused::Definition { index: points.len() + index, definition, reason }
            }
            other => other,
        })?;
        points.extend(made);
    }
    Ok(points)
}

/// Sorts vertices along segments: by rounded coordinates first, then by signs, which change little.
pub(super) struct Order<'a> {
    view: View<'a>,
    supports: &'a Supports,
    keys: Vec<(i64, Vertex)>,
    queries: Vec<[Vertex; 2]>,
    signs: Vec<Sign>,
    /// The sorted vertices.
    pub vertices: Vec<Vertex>,
}

impl<'a> Order<'a> {
    pub fn new(view: View<'a>, supports: &'a Supports) -> Order<'a> {
        Order { view, supports, keys: Vec::new(), queries: Vec::new(), signs: Vec::new(), vertices: Vec::new() }
    }

    /// Sorts the vertices on a segment, and adds pairs at one position to `same`.
    pub fn sort(&mut self, segment: usize, inner: &[Inner], same: &mut Vec<[Vertex; 2]>) {
        self.vertices.clear();
        if let [(v, _)] = *inner {
            self.vertices.push(v);
            return;
        }
        let ends = self.supports.ends[segment];
        let along = self.view.along(ends);
        self.sort_about(segment, inner, &along);
        // The sort by signs asks about all neighbours first, here in one batch.
        let vertices = &mut self.vertices;
        self.queries.clear();
        self.queries.extend(vertices.windows(2).map(|pair| [pair[1], pair[0]]).filter(|[a, b]| a != b));
        self.signs.clear();
        self.signs.resize(self.queries.len(), Sign::Zero);
        self.view.session.compare_batch(along.axis, &self.queries, &mut self.signs);
        let mut signs = self.signs.iter().map(|&sign| along.directed(sign));
        let mut has_ties = vertices.len() > self.queries.len() + 1;
        let mut runs = Vec::new();
        for at in 1..vertices.len() {
            if vertices[at] != vertices[at - 1] {
                let sign = signs.next().unwrap_or(Sign::Zero);
                has_ties |= sign == Sign::Zero;
                runs.extend((sign == Sign::Negative).then_some(at));
            }
        }
        merge_runs(vertices, runs, |a, b| {
            let sign = along.order(a, b);
            has_ties |= sign == Sign::Zero;
            sign
        });
        // The sort has compared all neighbours of the result.
        if has_ties {
            let is_tie = |pair: &&[Vertex]| pair[0] != pair[1] && along.order(pair[0], pair[1]) == Sign::Zero;
            same.extend(vertices.windows(2).filter(is_tie).map(|pair| [pair[0], pair[1]]));
        }
    }

    /// Sorts by rounded coordinates.
    fn sort_about(&mut self, segment: usize, inner: &[Inner], along: &Along<'_>) {
        let scene = self.view.session.scene();
        let axis = if along.axis == Axis::X { 0 } else { 1 };
        let lines = |other: u32| {
            let own = number(segment);
            [own.min(other), own.max(other)].map(|at| self.supports.ends[at as usize])
        };
        let about = |(v, other): Inner| match other {
            NONE => about(scene, v)[axis],
            other => crossing(scene, lines(other))[axis],
        };
        self.keys.clear();
        self.keys.extend(inner.iter().map(|&inner| (ordered(about(inner)), inner.0)));
        self.keys.sort_unstable();
        self.vertices.extend(self.keys.iter().map(|&(_, v)| v));
        if !along.is_rising() {
            self.vertices.reverse();
        }
    }
}

/// An integer whose order is the total order of doubles.
fn ordered(x: f64) -> i64 {
    let bits = x.to_bits().cast_signed();
    bits ^ ((bits >> 63).cast_unsigned() >> 1).cast_signed()
}

/// The position of a vertex, rounded several times; NaN if it is not of input vertices.
fn about(scene: &Scene, v: Vertex) -> [f64; 2] {
    match scene.construction(v) {
        None => scene.point2(Plane::Xy, v),
        Some(Construction::Ssi(lines)) if lines.as_flattened().iter().all(|v| !v.is_constructed()) => {
            crossing(scene, *lines)
        }
        Some(_) => [f64::NAN; 2],
    }
}

/// The crossing of two lines through input vertices, rounded several times.
#[inline]
fn crossing(scene: &Scene, lines: [[Vertex; 2]; 2]) -> [f64; 2] {
    // Point by point: a map of nested arrays is a call.
    let [[a, b], [c, d]] = lines;
    let at = |v: Vertex| scene.point2(Plane::Xy, v);
    let [a, b, c, d] = [at(a), at(b), at(c), at(d)];
    let minus = |p: [f64; 2], q: [f64; 2]| [p[0] - q[0], p[1] - q[1]];
    let [u, v, way] = [minus(b, a), minus(d, c), minus(c, a)];
    let part = (way[0] * v[1] - way[1] * v[0]) / (u[0] * v[1] - u[1] * v[0]);
    [a[0] + part * u[0], a[1] + part * u[1]]
}
