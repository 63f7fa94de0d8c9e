//! One query: what each edge above the point says, summed up per region.

use predicament_predicates::{Axis, Plane, Predicates, Sign, Vertex};

use super::LocateIndex;

/// Where a point is: the regions it is inside of and those whose boundary it
/// is on, ascending; no region is in both.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Location<'a> {
    /// Regions with an odd crossing number.
    pub inside: &'a [u32],
    /// Regions that own an edge on which the session sees the point.
    pub boundary: &'a [u32],
}

/// Working memory for [`LocateIndex::locate`], to be reused from query to query.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    candidates: Vec<u32>,
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
struct Mark {
    touched: bool,
    odd: bool,
    on_boundary: bool,
}

/// How an edge meets the upward ray from a point.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Meeting {
    Misses,
    Crosses,
    /// The point is on the edge.
    Touches,
}

impl LocateIndex {
    /// Where the vertex `q` is, for all regions in one pass.
    ///
    /// Edges are skipped by raw coordinates where they can't matter: those
    /// whose x-range does not hold q, and those that end further below q than
    /// the session can reach.
    ///
    /// # Panics
    /// If the session's scene has no vertex `q`, or lacks vertices of the map.
    pub fn locate<'a, P: Predicates>(&self, session: &P, q: Vertex, scratch: &'a mut Scratch) -> Location<'a> {
        let point = session.scene().point2(Plane::Xy, q);
        self.columns().collect_above(point, session.reach(), &mut scratch.candidates);
        scratch.owner_sets.fit(self.owner_sets());
        scratch.regions.fit(self.regions());
        for &edge in &scratch.candidates {
            let mark = match meet(session, self.ends(edge), q) {
                Meeting::Misses => continue,
                Meeting::Crosses => Mark { odd: true, ..Mark::default() },
                Meeting::Touches => Mark { on_boundary: true, ..Mark::default() },
            };
            scratch.owner_sets.add(self.owner_set_of(edge), mark);
        }
        scratch.sum_up(self)
    }
}

/// The rule of 4.2 for one edge.
#[inline]
fn meet<P: Predicates>(session: &P, [u, v]: [Vertex; 2], q: Vertex) -> Meeting {
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
fn meet_vertical<P: Predicates>(session: &P, [u, v]: [Vertex; 2], q: Vertex) -> Meeting {
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

    fn sum_up(&mut self, index: &LocateIndex) -> Location<'_> {
        self.inside.clear();
        self.boundary.clear();
        self.owner_sets.drain(|set, mark| {
            for &region in index.owner_set(set) {
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
    fn fit(&mut self, count: usize) {
        self.marks.resize(count, Mark::default());
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
