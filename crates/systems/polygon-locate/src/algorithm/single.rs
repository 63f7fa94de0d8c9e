//! Locates one point: the crossings with the edges above it, summed up per region.

use predicament_grid::Entry;
use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::LocateIndex;
use crate::answer::Location;

/// Working memory for [`LocateIndex::locate`], to be reused from query to query.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    /// Edges with the same owners are counted together …
    owner_sets: Marks,
    /// … and summed up per region at the end.
    regions: Marks,
    inside: Vec<u32>,
    boundary: Vec<u32>,
}

/// What is known about numbered things during a query.
#[derive(Clone, Debug, Default)]
struct Marks {
    marks: Vec<Mark>,
    touched: Vec<u32>,
}

/// What is known about one of them.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Mark {
    pub(super) touched: bool,
    pub(super) odd: bool,
    pub(super) on_boundary: bool,
}

/// How an edge meets the upward ray from a point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Meeting {
    Misses,
    Crosses,
    /// The point is on the edge.
    Touches,
}

impl Meeting {
    /// What the edge adds to its owners.
    #[inline]
    fn mark(self) -> Option<Mark> {
        match self {
            Meeting::Misses => None,
            Meeting::Crosses => Some(Mark { odd: true, ..Mark::default() }),
            Meeting::Touches => Some(Mark { on_boundary: true, ..Mark::default() }),
        }
    }
}

/// A query with what raw coordinates say about it.
#[derive(Clone, Copy)]
struct Query<'s, P: ?Sized> {
    session: &'s P,
    vertex: Vertex,
    x: f64,
    /// The heights at which the session may still register the point.
    band: [f64; 2],
}

impl LocateIndex {
    /// Where the vertex `q` is, for all regions in one pass.
    ///
    /// The session is asked what raw coordinates leave open, and nothing else:
    /// * how q compares to an end of an edge, where their x is equal;
    /// * on which side of an edge q is, where the edge's closed box, drawn out
    ///   by the session's reach upward and downward, holds q.
    ///
    /// The answer is that of asking about every edge, for every session that
    /// takes a strict order of raw coordinates as it is and sees no point on
    /// an edge from outside of its box. Signs of exact or perturbed points do;
    /// a session that would not is not told on by edges whose boxes don't hold q.
    ///
    /// # Panics
    /// If the session's scene has no vertex `q`, or lacks vertices of the map.
    pub fn locate<'a, P: Predicates + ?Sized>(
        &'a self,
        session: &P,
        q: Vertex,
        scratch: &'a mut Scratch,
    ) -> Location<'a> {
        let [x, y] = session.scene().point2(Plane::Xy, q);
        let reach = session.reach();
        let band = if reach == 0.0 { [y, y] } else { [(y - reach).next_down(), (y + reach).next_up()] };
        let query = Query { session, vertex: q, x, band };
        scratch.fit(self);
        if let Some(cell) = self.cells().at(x, band) {
            self.look_around(&query, cell.entries, &mut scratch.owner_sets);
            scratch.sum_up_under(self, cell.above)
        } else {
            self.look_up(&query, [x, y], &mut scratch.owner_sets);
            scratch.sum_up(self)
        }
    }

    /// Where the vertex `q` is, all of it asked: every edge that is not below
    /// the point beyond the session's reach, and not in other columns, whether
    /// or not raw coordinates decide about it.
    ///
    /// The same as [`locate`](LocateIndex::locate) for exact and perturbed
    /// signs, and several times slower: for judging sessions, not for using them.
    ///
    /// # Panics
    /// If the session's scene has no vertex `q`, or lacks vertices of the map.
    pub fn question<'a, P: Predicates + ?Sized>(
        &self,
        session: &P,
        q: Vertex,
        scratch: &'a mut Scratch,
    ) -> Location<'a> {
        let (scene, reach) = (session.scene(), session.reach());
        let point = scene.point2(Plane::Xy, q);
        let top = if reach == 0.0 { f64::MAX } else { (point[1] + reach).next_up() };
        scratch.fit(self);
        for edge in self.columns().above(point, reach) {
            let ends = self.ends(edge);
            let mut meeting = meet(session, ends, q);
            if meeting == Meeting::Touches && ends.iter().all(|&v| scene.point2(Plane::Xy, v)[1] > top) {
                // A zero within the band of a steep edge's line, far below the edge: it is in the way, and not touched.
                let [past, other] = ends.map(|v| session.compare(Axis::X, v, q) != Sign::Positive);
                meeting = if past == other { Meeting::Misses } else { Meeting::Crosses };
            }
            if let Some(mark) = meeting.mark() {
                scratch.owner_sets.add(self.owners_of(edge), mark);
            }
        }
        scratch.sum_up(self)
    }

    /// What the segments near the point add to what is above their cell.
    #[inline]
    fn look_around<P: Predicates + ?Sized>(&self, query: &Query<'_, P>, entries: &[Entry], owner_sets: &mut Marks) {
        for entry in entries {
            let pivot_is_past = entry.pivot.is_some_and(|end| {
                query.is_past(entry.ends[end as usize][0], || self.ends(entry.segment)[end as usize])
            });
            if pivot_is_past | query.may_meet(entry.ends) {
                let meeting = query.meet(entry.ends, || self.ends(entry.segment));
                let odd = pivot_is_past != (meeting == Meeting::Crosses);
                let on_boundary = meeting == Meeting::Touches;
                if odd | on_boundary {
                    owner_sets.add(self.owners_of(entry.segment), Mark { touched: false, odd, on_boundary });
                }
            }
        }
    }

    /// All of it, edge by edge, for a band that no row holds.
    #[cold]
    fn look_up<P: Predicates + ?Sized>(&self, query: &Query<'_, P>, point: [f64; 2], owner_sets: &mut Marks) {
        let scene = query.session.scene();
        for edge in self.columns().above(point, query.session.reach()) {
            let ends = self.ends(edge);
            if let Some(mark) = query.meet(ends.map(|v| scene.point2(Plane::Xy, v)), || ends).mark() {
                owner_sets.add(self.owners_of(edge), mark);
            }
        }
    }
}

impl<P: Predicates + ?Sized> Query<'_, P> {
    /// Whether the point is past an end, left or equal: the session is asked
    /// about ties only.
    #[inline]
    fn is_past(&self, end: f64, vertex: impl FnOnce() -> Vertex) -> bool {
        end < self.x || (end == self.x && self.session.compare(Axis::X, vertex(), self.vertex) != Sign::Positive)
    }

    /// Whether an edge, its ends from left to right, is at the point's x and
    /// not all below it.
    #[inline]
    fn may_meet(&self, [[left, a], [right, b]]: [[f64; 2]; 2]) -> bool {
        (left <= self.x) & (self.x <= right) & (self.band[0] <= a.max(b))
    }

    /// How an edge, its ends from left to right, meets the ray.
    #[inline]
    fn meet(&self, ends: [[f64; 2]; 2], vertices: impl FnOnce() -> [Vertex; 2]) -> Meeting {
        if !self.may_meet(ends) {
            return Meeting::Misses;
        }
        let [[left, a], [right, b]] = ends;
        let is_above = self.band[1] < a.min(b);
        if (left < self.x) & (self.x < right) {
            return if is_above { Meeting::Crosses } else { self.meet_below_or_on(vertices()) };
        }
        let [u, v] = vertices();
        match is_above {
            true if self.is_past(left, || u) != self.is_past(right, || v) => Meeting::Crosses,
            true => Meeting::Misses,
            false => meet(self.session, [u, v], self.vertex),
        }
    }

    /// An edge whose left end the point is past, and whose right end not.
    #[inline]
    fn meet_below_or_on(&self, [left, right]: [Vertex; 2]) -> Meeting {
        match self.session.orient2d(Plane::Xy, left, right, self.vertex) {
            Sign::Zero => Meeting::Touches,
            Sign::Negative => Meeting::Crosses,
            Sign::Positive => Meeting::Misses,
        }
    }
}

/// The rule of 4.2 for one edge, all of it asked.
fn meet<P: Predicates + ?Sized>(session: &P, [u, v]: [Vertex; 2], q: Vertex) -> Meeting {
    let of_u = session.compare(Axis::X, u, q);
    let of_v = session.compare(Axis::X, v, q);
    if of_u == of_v {
        return if of_u.is_zero() { meet_vertical(session, [u, v], q) } else { Meeting::Misses };
    }
    let (left, right, of_right) = if of_u < of_v { (u, v, of_v) } else { (v, u, of_u) };
    match session.orient2d(Plane::Xy, left, right, q) {
        Sign::Zero => Meeting::Touches,
        Sign::Negative if of_right == Sign::Positive => Meeting::Crosses,
        Sign::Negative | Sign::Positive => Meeting::Misses,
    }
}

/// A vertical edge in the ray's own line: never crossed, but maybe touched.
fn meet_vertical<P: Predicates + ?Sized>(session: &P, [u, v]: [Vertex; 2], q: Vertex) -> Meeting {
    match session.compare(Axis::Y, u, q) * session.compare(Axis::Y, v, q) {
        Sign::Positive => Meeting::Misses,
        Sign::Zero | Sign::Negative => Meeting::Touches,
    }
}

impl Scratch {
    /// Empty working memory; it grows to fit the first map.
    #[must_use]
    pub fn new() -> Scratch {
        Scratch::default()
    }

    /// Makes room for a map.
    #[inline]
    pub(super) fn fit(&mut self, index: &LocateIndex) {
        self.owner_sets.fit(index.owner_sets());
    }

    /// Marks the regions of a set of owners.
    #[inline]
    pub(super) fn add(&mut self, owners: u32, mark: Mark) {
        self.owner_sets.add(owners, mark);
    }

    /// The sum of all marks, and of a set of regions above them.
    #[inline]
    pub(super) fn sum_up_under<'a>(&'a mut self, index: &'a LocateIndex, above: u32) -> Location<'a> {
        let above = index.set(above);
        if self.owner_sets.are_clear() {
            return Location { inside: above, boundary: &[] };
        }
        self.regions.fit(index.regions());
        for &region in above {
            self.regions.add(region, Mark { odd: true, ..Mark::default() });
        }
        self.sum_up(index)
    }

    /// The sum of all marks.
    pub(super) fn sum_up(&mut self, index: &LocateIndex) -> Location<'_> {
        self.regions.fit(index.regions());
        self.inside.clear();
        self.boundary.clear();
        self.owner_sets.drain(|set, mark| {
            for &region in index.set(set) {
                self.regions.add(region, mark);
            }
        });
        self.regions.drain(|region, mark| {
            if mark.on_boundary {
                self.boundary.push(region);
            } else if mark.odd {
                self.inside.push(region);
            }
        });
        self.inside.sort_unstable();
        self.boundary.sort_unstable();
        Location { inside: &self.inside, boundary: &self.boundary }
    }
}

impl Marks {
    /// Makes room; there may already be more than enough, from another map.
    fn fit(&mut self, count: usize) {
        if self.marks.len() < count {
            self.marks.resize(count, Mark::default());
        }
    }

    fn are_clear(&self) -> bool {
        self.touched.is_empty()
    }

    #[inline]
    fn add(&mut self, at: u32, more: Mark) {
        let mark = &mut self.marks[at as usize];
        if !mark.touched {
            mark.touched = true;
            self.touched.push(at);
        }
        mark.odd ^= more.odd;
        mark.on_boundary |= more.on_boundary;
    }

    /// Hands over every mark, and leaves none.
    fn drain(&mut self, mut take: impl FnMut(u32, Mark)) {
        for at in self.touched.drain(..) {
            take(at, std::mem::take(&mut self.marks[at as usize]));
        }
    }
}
