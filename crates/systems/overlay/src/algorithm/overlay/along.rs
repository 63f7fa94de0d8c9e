//! The vertices on each segment: crossings and touches, and their order along it.
//!
//! Vertices are sorted by rounded places first, and then by signs. In most cases the signs change nothing, and all
//! neighbours are compared in one batch.

use predicament_grid::sort::merge_runs;
use predicament_predicates::{Construction, Plane, Predicates, Refused, Scene, Sign, Vertex};

use super::groups::Counts;
use super::meet::{Crossing, Meetings, Pair};
use super::partial;
use super::reach::Reach;
use super::supports::Supports;
use super::view::{Along, View};

/// The inner vertices of each segment, unsorted.
pub(super) struct OnSegments {
    pub first: Vec<u32>,
    pub vertices: Vec<Inner>,
    /// Pairs of vertices at one position.
    pub same: Vec<[Vertex; 2]>,
    /// The crossings, in the order of the constructed vertices if these ascend.
    pub crossings: Vec<Crossing>,
    /// True if some segments have more than a point in common.
    pub has_overlaps: bool,
    /// True if some of the vertices can coincide with an end of their segment.
    pub may_be_ends: bool,
    /// True if the definitions of all constructed vertices are known to ascend.
    pub are_ascending: bool,
}

/// A vertex on a segment. The order of values is the order of rounded places along the segment, then that of ids.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Inner(u64);

/// The largest place along a segment.
const LAST: f64 = 4_294_967_295.0;
/// A double with a unit in the last place of one.
const UNIT: f64 = 4_503_599_627_370_496.0;

impl Inner {
    /// A vertex, with its place from 0 at the segment's first end to 1 at the other; other places are arbitrary.
    #[inline]
    fn new(place: f64, v: Vertex) -> Inner {
        Inner((place * LAST + UNIT).to_bits() << 32 | v.index() as u64)
    }

    #[inline]
    fn place(self) -> u64 {
        self.0 >> 32
    }

    #[inline]
    #[allow(clippy::cast_possible_truncation)] // the lower half
    fn vertex(self) -> Vertex {
        let index = self.0 as u32 as usize;
        if index < Vertex::MAX_INPUT { Vertex::input(index) } else { Vertex::constructed(index - Vertex::MAX_INPUT) }
    }
}

impl OnSegments {
    /// The vertices of a segment.
    pub fn of(&self, segment: usize) -> &[Inner] {
        &self.vertices[self.first[segment] as usize..self.first[segment + 1] as usize]
    }

    /// Constructs the crossings, in the order of the segments.
    pub fn new(
        session: &mut dyn Predicates,
        supports: &Supports,
        reach: &Reach,
        meetings: Meetings,
    ) -> Result<OnSegments, Refused> {
        let Meetings { crossings, mut touches, same, overlaps, bundles, .. } = meetings;
        let are_ascending = bundles.is_empty() && session.scene().constructions().is_empty();
        let count = supports.ends.len();
        let mut counts = Counts::new(count);
        let (first, vertices) = if bundles.is_empty() && supports.are_whole {
            crossings.iter().for_each(|crossing| crossing.pair().into_iter().for_each(|at| counts.add(at)));
            touches.iter().for_each(|(at, _)| counts.add(*at));
            let mut groups = counts.groups(Inner(0));
            let points = constructed(session, &supports.ends, crossings.iter().map(|crossing| crossing.pair()))?;
            for (crossing, &point) in crossings.iter().zip(&points) {
                let [i, j] = crossing.pair();
                let [s, t] = places([reach.raw[i as usize], reach.raw[j as usize]]);
                groups.add(i, Inner::new(s, point));
                groups.add(j, Inner::new(t, point));
            }
            let scene = session.scene();
            touches.iter().for_each(|&(at, v)| groups.add(at, inner(scene, supports.ends[at as usize], v)));
            groups.finish()
        } else {
            // A bundle's point is defined by its first segment and the first that crosses it.
            let mut defined: Vec<(Pair, Option<&[u32]>)> = crossings.iter().map(|at| (at.pair(), None)).collect();
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
            let scene = session.scene();
            on.iter().for_each(|(at, _)| counts.add(*at));
            let mut groups = counts.groups(Inner(0));
            on.iter().for_each(|&(at, v)| groups.add(at, inner(scene, supports.ends[at as usize], v)));
            groups.finish()
        };
        let (has_overlaps, may_be_ends) = (!overlaps.is_empty(), !bundles.is_empty());
        Ok(OnSegments { first, vertices, same, crossings, has_overlaps, may_be_ends, are_ascending })
    }
}

/// A vertex on the segment with these ends.
pub(super) fn inner(scene: &Scene, ends: [Vertex; 2], v: Vertex) -> Inner {
    let [a, b] = ends.map(|end| scene.point2(Plane::Xy, end));
    let at = about(scene, v);
    let axis = usize::from((b[0] - a[0]).abs() < (b[1] - a[1]).abs());
    Inner::new((at[axis] - a[axis]) / (b[axis] - a[axis]), v)
}

/// The places of two segments' crossing along each of them, rounded several times.
#[inline]
fn places([[a, b], [c, d]]: [[[f64; 2]; 2]; 2]) -> [f64; 2] {
    let minus = |p: [f64; 2], q: [f64; 2]| [p[0] - q[0], p[1] - q[1]];
    let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let [u, v, way] = [minus(b, a), minus(d, c), minus(c, a)];
    let all = cross(u, v);
    [cross(way, v) / all, cross(way, u) / all]
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

/// Sorts vertices along segments: by rounded places first, then by signs, which change little.
pub(super) struct Order<'a> {
    view: View<'a>,
    supports: &'a Supports,
    queries: Vec<[Vertex; 2]>,
    signs: Vec<Sign>,
    /// The sorted vertices.
    pub vertices: Vec<Vertex>,
}

impl<'a> Order<'a> {
    pub fn new(view: View<'a>, supports: &'a Supports) -> Order<'a> {
        Order { view, supports, queries: Vec::new(), signs: Vec::new(), vertices: Vec::new() }
    }

    /// Sorts the vertices on a segment, and adds pairs at one position to `same`.
    pub fn sort(&mut self, segment: usize, inner: &mut [Inner], same: &mut Vec<[Vertex; 2]>) {
        self.vertices.clear();
        if let [only] = inner {
            self.vertices.push(only.vertex());
            return;
        }
        let along = self.view.along(self.supports.ends[segment]);
        self.sort_about(inner, &along);
        // The sort by signs asks about all neighbours first, here in one batch.
        let vertices = &mut self.vertices;
        self.queries.clear();
        self.queries.extend(vertices.windows(2).map(|pair| [pair[1], pair[0]]).filter(|[a, b]| a != b));
        self.signs.clear();
        self.signs.resize(self.queries.len(), Sign::Zero);
        self.view.session.compare_batch(along.axis, &self.queries, &mut self.signs);
        let forward = along.directed(Sign::Positive);
        let mut has_ties = vertices.len() > self.queries.len() + 1;
        if has_ties || self.signs.iter().any(|sign| *sign != forward) {
            let mut signs = self.signs.iter().map(|&sign| along.directed(sign));
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
        }
        // The sort has compared all neighbours of the result.
        if has_ties {
            let is_tie = |pair: &&[Vertex]| pair[0] != pair[1] && along.order(pair[0], pair[1]) == Sign::Zero;
            same.extend(vertices.windows(2).filter(is_tie).map(|pair| [pair[0], pair[1]]));
        }
    }

    /// Sorts by places, and vertices at one place by rounded coordinates.
    fn sort_about(&mut self, inner: &mut [Inner], along: &Along<'_>) {
        let scene = self.view.session.scene();
        // Stable, because it is quick if there are long runs.
        inner.sort();
        self.vertices.extend(inner.iter().map(|inner| inner.vertex()));
        let axis = along.axis.index();
        let mut at = 0;
        for group in inner.chunk_by(|a, b| a.place() == b.place()) {
            let own = &mut self.vertices[at..at + group.len()];
            at += group.len();
            if own.len() > 1 {
                own.sort_by_cached_key(|&v| {
                    let place = ordered(about(scene, v)[axis]);
                    (if along.is_rising() { place } else { !place }, v)
                });
            }
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
    let at = |v: Vertex| scene.point2(Plane::Xy, v);
    match scene.construction(v) {
        None => at(v),
        Some(Construction::Ssi(lines)) if lines.as_flattened().iter().all(|v| !v.is_constructed()) => {
            let lines = lines.map(|[a, b]| [at(a), at(b)]);
            let ([[a, b], _], [place, _]) = (lines, places(lines));
            [0, 1].map(|axis: usize| a[axis] + place * (b[axis] - a[axis]))
        }
        Some(_) => [f64::NAN; 2],
    }
}
