//! The grid method: candidate pairs of segments, cell by cell.
//!
//! In a cell with few segments, pairs with meeting boxes are tested. A crowded cell uses its own coordinates, rounded:
//! * *Chords*: segments that are long in the cell, extended to its border. Two chords cross only if their ends
//!   alternate on the border. One pass around the border finds these pairs, at the cost of the pairs found: a thousand
//!   spokes side by side make none. Ends that are nearer than rounding errors count as alternating.
//! * *Short* segments are tested against those whose boxes meet theirs, found in the order of their left ends.
//!
//! If most chords of a crowded cell cross, they may pass through one point. If many pass near the crossing of two of
//! them, by rounded coordinates, this crossing is constructed. All chords through it form one *bundle*: an entry for
//! each chord, not for each pair.

use std::mem;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};

use predicament_grid::{Raster, parallel};
use predicament_predicates::{Axis, Construction, Plane, Predicates, Refused, Sign, Vertex};

use super::meet::{Asker, Meetings};
use super::reach::{Extent, Reach};
use super::view::View;

/// The maximum number of segments of a cell without the crowded treatment.
const CROWD: usize = 32;
/// The minimum length of a chord, in units of the cell.
const SHORT: f64 = 1.0 / 32.0;
/// The distance of the border from the cell, outside it.
const BORDER: f64 = 1.0 / 64.0;
/// A bound on the error of positions on the border: several times 2^-38 over [`SHORT`].
const NEAR: f64 = 1.0 / 65536.0;
/// The number of pairs of chords, per chord, from which a bundle is searched.
const TANGLE: usize = 16;
/// The minimum number of segments in a bundle.
const BUNDLE: usize = 16;
/// One more than the number of points that a search for bundles tries.
const PROBES: usize = 8;
/// The distance from a bundle's point to the lines of its chords, in units of the cell: much more than rounding errors,
/// which would only hide the bundle.
const AROUND: f64 = 1.0 / 256.0;
/// The maximum number of pairs tested in crowded cells.
const MOST_PAIRS: u64 = 1 << 34;

/// The number of crossings, some of them found several times, above which one thread finds them all: it removes
/// duplicates on the way.
const MOST_FOUND: usize = 1 << 26;

/// The number of crossings that are counted together.
const COUNTED: usize = 1 << 16;

/// Finds candidate pairs in some cells and tests them.
pub(super) struct Cells<'a> {
    raster: &'a Raster,
    reach: &'a Reach,
    ends: &'a [[Vertex; 2]],
    asker: Asker<'a>,
    /// Cells with chords that may be a bundle.
    tangles: Vec<usize>,
    /// Pairs to be tested.
    pairs: Vec<[u32; 2]>,
    budget: &'a Budget,
}

/// The work of all threads so far.
#[derive(Default)]
struct Budget {
    asked: AtomicU64,
    found: AtomicUsize,
}

/// Finds all intersections of segments.
///
/// # Errors
/// [`Refused`] if there are too many.
pub(super) fn meetings(
    session: &mut dyn Predicates,
    raster: &Raster,
    reach: &Reach,
    ends: &[[Vertex; 2]],
) -> Result<Meetings, Refused> {
    let mut budget = Budget::default();
    let all = raster.count();
    let some = |budget: &Budget, range: Range<usize>| {
        let most = if range.len() == all { usize::MAX } else { MOST_FOUND };
        let mut cells = Cells::new(raster, reach, ends, budget);
        cells.some(&*session, range, most);
        (cells.asker.found, cells.tangles)
    };
    let mut parts = parallel::uneven(all, raster.entries(), &|range| some(&budget, range));
    if !parts.is_single() && budget.found.load(Relaxed) > MOST_FOUND {
        drop(parts);
        budget = Budget::default();
        parts = parallel::in_parts(all, 1, &|range| some(&budget, range));
    }
    let (mut found, tangles) = parts.joined(|(found, tangles), (more, mut others)| {
        found.append(more);
        tangles.append(&mut others);
    });
    if !tangles.is_empty() {
        let mut cells = Cells::new(raster, reach, ends, &budget);
        std::mem::swap(&mut cells.asker.found, &mut found);
        for cell in tangles {
            if cells.is_too_much() {
                break;
            }
            cells.tangle(session, cell)?;
        }
        cells.asker.flush(&*session);
        std::mem::swap(&mut cells.asker.found, &mut found);
    }
    found.settle(ends.len());
    let too_many_pairs = budget.asked.load(Relaxed) > MOST_PAIRS;
    if found.too_many || too_many_pairs { Err(too_many(found.too_many)) } else { Ok(found) }
}

/// The refusal of a scene with too many crossings, or too many pairs to test.
fn too_many(crossings: bool) -> Refused {
    Refused::session(if crossings {
        format!("there are more than {} crossings: divide the scene", super::meet::MOST_CROSSINGS)
    } else {
        format!("more than {MOST_PAIRS} pairs of segments are near each other: use the sweep")
    })
}

impl<'a> Cells<'a> {
    fn new(raster: &'a Raster, reach: &'a Reach, ends: &'a [[Vertex; 2]], budget: &'a Budget) -> Cells<'a> {
        Cells { raster, reach, ends, asker: Asker::new(ends), tangles: Vec::new(), pairs: Vec::new(), budget }
    }

    /// Tests the segments in a range of cells, until more than `most` crossings are found.
    fn some(&mut self, session: &dyn Predicates, range: Range<usize>, most: usize) {
        let mut boxes = Vec::new();
        let mut counted = 0;
        for cell in range {
            let members = self.raster.cell(cell);
            if members.len() > CROWD {
                self.crowded(session, cell);
            } else if members.len() > 1 {
                boxes.clear();
                boxes.extend(members.iter().map(|&at| self.reach.boxes[at as usize]));
                for (i, a) in boxes.iter().enumerate().skip(1) {
                    for (j, b) in boxes[..i].iter().enumerate() {
                        if self.meets(a, b) {
                            self.ask(session, members[j], members[i]);
                        }
                    }
                }
            }
            let found = self.asker.found.crossings.len();
            if members.len() > CROWD || found > counted + COUNTED {
                let before = self.budget.found.fetch_add(found.saturating_sub(counted), Relaxed);
                counted = found;
                if self.is_too_much() || before > most {
                    return;
                }
            }
        }
        self.asker.flush(session);
    }

    /// True if there are more pairs or crossings than allowed.
    fn is_too_much(&self) -> bool {
        self.asker.found.too_many || self.budget.asked.load(Relaxed) > MOST_PAIRS
    }

    #[inline]
    fn meets(&self, a: &Extent, b: &Extent) -> bool {
        (a[0] <= b[2]) & (b[0] <= a[2]) & (a[1] <= b[3]) & (b[1] <= a[3])
    }

    /// Tests the segments of two parts.
    #[inline]
    fn ask(&mut self, session: &dyn Predicates, i: u32, j: u32) {
        let [i, j] = [i, j].map(|at| self.reach.segments[at as usize]);
        if i != j {
            self.asker.ask(session, i.min(j), i.max(j));
        }
    }

    /// The ends of a part's segment.
    fn ends_of(&self, part: u32) -> [Vertex; 2] {
        self.ends[self.reach.segments[part as usize] as usize]
    }

    /// The segments of parts, in ascending order, as the parts are.
    fn segments_of(&self, parts: &[u32]) -> Vec<u32> {
        let mut segments: Vec<u32> = parts.iter().map(|&at| self.reach.segments[at as usize]).collect();
        segments.dedup();
        segments
    }

    /// The segments of a cell that are long in it, as chords, and the others.
    fn chords(&self, cell: usize) -> (Vec<Chord>, Vec<u32>) {
        let members = self.raster.cell(cell);
        let mut chords = Vec::with_capacity(members.len());
        let mut short = Vec::new();
        for &at in members {
            match chord(self.raster.seen_from(cell, &self.reach.raw[at as usize])) {
                Some(ends) => chords.push((at, ends)),
                None => short.push(at),
            }
        }
        (chords, short)
    }

    /// Tests the segments of a crowded cell, except for chords that may be a bundle.
    fn crowded(&mut self, session: &dyn Predicates, cell: usize) {
        let (chords, short) = self.chords(cell);
        if !short.is_empty() {
            self.short(session, self.raster.cell(cell), &short);
        }
        let border = Border::new(&chords);
        if self.few(session, &border) {
            return;
        }
        if (1..PROBES).any(|part| self.may_be_bundle(cell, &chords, part)) {
            self.tangles.push(cell);
        } else {
            self.many(session, &border);
        }
    }

    /// Tests the chords of a cell after it has been searched for bundles.
    fn tangle(&mut self, session: &mut dyn Predicates, cell: usize) -> Result<(), Refused> {
        let (mut chords, _) = self.chords(cell);
        while chords.len() > 1 {
            let border = Border::new(&chords);
            if self.few(&*session, &border) {
                return Ok(());
            }
            let Some(bundle) = self.bundle(session, cell, &chords)? else {
                self.many(&*session, &border);
                return Ok(());
            };
            let in_bundle = |(at, _): &Chord| bundle.binary_search(at).is_ok();
            let together: Vec<_> = chords.iter().copied().filter(in_bundle).collect();
            self.in_line(&*session, &together);
            chords.retain(|chord| !in_bundle(chord));
            for &(at, _) in &chords {
                let own = self.reach.boxes[at as usize];
                for &other in &bundle {
                    if self.meets(&own, &self.reach.boxes[other as usize]) {
                        self.ask(&*session, at, other);
                    }
                }
                self.count(bundle.len());
                if self.is_too_much() {
                    return Ok(());
                }
            }
            self.asker.found.bundles.push(self.segments_of(&bundle));
        }
        Ok(())
    }

    /// Counts pairs of segments.
    fn count(&self, pairs: usize) {
        self.budget.asked.fetch_add(pairs as u64, Relaxed);
    }

    /// Tests the pairs of a bundle that are on one line: they have more than its point in common.
    fn in_line(&mut self, session: &dyn Predicates, bundle: &[Chord]) {
        let view = View::new(session);
        Border::new(bundle).near(usize::MAX, |i, j| {
            let [[a, b], [c, d]] = [i, j].map(|at| self.ends_of(at));
            if view.turn(a, b, c) == Sign::Zero && view.turn(a, b, d) == Sign::Zero {
                self.ask(session, i, j);
            }
        });
    }

    /// Tests the pairs of chords that may cross, if these are not so many that a bundle is worth a search.
    fn few(&mut self, session: &dyn Predicates, border: &Border<'_>) -> bool {
        let most = TANGLE * border.chords.len();
        let mut pairs = mem::take(&mut self.pairs);
        pairs.clear();
        let are_few = border.each(most, |i, j| pairs.push([i, j])) <= most;
        if are_few {
            self.count(pairs.len());
            pairs.iter().for_each(|&[i, j]| self.pair(session, i, j));
        }
        self.pairs = pairs;
        are_few
    }

    /// Tests the pairs of chords that may cross, as far as more pairs are allowed.
    fn many(&mut self, session: &dyn Predicates, border: &Border<'_>) {
        let left = MOST_PAIRS.saturating_sub(self.budget.asked.load(Relaxed));
        let left = usize::try_from(left).unwrap_or(usize::MAX);
        let count = border.each(left, |i, j| self.pair(session, i, j));
        self.count(count);
    }

    /// Tests two parts if their boxes meet.
    #[inline]
    fn pair(&mut self, session: &dyn Predicates, i: u32, j: u32) {
        if self.meets(&self.reach.boxes[i as usize], &self.reach.boxes[j as usize]) {
            self.ask(session, i, j);
        }
    }

    /// Tests pairs with at least one short segment, in the order of their left ends.
    fn short(&mut self, session: &dyn Predicates, members: &[u32], short: &[u32]) {
        let mut sorted: Vec<(Extent, u32, bool)> =
            members.iter().map(|&at| (self.reach.boxes[at as usize], at, short.binary_search(&at).is_ok())).collect();
        sorted.sort_by(|a, b| a.0[0].total_cmp(&b.0[0]).then(a.1.cmp(&b.1)));
        // Long and short segments separately: two long ones are never compared.
        let mut open: [Vec<(Extent, u32)>; 2] = [Vec::new(), Vec::new()];
        let mut pairs = 0;
        for (own, at, is_short) in sorted {
            for list in if is_short { &mut open[..] } else { &mut open[1..] } {
                list.retain(|(other, _)| other[2] >= own[0]);
                pairs += list.len();
                for (other, number) in &*list {
                    if self.meets(&own, other) {
                        self.ask(session, *number, at);
                    }
                }
            }
            open[usize::from(is_short)].push((own, at));
        }
        self.count(pairs);
    }

    /// Two neighbours in the list of chords, about an eighth of it after the neighbours of the part before.
    fn probe(chords: &[Chord], part: usize) -> [u32; 2] {
        let at = chords.len() * part / PROBES;
        [chords[at - 1].0, chords[at].0]
    }

    /// True if enough chords pass near the point of two neighbours to be a bundle, by coordinates in the cell.
    fn may_be_bundle(&self, cell: usize, chords: &[Chord], part: usize) -> bool {
        let seen = |at: u32| self.raster.seen_from(cell, &self.reach.raw[at as usize]);
        let cross = |u: [f64; 2], v: [f64; 2]| u[0] * v[1] - u[1] * v[0];
        let minus = |p: [f64; 2], q: [f64; 2]| [p[0] - q[0], p[1] - q[1]];
        let [[a, b], [c, d]] = Self::probe(chords, part).map(seen);
        let [u, v] = [minus(b, a), minus(d, c)];
        let place = cross(minus(c, a), v) / cross(u, v);
        let point = [a[0] + place * u[0], a[1] + place * u[1]];
        let passes = |&&(at, _): &&Chord| {
            let [a, b] = seen(at);
            let along = minus(b, a);
            cross(along, minus(point, a)).abs() <= AROUND * along[0].abs().max(along[1].abs())
        };
        chords.iter().filter(passes).count() >= least(chords)
    }

    /// The segments through one point of a tangle, ascending; `None` if no point has enough of them.
    fn bundle(
        &mut self,
        session: &mut dyn Predicates,
        cell: usize,
        chords: &[Chord],
    ) -> Result<Option<Vec<u32>>, Refused> {
        // A few pairs of neighbours: in a bundle most of these cross in its point.
        for part in 1..PROBES {
            let lines = Self::probe(chords, part).map(|at| self.ends_of(at));
            if !self.may_be_bundle(cell, chords, part) || !crosses(&*session, lines) {
                continue;
            }
            let point = session.construct(&[Construction::Ssi(lines)])?[0];
            let session = &*session;
            let passes = |&&(at, _): &&Chord| {
                let [a, b] = self.ends_of(at);
                session.orient2d(Plane::Xy, a, b, point) == Sign::Zero && is_within(session, [a, b], point)
            };
            let mut bundle: Vec<u32> = chords.iter().filter(passes).map(|(at, _)| *at).collect();
            if bundle.len() >= least(chords) {
                bundle.sort_unstable();
                return Ok(Some(bundle));
            }
        }
        Ok(None)
    }
}

/// A segment, and the positions of its ends on the border of a cell.
type Chord = (u32, [f64; 2]);

/// True if two segments cross between their ends.
fn crosses(session: &dyn Predicates, [[a, b], [c, d]]: [[Vertex; 2]; 2]) -> bool {
    let view = View::new(session);
    let opposite = |one: Sign, other: Sign| one != Sign::Zero && one == -other;
    opposite(view.turn(a, b, c), view.turn(a, b, d)) && opposite(view.turn(c, d, a), view.turn(c, d, b))
}

/// True if a point of a segment's line is not beyond its ends.
fn is_within(session: &dyn Predicates, [a, b]: [Vertex; 2], point: Vertex) -> bool {
    [Axis::X, Axis::Y].into_iter().all(|axis| {
        let [from, to] = [session.compare(axis, a, point), session.compare(axis, point, b)];
        from * to != Sign::Negative
    })
}

/// The positions where a segment's line enters and leaves the border of the unit cell, as distances around it from 0 to
/// 4, ascending; `None` for a short segment.
fn chord([a, b]: [[f64; 2]; 2]) -> Option<[f64; 2]> {
    let along = [b[0] - a[0], b[1] - a[1]];
    if along[0].abs().max(along[1].abs()) < SHORT {
        return None;
    }
    let [low, high] = [-BORDER, 1.0 + BORDER];
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..2 {
        if along[axis] != 0.0 {
            let [s, t] = [low, high].map(|side| (side - a[axis]) / along[axis]);
            enter = enter.max(s.min(t));
            leave = leave.min(s.max(t));
        }
    }
    if enter > leave {
        return None;
    }
    let around = |t: f64| {
        let [x, y] = [0, 1].map(|axis: usize| ((a[axis] + t * along[axis] - low) / (high - low)).clamp(0.0, 1.0));
        let sides = [y, 1.0 - x, 1.0 - y, x];
        let side = (0..4).reduce(|best, side| if sides[side] < sides[best] { side } else { best });
        match side {
            Some(0) => x,
            Some(1) => 1.0 + y,
            Some(2) => 3.0 - x,
            _ => 4.0 - y,
        }
    };
    let [s, t] = [around(enter), around(leave)];
    Some([s.min(t), s.max(t)])
}

/// The minimum number of segments in a bundle of these chords.
fn least(chords: &[Chord]) -> usize {
    BUNDLE.max(chords.len() / 8)
}

/// The ends of chords on the border of a cell.
struct Border<'a> {
    chords: &'a [Chord],
    /// The ends in the order around the border, each in one number: its place in the upper half, then its chord.
    ends: Vec<u64>,
}

/// The places on a border of length 1: truncation is far below [`NEAR`].
const PLACES: f64 = 1_073_741_824.0;

impl Border<'_> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // from 0 to 4, and `as` saturates
    fn new(chords: &[Chord]) -> Border<'_> {
        let end = |at: u32, place: f64| u64::from((place * PLACES) as u32) << 32 | u64::from(at);
        let ends = chords.iter().zip(0_u32..).flat_map(|(&(_, [s, t]), at)| [end(at, s), end(at, t)]);
        let mut border = Border { chords, ends: ends.collect() };
        border.ends.sort_unstable();
        border
    }

    /// The index of the chord of an end.
    #[allow(clippy::cast_possible_truncation)] // the lower half
    fn chord(end: u64) -> usize {
        end as u32 as usize
    }

    /// Visits the pairs of segments whose chords alternate around the border, or have ends near each other, also across
    /// the corner where positions begin. Ends after more than `most` pairs; returns the number of pairs.
    fn each(&self, most: usize, mut visit: impl FnMut(u32, u32)) -> usize {
        let mut count = 0;
        // Open chords, in the order of their first ends.
        let mut open: Vec<usize> = Vec::new();
        let mut is_open = vec![false; self.chords.len()];
        for &end in &self.ends {
            let at = Border::chord(end);
            if !mem::replace(&mut is_open[at], true) {
                open.push(at);
            } else if let Some(place) = open.iter().rposition(|&other| other == at) {
                let others = &open[place + 1..];
                count += others.len();
                if count > most {
                    return count;
                }
                others.iter().for_each(|&other| visit(self.chords[at].0, self.chords[other].0));
                open.remove(place);
            }
        }
        count + self.near(most - count, visit)
    }

    /// Visits the pairs of segments whose chords have ends near each other, as [`Border::each`].
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a whole number
    fn near(&self, most: usize, mut visit: impl FnMut(u32, u32)) -> usize {
        const REACH: u64 = (NEAR * PLACES) as u64;
        let mut count = 0;
        for (place, &end) in self.ends.iter().enumerate() {
            let at = Border::chord(end);
            let last = (end >> 32) + REACH;
            let around = self.ends[place + 1..].iter().take_while(|&&other| other >> 32 <= last);
            let beyond = self.ends[..place].iter().take_while(|&&other| (other >> 32) + (1 << 32) <= last);
            for other in around.chain(beyond).map(|&other| Border::chord(other)).filter(|&other| other != at) {
                visit(self.chords[at].0, self.chords[other].0);
                count += 1;
                if count > most {
                    return count;
                }
            }
        }
        count
    }
}
