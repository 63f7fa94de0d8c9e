//! Nesting of loops, by a sweep that does not know their orientation.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::corners::Corners;
use super::projection::turn_at_first_place;
use super::view::View;
use super::{NONE, Output};
use predicament_grid::status::Status;

/// Returns the loops with the inside on their left, as [`triangulate`](super::triangulate) takes them. A point is
/// inside if an odd number of loops surrounds it. Loops may touch as in [`triangulate`](super::triangulate), and have
/// any orientation.
pub fn oriented<P: Predicates + ?Sized>(
    session: &P,
    plane: Plane,
    reversed: bool,
    loops: &[Vec<Vertex>],
) -> Vec<Vec<Vertex>> {
    let mut turned = loops.to_vec();
    if let [one] = turned.as_mut_slice() {
        // A single loop's first corner is enough.
        let wrong = if reversed { Sign::Positive } else { Sign::Negative };
        if turn_at_first_place(session, plane, loops) == wrong {
            one.reverse();
        }
        return turned;
    }
    let view = View::new(session, plane, reversed);
    let mut corners = Corners::new(&view, loops);
    corners.join_repeats(&mut Output::default());
    let mut first = 0;
    let ends: Vec<usize> = loops
        .iter()
        .map(|one| {
            first += one.len();
            first
        })
        .collect();
    for (at, is_turned) in Nesting::new(&view, &corners, &ends).turned().into_iter().enumerate() {
        if is_turned {
            turned[at].reverse();
        }
    }
    turned
}

/// The sweep over all edges, upper and lower edges alike.
struct Nesting<'a, P: ?Sized> {
    view: &'a View<'a, P>,
    corners: &'a Corners,
    loop_of: Vec<u32>,
    /// For each loop, true if its direction is wrong; `None` until the sweep reaches its first corner.
    turned: Vec<Option<bool>>,
    status: Status,
}

impl<'a, P: Predicates + ?Sized> Nesting<'a, P> {
    fn new(view: &'a View<'a, P>, corners: &'a Corners, ends: &[usize]) -> Self {
        let mut loop_of = Vec::with_capacity(corners.vertex.len());
        for (one, &end) in (0..).zip(ends) {
            loop_of.resize(end, one);
        }
        Nesting { view, corners, loop_of, turned: vec![None; ends.len()], status: Status::default() }
    }

    /// For each loop, true if its direction is wrong.
    fn turned(mut self) -> Vec<bool> {
        let corners = self.corners;
        let mut inserted = vec![false; corners.vertex.len()];
        for place in corners.places() {
            let place: Vec<u32> = place.iter().copied().filter(|&corner| corners.is_linked(corner)).collect();
            for &corner in &place {
                self.leave_left(corner, &mut inserted);
            }
            for &corner in &place {
                let edges = self.edges_to_the_right(corner);
                for edge in edges.into_iter().filter(|&edge| edge != NONE) {
                    if !std::mem::replace(&mut inserted[edge as usize], true) {
                        let below = self.status.last_below(|other| self.is_above(other, edge, corner));
                        self.status.insert_above(below, edge);
                    }
                }
            }
            for &corner in &place {
                self.decide(corner);
            }
        }
        self.turned.into_iter().map(|turned| turned.unwrap_or_default()).collect()
    }

    /// The edges that a corner begins on its right, as the corners at which they begin: the edge before it and the edge
    /// after it.
    fn edges_to_the_right(&self, corner: u32) -> [u32; 2] {
        let [before, after] = [self.corners.previous[corner as usize], self.corners.next[corner as usize]];
        let before_edge = if self.corners.is_before(corner, before) { before } else { NONE };
        let after_edge = if self.corners.is_before(corner, after) { corner } else { NONE };
        [before_edge, after_edge]
    }

    /// Removes the edges that end at a corner.
    fn leave_left(&mut self, corner: u32, inserted: &mut [bool]) {
        let [before, after] = [self.corners.previous[corner as usize], self.corners.next[corner as usize]];
        for (edge, far) in [(before, before), (corner, after)] {
            if self.corners.is_before(far, corner) && std::mem::take(&mut inserted[edge as usize]) {
                self.status.remove(edge);
            }
        }
    }

    /// True if an edge that begins at a corner, on its right, is above another edge.
    fn is_above(&self, other: u32, edge: u32, corner: u32) -> bool {
        let far = if edge == corner { self.corners.next[edge as usize] } else { edge };
        let ends = [other, self.corners.next[other as usize]];
        let goes_right = self.corners.is_before(ends[0], ends[1]);
        let [left, right] = if goes_right { ends } else { [ends[1], ends[0]] };
        let side = |c: u32| {
            let [a, b, c] = [left, right, c].map(|corner| self.corners.vertex[corner as usize]);
            self.view.turn(a, b, c)
        };
        if let Some(sign) = [corner, far].into_iter().map(side).find(|sign| *sign != Sign::Zero) {
            return sign == Sign::Positive;
        }
        // Two loops have this edge in common, one on each side. The edge of the upper loop is above.
        match [edge, other].map(|edge| self.is_inside_above(edge)) {
            [Some(is_upper), _] => is_upper,
            [None, Some(is_upper)] => !is_upper,
            // Both loops begin here, with two edges to the right.
            [None, None] => {
                let [before, after] = [self.corners.previous[corner as usize], self.corners.next[corner as usize]];
                side(if far == after { before } else { after }) == Sign::Positive
            }
        }
    }

    /// True if the inside is above an edge; `None` until the sweep has decided the direction of the edge's loop.
    fn is_inside_above(&self, edge: u32) -> Option<bool> {
        let goes_right = self.corners.is_before(edge, self.corners.next[edge as usize]);
        self.turned[self.loop_of[edge as usize] as usize].map(|is_turned| goes_right != is_turned)
    }

    /// Decides at a loop's first corner, from the edges below it, whether the loop has the wrong direction.
    fn decide(&mut self, corner: u32) {
        let one = self.loop_of[corner as usize] as usize;
        let edges = self.edges_to_the_right(corner);
        if self.turned[one].is_some() || edges.contains(&NONE) {
            return;
        }
        let [before, after] = edges.map(|edge| self.status.count_below(edge));
        // The lower edge of an outer loop goes to the right, and an even number of edges is below it.
        let is_outer = before.min(after).is_multiple_of(2);
        self.turned[one] = Some((after < before) != is_outer);
    }
}
