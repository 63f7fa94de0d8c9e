//! Intersection of two segments, by the signs of turns.
//!
//! Pairs are tested in batches. Two segments without a common vertex take two orientation tests if the ends of one are
//! on one side of the other, otherwise four:
//!
//! | sides of the second's ends | sides of the first's ends | what they have in common |
//! |---|---|---|
//! | opposite | opposite | a crossing: a vertex to be constructed |
//! | one is zero | opposite | the second's end is on the first |
//! | one is zero | one is zero | an end of each, at one place |
//! | zero | zero | a line: each end that is between the other's is on it |
//!
//! A session that never returns zero finds only crossings, and segments with a common vertex have only that in common.

use predicament_grid::parallel;
use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::groups::Counts;
use super::view::View;

/// The number of pairs in a batch.
const BATCH: usize = 512;

/// The maximum number of crossings: each is a vertex to construct, of about 200 bytes in all.
pub(super) const MOST_CROSSINGS: usize = 1 << 24;

/// The number of crossings per segment from which on a counting sort is used.
const MANY: usize = 1;

/// Two segments by index, the lower first.
pub(super) type Pair = [u32; 2];

/// Two segments that cross between their ends.
#[derive(Clone, Copy)]
pub(super) struct Crossing {
    first: u32,
    /// Twice the second segment, and one if it ends on the left of the first.
    second: u32,
}

impl Crossing {
    /// The crossing of a pair; `side` is the side of the second segment's second end, seen along the first segment.
    pub fn new([first, second]: Pair, side: Sign) -> Crossing {
        Crossing { first, second: 2 * second + u32::from(side == Sign::Positive) }
    }

    #[inline]
    pub fn pair(self) -> Pair {
        [self.first, self.second / 2]
    }

    /// True if the second segment goes from the right of the first to its left.
    #[inline]
    pub fn is_leftward(self) -> bool {
        self.second % 2 == 1
    }
}

/// All intersections of segments, pair by pair.
#[derive(Default)]
pub(super) struct Meetings {
    /// Pairs that cross between their ends.
    pub crossings: Vec<Crossing>,
    /// Pairs of a segment and another segment's vertex that is on it between its ends.
    pub touches: Vec<(u32, Vertex)>,
    /// Pairs of vertices at one position.
    pub same: Vec<[Vertex; 2]>,
    /// Pairs on one line that have more than a point in common.
    pub overlaps: Vec<Pair>,
    /// For each point with many segments, these segments, ascending; at least one pair of them crosses there.
    pub bundles: Vec<Vec<u32>>,
    /// True if there are more than [`MOST_CROSSINGS`].
    pub too_many: bool,
}

impl Meetings {
    /// Adds the intersections of another list.
    pub fn append(&mut self, mut other: Meetings) {
        self.crossings.append(&mut other.crossings);
        self.touches.append(&mut other.touches);
        self.same.append(&mut other.same);
        self.overlaps.append(&mut other.overlaps);
        self.bundles.append(&mut other.bundles);
        self.too_many |= other.too_many;
    }

    /// Sorts the lists and removes duplicates. All lists are about this many segments.
    pub fn settle(&mut self, segments: usize) {
        self.crossings = sorted_crossings(std::mem::take(&mut self.crossings), segments);
        self.too_many |= self.crossings.len() > MOST_CROSSINGS;
        self.touches.sort_unstable();
        self.touches.dedup();
        self.same.sort_unstable();
        self.same.dedup();
        self.overlaps.sort_unstable();
        self.overlaps.dedup();
        self.bundles.sort_unstable();
        self.bundles.dedup();
    }
}

/// Tests pairs of segments.
pub(super) struct Asker<'a> {
    ends: &'a [[Vertex; 2]],
    pub found: Meetings,
    pending: Vec<Pair>,
    queries: Vec<[Vertex; 3]>,
    signs: Vec<Sign>,
    /// Pairs in which the second segment is not on one side of the first, with the two signs.
    open: Vec<(Pair, [Sign; 2])>,
    /// The number of crossings beyond which duplicates are removed.
    most: usize,
}

impl<'a> Asker<'a> {
    pub fn new(ends: &'a [[Vertex; 2]]) -> Asker<'a> {
        Asker {
            ends,
            found: Meetings::default(),
            pending: Vec::with_capacity(BATCH.min(ends.len())),
            queries: Vec::new(),
            signs: Vec::new(),
            open: Vec::new(),
            most: MOST_CROSSINGS,
        }
    }

    /// Tests two different segments, now or in a later batch.
    #[inline]
    pub fn ask(&mut self, session: &dyn Predicates, i: u32, j: u32) {
        let pair = if i < j { [i, j] } else { [j, i] };
        let [[a, b], [c, d]] = pair.map(|at| self.ends[at as usize]);
        if a == c || a == d || b == c || b == d {
            self.at_a_vertex(View::new(session), pair);
            return;
        }
        self.pending.push(pair);
        if self.pending.len() == BATCH {
            self.flush(session);
        }
    }

    /// Tests the remaining pairs.
    pub fn flush(&mut self, session: &dyn Predicates) {
        if self.pending.is_empty() {
            return;
        }
        let ends = self.ends;
        self.queries.clear();
        self.queries.reserve(2 * self.pending.len());
        for pair in &self.pending {
            let [[a, b], [c, d]] = pair.map(|at| ends[at as usize]);
            self.queries.extend([[a, b, c], [a, b, d]]);
        }
        self.signs.resize(self.queries.len(), Sign::Zero);
        session.orient2d_batch(Plane::Xy, &self.queries, &mut self.signs);
        self.open.clear();
        for (&pair, &[c, d]) in self.pending.iter().zip(self.signs.as_chunks::<2>().0) {
            if c != d || c == Sign::Zero {
                self.open.push((pair, [c, d]));
            }
        }
        self.pending.clear();
        if self.open.is_empty() {
            return;
        }
        self.queries.clear();
        for (pair, _) in &self.open {
            let [[a, b], [c, d]] = pair.map(|at| ends[at as usize]);
            self.queries.extend([[c, d, a], [c, d, b]]);
        }
        session.orient2d_batch(Plane::Xy, &self.queries, &mut self.signs[..self.queries.len()]);
        for (&(pair, others), &own) in self.open.iter().zip(self.signs.as_chunks::<2>().0) {
            let [first, second] = pair.map(|at| ends[at as usize]);
            if own[0] == own[1] && own[0] != Sign::Zero {
                continue;
            }
            let zeros = own.iter().chain(&others).filter(|sign| **sign == Sign::Zero).count();
            if zeros == 0 {
                self.found.crossings.push(Crossing::new(pair, others[1]));
                continue;
            }
            if own == [Sign::Zero; 2] || others == [Sign::Zero; 2] {
                if zeros == 4 {
                    in_line(&mut self.found, View::new(session), pair, [first, second]);
                }
                continue;
            }
            // For lines that cross in one point: the vertex whose side is zero.
            let at = |signs: [Sign; 2], ends: [Vertex; 2]| {
                signs.iter().position(|sign| *sign == Sign::Zero).map(|at| ends[at])
            };
            match (at(own, first), at(others, second)) {
                (Some(a), Some(c)) => self.found.same.push(sorted([a, c])),
                (Some(a), None) => self.found.touches.push((pair[1], a)),
                (None, Some(c)) => self.found.touches.push((pair[0], c)),
                (None, None) => {}
            }
        }
        // Some crossings are found in several cells. Removing duplicates costs as much as finding them, so it is rare.
        if self.found.crossings.len() > self.most {
            self.found.crossings.sort_unstable_by_key(|crossing| crossing.pair());
            self.found.crossings.dedup_by_key(|crossing| crossing.pair());
            self.found.too_many |= self.found.crossings.len() > MOST_CROSSINGS;
            self.most = self.found.crossings.len() + MOST_CROSSINGS / 2;
        }
    }

    /// Two segments with one common vertex: they have more in common only if they have the same direction from there.
    fn at_a_vertex(&mut self, view: View<'_>, pair: Pair) {
        let [first, second] = pair.map(|at| self.ends[at as usize]);
        let common = if second.contains(&first[0]) { first[0] } else { first[1] };
        let far = |[a, b]: [Vertex; 2]| if a == common { b } else { a };
        let [a, b] = [far(first), far(second)];
        if a != b && view.turn(common, a, b) == Sign::Zero {
            in_line(&mut self.found, view, pair, [first, second]);
        }
    }
}

/// Two segments on one line: finds the ends of each that are on the other.
fn in_line(found: &mut Meetings, view: View<'_>, pair: Pair, segments: [[Vertex; 2]; 2]) {
    let mut inner = 0;
    let mut same = 0;
    let mut have_length = true;
    for (at, ends, other) in [(pair[0], segments[0], segments[1]), (pair[1], segments[1], segments[0])] {
        let along = view.along(ends);
        have_length &= !along.is_point();
        for v in other {
            if ends.contains(&v) {
                same += 1;
                continue;
            }
            match [along.order(ends[0], v), along.order(v, ends[1])] {
                [Sign::Negative, Sign::Negative] => {
                    inner += 1;
                    found.touches.push((at, v));
                }
                [Sign::Zero, _] if view.is_same_place(ends[0], v) => {
                    same += 1;
                    found.same.push(sorted([ends[0], v]));
                }
                [_, Sign::Zero] if view.is_same_place(ends[1], v) => {
                    same += 1;
                    found.same.push(sorted([ends[1], v]));
                }
                _ => {}
            }
        }
    }
    // Each common end was counted from both sides.
    if have_length && inner + same / 2 > 1 {
        found.overlaps.push(pair);
    }
}

/// Sorts crossings and removes duplicates.
fn sorted_crossings(mut crossings: Vec<Crossing>, segments: usize) -> Vec<Crossing> {
    if crossings.len() < MANY * segments {
        parallel::sort_by_key(&mut crossings, |crossing| u64::from(crossing.first) << 32 | u64::from(crossing.second));
    } else {
        // Counting sort by the second segments, then by the first.
        crossings = grouped(&crossings, segments, |crossing| crossing.second / 2);
        crossings = grouped(&crossings, segments, |crossing| crossing.first);
    }
    crossings.dedup_by_key(|crossing| crossing.pair());
    crossings
}

/// The crossings in the order of a key below a bound, and for one key in their own order.
fn grouped(crossings: &[Crossing], bound: usize, key: impl Fn(&Crossing) -> u32) -> Vec<Crossing> {
    let mut counts = Counts::new(bound);
    crossings.iter().for_each(|crossing| counts.add(key(crossing)));
    let mut groups = counts.groups(Crossing { first: 0, second: 0 });
    crossings.iter().for_each(|crossing| groups.add(key(crossing), *crossing));
    groups.finish().1
}

fn sorted([a, b]: [Vertex; 2]) -> [Vertex; 2] {
    if a < b { [a, b] } else { [b, a] }
}
