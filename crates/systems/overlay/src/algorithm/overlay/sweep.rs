//! Bentley and Ottmann's sweep: the segments that a vertical line crosses, from below to above, while the line moves
//! from left to right.
//!
//! Events are the ends of segments and the crossings found so far, in the order of the line. The line leans a little:
//! of two points with equal x the lower one comes first, and no segment is vertical. At an event all segments through
//! it are removed from the status; those that continue are reinserted in their order right of it. New neighbours are
//! compared, and if they cross ahead, the crossing becomes an event. Overlapping segments are neighbours and stay so.
//!
//! It takes n·log n predicates and log n for each crossing, whatever the segments' lengths, and entries for the
//! segments through a point, not pairs. Each step depends on the results of the step before, so there are no batches.

use predicament_predicates::{Construction, Predicates, Refused, Sign, Vertex};

use super::heap::Heap;
use super::meet::{Crossing, MOST_CROSSINGS, Meetings};
use super::view::View;
use super::{Contradiction, NONE, number};
use predicament_grid::sort::sort_by_sign;
use predicament_grid::status::Status;

/// A sweep in progress.
struct Sweep<'a> {
    session: &'a mut dyn Predicates,
    /// Each segment, from left to right.
    segments: Vec<[Vertex; 2]>,
    status: Status,
    /// For each segment, true if it is in the status.
    is_in: Vec<bool>,
    crossings: Heap,
    /// For each construction that is or was an event, two segments that cross there.
    pairs: Vec<Option<[u32; 2]>>,
    found: Meetings,
    broken: Option<Contradiction>,
}

/// Finds all intersections of segments, and the first rule that signs break.
///
/// # Errors
/// [`Refused`] if the session does not construct a crossing, or there are too many.
pub(super) fn meetings(
    session: &mut dyn Predicates,
    ends: &[[Vertex; 2]],
) -> Result<(Meetings, Option<Contradiction>), Refused> {
    let view = View::new(&*session);
    let mut vertices: Vec<Vertex> = ends.as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    // By raw coordinates first: signs change little in that order.
    let raw = |v: Vertex| view.session.scene().point(v);
    vertices.sort_by(|&a, &b| {
        let ([ax, ay, ..], [bx, by, ..]) = (raw(a), raw(b)) else { return a.cmp(&b) };
        ax.total_cmp(bx).then(ay.total_cmp(by)).then(a.cmp(&b))
    });
    sort_by_sign(&mut vertices, |a, b| view.order(a, b));
    let segments: Vec<[Vertex; 2]> =
        ends.iter().map(|&[a, b]| if view.order(a, b) == Sign::Positive { [b, a] } else { [a, b] }).collect();
    // Segments without length are points: their ends are events, which is enough.
    let has_length = |at: u32| {
        let [a, b] = segments[at as usize];
        view.order(a, b) != Sign::Zero
    };
    let mut starting: Vec<(Vertex, u32)> =
        (0..number(segments.len())).filter(|&at| has_length(at)).map(|at| (segments[at as usize][0], at)).collect();
    starting.sort_unstable();
    let mut sweep = Sweep {
        is_in: vec![false; segments.len()],
        pairs: vec![None; session.scene().constructions().len()],
        session,
        segments,
        status: Status::default(),
        crossings: Heap::default(),
        found: Meetings::default(),
        broken: None,
    };
    let mut at = 0;
    let mut group: Vec<Vertex> = Vec::new();
    let mut before: Option<Vertex> = None;
    loop {
        group.clear();
        let view = View::new(&*sweep.session);
        let order = |a: Vertex, b: Vertex| view.order(a, b);
        let first = match (vertices.get(at).copied(), sweep.crossings.first()) {
            (None, None) => break,
            (Some(v), None) => v,
            (None, Some(x)) => x,
            (Some(v), Some(x)) => {
                if order(x, v) == Sign::Negative {
                    x
                } else {
                    v
                }
            }
        };
        // Input vertices first, then crossings at the same position.
        while let Some(&v) = vertices.get(at).filter(|&&v| order(v, first) == Sign::Zero) {
            group.push(v);
            at += 1;
        }
        while let Some(x) = sweep.crossings.first().filter(|&x| order(x, first) == Sign::Zero) {
            group.push(x);
            sweep.crossings.pop(order);
        }
        if before.is_some_and(|before| order(before, first) != Sign::Negative) {
            sweep.broken.get_or_insert(Contradiction::Events);
        }
        before = Some(first);
        sweep.event(&group, &starting)?;
    }
    let Sweep { mut found, broken, .. } = sweep;
    found.settle(ends.len());
    Ok((found, broken))
}

impl Sweep<'_> {
    fn view(&self) -> View<'_> {
        View::new(&*self.session)
    }

    /// The side of a point as seen along a segment, from left to right.
    fn side(&self, segment: u32, v: Vertex) -> Sign {
        let [a, b] = self.segments[segment as usize];
        self.view().turn(a, b, v)
    }

    /// Processes the event at the vertices of one position.
    fn event(&mut self, group: &[Vertex], starting: &[(Vertex, u32)]) -> Result<(), Refused> {
        let Some(&at) = group.first() else { return Ok(()) };
        let (through, below, above) = self.through(group, at);
        let starts: Vec<u32> = group
            .iter()
            .flat_map(|&v| {
                let from = starting.partition_point(|&(start, _)| start < v);
                starting[from..].iter().take_while(move |(start, _)| *start == v).map(|&(_, segment)| segment)
            })
            .collect();
        let mut on: Vec<u32> = Vec::with_capacity(through.len() + starts.len());
        for &segment in &through {
            if !group.contains(&self.segments[segment as usize][1]) {
                on.push(segment);
            }
        }
        self.note(group, at, &through, &on);
        on.extend(starts);
        self.put_back(on, below, above, at)
    }

    /// Removes the segments through a position from the status; returns them, and the ones below and above.
    fn through(&mut self, group: &[Vertex], at: Vertex) -> (Vec<u32>, Option<u32>, Option<u32>) {
        let below = self.status.last_below(|segment| self.side(segment, at) == Sign::Positive);
        let mut through = Vec::new();
        let mut next = below.map_or_else(|| self.status.first(), |below| self.status.above(below));
        while let Some(segment) = next.filter(|&segment| self.side(segment, at) == Sign::Zero) {
            through.push(segment);
            next = self.status.above(segment);
        }
        let regular = through.len();
        // A segment that ends or crosses here by definition passes through the position, whatever the signs say.
        for &v in group {
            if let Some(pair) = v.construction().and_then(|index| self.pairs[index]) {
                through.extend(pair.into_iter().filter(|&segment| self.is_in[segment as usize]));
            }
        }
        if through.len() > regular {
            let mut seen = Vec::with_capacity(through.len());
            through.retain(|segment| {
                let is_new = !seen.contains(segment);
                seen.push(*segment);
                is_new
            });
            if through.len() > regular {
                self.broken.get_or_insert(Contradiction::Crossing);
            }
        }
        for &segment in &through {
            self.status.remove(segment);
            self.is_in[segment as usize] = false;
        }
        let is_there = |segment: &u32| self.is_in[*segment as usize];
        (through, below.filter(is_there), next.filter(is_there))
    }

    /// Records the intersections at a position. `on` are the segments that continue beyond it.
    fn note(&mut self, group: &[Vertex], at: Vertex, through: &[u32], on: &[u32]) {
        let inputs = group.iter().take_while(|v| !v.is_constructed()).count();
        if inputs > 0 {
            self.found.same.extend(group[1..inputs].iter().map(|&v| if at < v { [at, v] } else { [v, at] }));
            let crossed = on.iter().filter(|&&segment| !group.contains(&self.segments[segment as usize][0]));
            self.found.touches.extend(crossed.map(|&segment| (segment, at)));
            return;
        }
        let mut members = through.to_vec();
        members.sort_unstable();
        match *members {
            [_] | [] => {}
            [i, j] => {
                let [[a, b], [_, d]] = [i, j].map(|at| {
                    let [a, b] = self.segments[at as usize];
                    if a < b { [a, b] } else { [b, a] }
                });
                self.found.crossings.push(Crossing::new([i, j], self.view().turn(a, b, d)));
            }
            _ => self.found.bundles.push(members),
        }
    }

    /// Inserts segments into the status in their order right of a position, and compares new neighbours.
    fn put_back(
        &mut self,
        mut on: Vec<u32>,
        below: Option<u32>,
        above: Option<u32>,
        at: Vertex,
    ) -> Result<(), Refused> {
        if on.is_empty() {
            return match (below, above) {
                (Some(below), Some(above)) => self.compare(below, above, at),
                _ => Ok(()),
            };
        }
        on.sort_unstable();
        let ahead = |segment: u32| self.segments[segment as usize][1];
        sort_by_sign(&mut on, |a, b| -self.side(a, ahead(b)));
        // Segments of one line are consecutive.
        let mut overlaps = Vec::new();
        for at in 1..on.len() {
            let before = on[..at].iter().rev().take_while(|&&other| self.side(other, ahead(on[at])) == Sign::Zero);
            overlaps.extend(before.map(|&other| [other.min(on[at]), other.max(on[at])]));
        }
        self.found.overlaps.append(&mut overlaps);
        let mut under = below;
        for &segment in &on {
            if std::mem::replace(&mut self.is_in[segment as usize], true) {
                self.broken.get_or_insert(Contradiction::Begins);
                continue;
            }
            self.status.insert_above(under, segment);
            under = Some(segment);
        }
        if let Some(below) = below {
            self.compare(below, on[0], at)?;
        }
        match above {
            Some(above) => self.compare(on[on.len() - 1], above, at),
            None => Ok(()),
        }
    }

    /// Makes an event of the crossing of two neighbours, if it is ahead.
    fn compare(&mut self, below: u32, above: u32, at: Vertex) -> Result<(), Refused> {
        let [first, second] = [below, above].map(|segment| self.segments[segment as usize]);
        let [a, b] = first;
        let [c, d] = second;
        if a == c || a == d || b == c || b == d {
            return Ok(());
        }
        let opposite = |one: Sign, other: Sign| one != Sign::Zero && one == -other;
        let view = self.view();
        let crosses =
            opposite(view.turn(a, b, d), view.turn(a, b, c)) && opposite(view.turn(c, d, a), view.turn(c, d, b));
        if !crosses {
            return Ok(());
        }
        let point = self.session.construct(&[Construction::Ssi([first, second])])?[0];
        let index = point.construction().unwrap_or(NONE as usize);
        if self.pairs.len() <= index {
            self.pairs.resize(index + 1, None);
        }
        if self.pairs[index].is_some() || self.view().order(at, point) != Sign::Negative {
            return Ok(());
        }
        if self.pairs.len() > MOST_CROSSINGS {
            return Err(Refused::session(format!("there are more than {MOST_CROSSINGS} crossings: divide the scene")));
        }
        self.pairs[index] = Some([below, above]);
        let view = View::new(&*self.session);
        self.crossings.push(point, |a, b| view.order(a, b));
        Ok(())
    }
}
