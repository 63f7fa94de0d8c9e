//! The corners of all loops, linked, in the order of the sweep.
//!
//! This module separates corners at one position. Consecutive corners at one position are merged. Where loops touch in
//! a point, the links change so that each walk follows the boundary of one part of the inside. Afterwards the sectors
//! of the inside at one position do not overlap.

use predicament_predicates::{Predicates, Sign, Vertex};

use super::view::View;
use super::{Contradiction, NONE, Output, number};
use predicament_grid::sort::sort_by_sign;

/// The corners of all loops.
pub(super) struct Corners {
    pub vertex: Vec<Vertex>,
    /// The next corner of the walk; [`NONE`] for removed corners.
    pub next: Vec<u32>,
    pub previous: Vec<u32>,
    /// The rank of each corner in the order of the sweep; vertices at one position have equal ranks.
    pub rank: Vec<u32>,
    /// All corners in the order of the sweep.
    pub order: Vec<u32>,
}

/// An edge's end at a position, as the edge is seen from there.
#[derive(Clone, Copy)]
struct Direction {
    /// The corner at the position.
    corner: u32,
    /// The corner at the other end.
    far: u32,
    /// True if the edge leaves the position.
    leaves: bool,
}

impl Corners {
    /// Sorts the corners of the loops in the order of the sweep, and links them as the loops do.
    pub fn new<P: Predicates + ?Sized>(view: &View<'_, P>, loops: &[Vec<Vertex>]) -> Corners {
        let all: usize = loops.iter().map(Vec::len).sum();
        let mut vertex = Vec::with_capacity(all);
        let (mut next, mut previous) = (Vec::with_capacity(all), Vec::with_capacity(all));
        for one in loops {
            let (first, end) = (number(vertex.len()), number(vertex.len() + one.len()));
            vertex.extend_from_slice(one);
            next.extend((first + 1..end).chain([first]).take(one.len()));
            previous.extend([end.wrapping_sub(1)].into_iter().chain(first..end).take(one.len()));
        }
        let order = sorted(view, &vertex);
        let rank = rank(view, &vertex, &order);
        Corners { vertex, next, previous, rank, order }
    }

    /// True if two corners are at one position.
    pub fn has_repeats(&self) -> bool {
        self.order.last().is_some_and(|&last| self.rank[last as usize] as usize + 1 < self.order.len())
    }

    /// True if the corner is in a walk.
    pub fn is_linked(&self, corner: u32) -> bool {
        self.next[corner as usize] != NONE
    }

    /// The corners at each position, in the order of the sweep.
    pub fn places(&self) -> impl Iterator<Item = &[u32]> {
        self.order.chunk_by(|&a, &b| self.rank[a as usize] == self.rank[b as usize])
    }

    /// True if corner `a` comes strictly before corner `b` in the sweep.
    #[inline]
    pub fn is_before(&self, a: u32, b: u32) -> bool {
        self.rank[a as usize] < self.rank[b as usize]
    }

    fn link(&mut self, a: u32, b: u32) {
        self.next[a as usize] = b;
        self.previous[b as usize] = a;
    }

    fn unlink(&mut self, corner: u32) {
        self.link(self.previous[corner as usize], self.next[corner as usize]);
        self.next[corner as usize] = NONE;
    }

    /// Merges consecutive corners at one position. The triangles between them have no area. They are not a flaw: an
    /// edge without length is a side of each.
    pub fn join_repeats(&mut self, out: &mut Output) {
        for corner in 0..number(self.vertex.len()) {
            while self.is_linked(corner) {
                let second = self.next[corner as usize];
                if second == corner || self.rank[corner as usize] != self.rank[second as usize] {
                    break;
                }
                let third = self.next[second as usize];
                out.flat([corner, second, third].map(|corner| self.vertex[corner as usize]));
                if self.next[third as usize] == corner {
                    [corner, second, third].into_iter().for_each(|corner| self.next[corner as usize] = NONE);
                } else {
                    self.unlink(second);
                }
            }
        }
    }

    /// Links the corners at each position so that no two sectors of the inside overlap.
    pub fn untangle<P: Predicates + ?Sized>(&mut self, view: &View<'_, P>, out: &mut Output) {
        let linked = |place: &[u32]| place.iter().copied().filter(|&corner| self.is_linked(corner)).collect();
        let places: Vec<Vec<u32>> = self.places().filter(|place| place.len() > 1).map(linked).collect();
        for place in places.iter().filter(|place| place.len() > 1) {
            self.untangle_place(view, place, out);
        }
    }

    fn untangle_place<P: Predicates + ?Sized>(&mut self, view: &View<'_, P>, corners: &[u32], out: &mut Output) {
        let mut around: Vec<Direction> = Vec::with_capacity(2 * corners.len());
        for &corner in corners {
            let [before, after] = [self.previous[corner as usize], self.next[corner as usize]];
            around.push(Direction { corner, far: before, leaves: false });
            around.push(Direction { corner, far: after, leaves: true });
        }
        let center = self.vertex[corners[0] as usize];
        sort_by_sign(&mut around, |a, b| self.order_around(view, center, a, b));
        for side in sides_of_an_edge(around) {
            self.untangle_side(side, out);
        }
    }

    /// Links the corners of some directions, in counterclockwise order.
    fn untangle_side(&mut self, mut around: Vec<Direction>, out: &mut Output) {
        // Counterclockwise, a sector of the inside begins at an edge that leaves, and ends at the next edge that
        // arrives.
        let Some(first) = around.iter().position(|direction| direction.leaves) else { return };
        around.rotate_left(first);
        let (pairs, _) = around.as_chunks::<2>();
        if !pairs.iter().all(|[from, to]| from.leaves && !to.leaves) {
            out.broken(Contradiction::Place);
            return;
        }
        // Each pair: the corner that keeps the arriving edge, and the corner whose leaving edge follows it.
        let turns: Vec<[u32; 2]> = pairs.iter().map(|[from, to]| [to.corner, from.corner]).collect();
        let after: Vec<u32> = pairs.iter().map(|[from, _]| from.far).collect();
        for (&[comes, leaves], &far) in turns.iter().zip(&after) {
            if comes == leaves {
                continue;
            }
            // If the corners are different vertices, an edge without length joins them.
            out.flat([comes, leaves, far].map(|corner| self.vertex[corner as usize]));
            self.link(comes, far);
        }
        self.close_gaps(&turns, out);
    }

    /// Fills the cycles of edges without length between the vertices at one position. A cycle of two edges is already
    /// closed; any longer cycle bounds a polygon without area.
    fn close_gaps(&self, turns: &[[u32; 2]], out: &mut Output) {
        let mut done = vec![false; turns.len()];
        for start in 0..turns.len() {
            let mut cycle = Vec::new();
            let mut at = start;
            while !done[at] {
                done[at] = true;
                let [comes, leaves] = turns[at];
                cycle.push(self.vertex[comes as usize]);
                at = turns.iter().position(|&[other, _]| other == leaves).unwrap_or(start);
            }
            fill(cycle, out);
        }
    }

    /// The order of two directions, counterclockwise from straight down.
    fn order_around<P: Predicates + ?Sized>(
        &self,
        view: &View<'_, P>,
        center: Vertex,
        a: Direction,
        b: Direction,
    ) -> Sign {
        let is_left = |direction: Direction| !self.is_before(direction.corner, direction.far);
        match (is_left(a), is_left(b)) {
            (false, true) => return Sign::Negative,
            (true, false) => return Sign::Positive,
            _ => {}
        }
        let [u, v] = [a, b].map(|direction| self.vertex[direction.far as usize]);
        match view.turn(center, u, v) {
            // Two parts of the inside have this edge in common: one part ends here, then the other begins.
            Sign::Zero if a.leaves != b.leaves => {
                if a.leaves {
                    Sign::Positive
                } else {
                    Sign::Negative
                }
            }
            sign => -sign,
        }
    }
}

/// Fills a cycle of edges without length with triangles without area. A cycle that passes through a vertex twice is two
/// cycles.
fn fill(mut cycle: Vec<Vertex>, out: &mut Output) {
    let twice =
        (0..cycle.len()).find_map(|at| Some((at, at + 1 + cycle[at + 1..].iter().position(|v| *v == cycle[at])?)));
    if let Some((from, to)) = twice {
        fill(cycle.drain(from..to).collect(), out);
        return fill(cycle, out);
    }
    for pair in cycle.get(1..).unwrap_or_default().windows(2) {
        out.flat([cycle[0], pair[1], pair[0]]);
    }
}

/// Divides the directions around a position where an edge passes through it: the inside is on one side of the edge, so
/// two edges in a row leave the position, and two edges in a row arrive. Corners on different sides are not linked. If
/// signs are wrong, a corner may have an edge on each side; then nothing is divided.
fn sides_of_an_edge(mut around: Vec<Direction>) -> Vec<Vec<Direction>> {
    let follows = |at: &usize| around[*at].leaves == around[(at + around.len() - 1) % around.len()].leaves;
    let doubles: Vec<usize> = (0..around.len()).filter(follows).collect();
    let [first, second] = doubles[..] else { return vec![around] };
    let side = &around[first..second];
    let is_whole = |direction: &Direction| side.iter().filter(|other| other.corner == direction.corner).count() == 2;
    if !side.iter().all(is_whole) {
        return vec![around];
    }
    around.rotate_left(first);
    let rest = around.split_off(second - first);
    vec![around, rest]
}

/// The rank of each vertex in the order of the sweep; vertices at one position have equal ranks.
pub(super) fn ranks<P: Predicates + ?Sized>(view: &View<'_, P>, vertices: &[Vertex]) -> Vec<u32> {
    rank(view, vertices, &sorted(view, vertices))
}

fn rank<P: Predicates + ?Sized>(view: &View<'_, P>, vertices: &[Vertex], order: &[u32]) -> Vec<u32> {
    let mut rank = vec![0; vertices.len()];
    let mut place = 0;
    for pair in order.windows(2) {
        let [u, v] = [pair[0], pair[1]].map(|corner| vertices[corner as usize]);
        place += u32::from(view.order(u, v) != Sign::Zero);
        rank[pair[1] as usize] = place;
    }
    rank
}

/// All corners in the order of the sweep: sorted by input coordinates first, then by signs.
fn sorted<P: Predicates + ?Sized>(view: &View<'_, P>, vertices: &[Vertex]) -> Vec<u32> {
    let scene = view.session.scene();
    let key = |v: Vertex| match v.is_constructed() {
        true => [f64::INFINITY; 2],
        false => view.axes.map(|axis| scene.coordinate(axis, v)),
    };
    let mut keyed: Vec<([f64; 2], u32, Vertex)> = (0..).zip(vertices).map(|(at, &v)| (key(v), at, v)).collect();
    keyed.sort_unstable_by(|(p, i, _), (q, j, _)| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])).then(i.cmp(j)));
    let mut order: Vec<(u32, Vertex)> = keyed.into_iter().map(|(_, at, v)| (at, v)).collect();
    sort_by_sign(&mut order, |a, b| view.order(a.1, b.1));
    order.into_iter().map(|(at, _)| at).collect()
}
