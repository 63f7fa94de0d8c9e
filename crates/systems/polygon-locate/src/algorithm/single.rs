//! Location of one point: the crossings with the edges above it, summed per region.

use predicament_grid::Entry;
use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::LocateIndex;
use crate::answer::Location;

/// Working memory for [`LocateIndex::locate`], reusable for many queries.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    /// Marks by set of owners: edges with the same owners are counted together.
    owner_sets: Marks,
    /// Marks by region: the sums at the end.
    regions: Marks,
    inside: Vec<u32>,
    boundary: Vec<u32>,
}

/// Marks of numbered items during a query.
#[derive(Clone, Debug, Default)]
struct Marks {
    marks: Vec<Mark>,
    touched: Vec<u32>,
}

/// The mark of one item: crossings and contacts so far.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Mark {
    pub(super) touched: bool,
    pub(super) odd: bool,
    pub(super) on_boundary: bool,
}

/// The way in which an edge meets the upward ray from a point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Meeting {
    Misses,
    Crosses,
    /// The point is on the edge.
    Touches,
}

impl Meeting {
    /// The mark that the edge adds to its owners.
    #[inline]
    fn mark(self) -> Option<Mark> {
        match self {
            Meeting::Misses => None,
            Meeting::Crosses => Some(Mark { odd: true, ..Mark::default() }),
            Meeting::Touches => Some(Mark { on_boundary: true, ..Mark::default() }),
        }
    }
}

/// A query, and the facts that follow from raw coordinates.
#[derive(Clone, Copy)]
struct Query<'s, P: ?Sized> {
    session: &'s P,
    vertex: Vertex,
    x: f64,
    /// The heights at which the session may still register the point.
    band: [f64; 2],
}

impl LocateIndex {
    /// Locates the vertex `q`, for all regions in one pass.
    ///
    /// The session is queried only where raw coordinates do not decide:
    /// * how q compares to an end of an edge, if their x are equal;
    /// * on which side of an edge q is, if the edge's closed box, extended upward and downward by the session's reach,
    ///   holds q.
    ///
    /// The answer equals that of a query about every edge, for every session that follows the strict order of raw
    /// coordinates and never puts a point on an edge from outside its box. Exact and perturbed signs do both. For any
    /// other session, this method does not reveal wrong signs of edges whose boxes do not hold q.
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

    /// Locates the vertex `q` with a query about every edge in its column that is not below the point beyond the
    /// session's reach, even if raw coordinates would decide.
    ///
    /// The answer equals [`locate`](LocateIndex::locate) for exact and perturbed signs. This method is several times
    /// slower: it serves to judge sessions, not to use them.
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
                // A zero within the band of a steep edge's line, far below the edge: the ray may cross the edge, but
                // the point does not touch it.
                let [past, other] = ends.map(|v| session.compare(Axis::X, v, q) != Sign::Positive);
                meeting = if past == other { Meeting::Misses } else { Meeting::Crosses };
            }
            if let Some(mark) = meeting.mark() {
                scratch.owner_sets.add(self.owners_of(edge), mark);
            }
        }
        scratch.sum_up(self)
    }

    /// Adds the marks of the segments near the point to those from above their cell.
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

    /// Marks all edges above, edge by edge, for a band that no row contains.
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
    /// True if the point is past an end: the end's x is less or equal. The session decides ties only.
    #[inline]
    fn is_past(&self, end: f64, vertex: impl FnOnce() -> Vertex) -> bool {
        end < self.x || (end == self.x && self.session.compare(Axis::X, vertex(), self.vertex) != Sign::Positive)
    }

    /// True if an edge, its ends from left to right, covers the point's x and is not completely below it.
    #[inline]
    fn may_meet(&self, [[left, a], [right, b]]: [[f64; 2]; 2]) -> bool {
        (left <= self.x) & (self.x <= right) & (self.band[0] <= a.max(b))
    }

    /// Decides how an edge, its ends from left to right, meets the ray.
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

    /// Decides for an edge whose x-range holds the point: past the left end, not past the right end.
    #[inline]
    fn meet_below_or_on(&self, [left, right]: [Vertex; 2]) -> Meeting {
        match self.session.orient2d(Plane::Xy, left, right, self.vertex) {
            Sign::Zero => Meeting::Touches,
            Sign::Negative => Meeting::Crosses,
            Sign::Positive => Meeting::Misses,
        }
    }
}

/// The rule of the paper's section 4.2 for one edge, with all queries to the session.
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

/// Decides for a vertical edge in the ray's own line: never crossed, possibly touched.
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

    /// Resizes the memory for a map.
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
    /// Grows to `count` items; there may already be more, from another map.
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

    /// Passes every mark to `take`, and clears it.
    fn drain(&mut self, mut take: impl FnMut(u32, Mark)) {
        for at in self.touched.drain(..) {
            take(at, std::mem::take(&mut self.marks[at as usize]));
        }
    }
}
