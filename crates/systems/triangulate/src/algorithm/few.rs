//! Ear clipping of one short loop, without sorting its vertices and without a mesh.
//!
//! The ears and their order are those of `ears.rs`, except in the choice of the blocker that a corner waits for when
//! several block it. In `ears.rs` the order along both axes only saves turns and separates vertices at one position.
//! This module has no such order and returns no answer in two cases: if three vertices have a turn of zero and are not
//! known to be in line (for example, vertices at one position), and if no corner is an ear.
//!
//! A convex loop of n vertices takes n turns; an order along both axes takes at least about 4·n comparisons.

use predicament_predicates::{Plane, Predicates, Sign, Vertex};

use super::view::View;

/// The maximum number of vertices of a loop.
pub const MOST: usize = 24;

/// Triangulates the inside of one simple short loop as [`triangulate`](super::triangulate()) with the method
/// [`Ears`](super::Method::Ears) does, from turns alone.
///
/// A vertex `is_outer` if it is on the boundary of a convex region that holds the loop. The loop turns left there, or
/// goes straight on if its neighbours are `in_line`; the session is not asked.
///
/// Returns `None` if turns are not enough: if the loop has more than [`MOST`] vertices, fewer than three, or a vertex
/// twice; if a turn is zero for vertices that are not `in_line`; or if no corner is an ear.
#[must_use]
pub fn triangulate_few<P: Predicates + ?Sized>(
    session: &P,
    plane: Plane,
    reversed: bool,
    vertices: &[Vertex],
    in_line: impl Fn(Vertex, Vertex, Vertex) -> bool,
    is_outer: impl Fn(Vertex) -> bool,
) -> Option<Vec<[Vertex; 3]>> {
    let count = vertices.len();
    let is_new = |at: usize| !vertices[..at].contains(&vertices[at]);
    if !(3..=MOST).contains(&count) || !(1..count).all(is_new) {
        return None;
    }
    // The order in which the half-edges of a mesh end: its first half-edge goes from the first vertex to the second.
    let vertices: SmallLoop = std::array::from_fn(|at| vertices[(at + 1) % count]);
    let view = View::new(session, plane, reversed);
    let turn = |a: usize, b: usize, c: usize| match view.turn(vertices[a], vertices[b], vertices[c]) {
        Sign::Zero if !in_line(vertices[a], vertices[b], vertices[c]) => None,
        sign => Some(sign),
    };
    let is_convex = |[a, b, c]: [usize; 3]| {
        let [u, v, w] = [a, b, c].map(|at| vertices[at]);
        Some(if is_outer(v) { !in_line(u, v, w) } else { turn(a, b, c)? == Sign::Positive })
    };
    let mut ears = Ears::new(count);
    for at in 0..count {
        if is_convex(ears.around(at))? {
            ears.enqueue(at);
        } else {
            ears.is_reflex |= 1 << at;
        }
    }
    let mut triangles = Vec::with_capacity(count - 2);
    // Pairs of a blocker and a corner that waits for it, in the order of waiting.
    let mut waiting: Vec<[usize; 2]> = Vec::new();
    while ears.left > 3 {
        let at = ears.next_in_queue()?;
        if ears.is_cut >> at & 1 == 1 {
            continue;
        }
        let [a, b, c] = ears.around(at);
        let mut blocker = None;
        for other in (0..count).filter(|other| ears.is_reflex >> other & 1 == 1) {
            if [a, b, c].contains(&other) {
                continue;
            }
            let is_left = |p: usize, q: usize| Some(turn(p, q, other)? != Sign::Negative);
            if is_left(c, a)? && is_left(a, b)? && is_left(b, c)? {
                blocker = Some(other);
                break;
            }
        }
        if let Some(blocker) = blocker {
            waiting.push([blocker, at]);
            continue;
        }
        triangles.push([a, b, c].map(|at| vertices[at]));
        ears.cut(at);
        if ears.left == 3 {
            break;
        }
        for at in [a, c] {
            if ears.is_queued >> at & 1 == 0 && is_convex(ears.around(at))? {
                if ears.is_reflex >> at & 1 == 1 {
                    ears.is_reflex ^= 1 << at;
                    waiting.iter().rev().filter(|[blocker, _]| *blocker == at).for_each(|&[_, at]| ears.enqueue(at));
                    waiting.retain(|[blocker, _]| *blocker != at);
                }
                ears.enqueue(at);
            }
        }
    }
    let last = (0..count).find(|at| ears.is_cut >> at & 1 == 0)?;
    triangles.push(ears.around(last).map(|at| vertices[at]));
    Some(triangles)
}

type SmallLoop = [Vertex; MOST];

/// A loop during ear clipping.
struct Ears {
    next: [u8; MOST],
    previous: [u8; MOST],
    left: usize,
    is_cut: u32,
    /// The corners that are not convex, as bits.
    is_reflex: u32,
    /// Candidate ears, in a ring, each once.
    queue: [u8; MOST],
    first: usize,
    queued: usize,
    is_queued: u32,
}

impl Ears {
    fn new(count: usize) -> Ears {
        let mut ears = Ears {
            next: [0; MOST],
            previous: [0; MOST],
            left: count,
            is_cut: 0,
            is_reflex: 0,
            queue: [0; MOST],
            first: 0,
            queued: 0,
            is_queued: 0,
        };
        for at in 0..count {
            ears.next[at] = small((at + 1) % count);
            ears.previous[at] = small((at + count - 1) % count);
        }
        ears
    }

    fn around(&self, at: usize) -> [usize; 3] {
        [usize::from(self.previous[at]), at, usize::from(self.next[at])]
    }

    fn enqueue(&mut self, at: usize) {
        if self.is_queued >> at & 1 == 0 {
            self.is_queued |= 1 << at;
            self.queue[(self.first + self.queued) % MOST] = small(at);
            self.queued += 1;
        }
    }

    fn next_in_queue(&mut self) -> Option<usize> {
        self.queued = self.queued.checked_sub(1)?;
        let at = usize::from(self.queue[self.first]);
        self.first = (self.first + 1) % MOST;
        self.is_queued ^= 1 << at;
        Some(at)
    }

    fn cut(&mut self, at: usize) {
        let [a, b, c] = self.around(at);
        self.next[a] = small(c);
        self.previous[c] = small(a);
        self.is_cut |= 1 << b;
        self.left -= 1;
    }
}

/// An index below [`MOST`] as a byte.
fn small(at: usize) -> u8 {
    u8::try_from(at).unwrap_or(0)
}
