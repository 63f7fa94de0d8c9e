//! The plane sweep: it makes triangles directly, without intermediate monotone pieces.
//!
//! Regions of the inside lie between the edges that the sweep line crosses. Each region knows its lower and its upper
//! edge, and the chain from the left end of the lower edge to that of the upper edge. The chain bounds the part on its
//! left that has no triangles yet. When a vertex arrives at an end of the chain, the sweep cuts off triangles with it
//! while the chain's corners are convex (Hertel and Mehlhorn 1983). Only a vertex with both of its edges on the right
//! needs a search for its region.
//!
//! Whatever the signs are, each edge bounds exactly one region, each region has a lower and an upper edge, and every
//! event closes what it opens. So the triangles always form a surface with the right boundary. Signs decide only
//! whether that surface is flat.

use predicament_predicates::{Predicates, Sign, Vertex};

use super::corners::Corners;
use super::view::View;
use super::{Contradiction, NONE, Output, number};
use predicament_grid::status::Status;

/// A part of the inside that the sweep line crosses.
struct Region {
    /// The corner at which the lower edge begins, on the left.
    lower: u32,
    /// The corner at which the upper edge begins, on the right.
    upper: u32,
    /// The lower end of the chain.
    low: u32,
    /// The upper end of the chain.
    high: u32,
    /// The newest node of the chain: nothing hides it from the next vertex in the region.
    last: u32,
}

/// A corner in a chain.
struct Node {
    corner: u32,
    up: u32,
    down: u32,
    /// True if the region of the chain begins above the corner.
    is_above: bool,
}

/// A corner at which a walk divides the inside, and an earlier corner that it sees.
pub(super) struct Bridge {
    pub split: u32,
    pub seen: u32,
    /// The side of the seen corner on which the other corner's region begins: true above it, false below it. A corner
    /// whose edges do not both go to the right has one region, and either value names it.
    pub is_above: bool,
}

/// The event at a corner; events at one position are processed in this order.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Event {
    /// Both edges end here.
    Closing,
    /// The lower edge of a region ends and the next one begins.
    Lower,
    /// The upper edge of a region ends and the next one begins.
    Upper,
    /// Both edges begin here, and the outside is between them.
    Split,
    /// Both edges begin here, and the inside is between them.
    Start,
}

/// The sweep over all corners.
pub(super) struct Sweep<'a, P: ?Sized> {
    view: &'a View<'a, P>,
    corners: &'a Corners,
    out: &'a mut Output,
    regions: Vec<Region>,
    nodes: Vec<Node>,
    /// The region that each edge bounds, by the corner at which the edge begins.
    region_of: Vec<u32>,
    status: Status,
    /// True if the sweep makes triangles.
    cuts: bool,
    bridges: Vec<Bridge>,
}

/// Triangulates the region that the walks bound.
pub(super) fn triangulate<P: Predicates + ?Sized>(view: &View<'_, P>, corners: &Corners, out: &mut Output) {
    Sweep::new(view, corners, out, true).run();
}

/// A bridge to each corner at which a walk divides the inside, in the order of the sweep.
pub(super) fn bridges<P: Predicates + ?Sized>(view: &View<'_, P>, corners: &Corners, out: &mut Output) -> Vec<Bridge> {
    let mut sweep = Sweep::new(view, corners, out, false);
    sweep.run();
    sweep.bridges
}

impl<'a, P: Predicates + ?Sized> Sweep<'a, P> {
    fn new(view: &'a View<'a, P>, corners: &'a Corners, out: &'a mut Output, cuts: bool) -> Self {
        let region_of = vec![NONE; corners.vertex.len()];
        Sweep {
            view,
            corners,
            out,
            regions: Vec::new(),
            nodes: Vec::with_capacity(if cuts { corners.vertex.len() } else { 0 }),
            region_of,
            status: Status::default(),
            cuts,
            bridges: Vec::new(),
        }
    }

    fn run(&mut self) {
        let corners = self.corners;
        let mut here = Vec::new();
        for place in corners.places() {
            here.clear();
            here.extend(place.iter().filter(|&&c| corners.is_linked(c)).map(|&c| (self.event(c), c)));
            if here.len() > 1 {
                here.sort_by_key(|&(event, _)| event);
            }
            for &(event, corner) in &here {
                match event {
                    Event::Closing => self.close(corner),
                    Event::Lower => self.advance_lower(corner),
                    Event::Upper => self.advance_upper(corner),
                    Event::Split => self.split(corner),
                    Event::Start => self.start(corner),
                }
            }
        }
    }

    fn event(&self, corner: u32) -> Event {
        let corners = self.corners;
        let after = corners.is_before(corner, corners.next[corner as usize]);
        let before = corners.is_before(corner, corners.previous[corner as usize]);
        match (before, after) {
            (false, false) => Event::Closing,
            (false, true) => Event::Lower,
            (true, false) => Event::Upper,
            (true, true) if self.turn_at(corner) == Sign::Negative => Event::Split,
            (true, true) => Event::Start,
        }
    }

    fn vertex(&self, corner: u32) -> Vertex {
        self.corners.vertex[corner as usize]
    }

    fn turn_at(&self, corner: u32) -> Sign {
        let [before, after] = [self.corners.previous[corner as usize], self.corners.next[corner as usize]];
        let [a, b, c] = [before, corner, after].map(|corner| self.vertex(corner));
        self.view.turn(a, b, c)
    }

    /// The side of the edge that begins at `edge` on which another corner lies: positive on the left. If the corner is
    /// on the edge's line, its neighbours decide.
    fn side(&self, edge: u32, corner: u32) -> Sign {
        let [a, b] = [edge, self.corners.next[edge as usize]].map(|corner| self.vertex(corner));
        let [before, after] = [self.corners.previous[corner as usize], self.corners.next[corner as usize]];
        let signs = [corner, after, before].into_iter().map(|c| self.view.turn(a, b, self.vertex(c)));
        let mut decided = signs.filter(|sign| *sign != Sign::Zero);
        decided.next().unwrap_or(Sign::Zero)
    }

    /// The region whose lower edge is the next edge below a corner.
    fn region_below(&self, corner: u32) -> Option<u32> {
        self.status.last_below(|region| self.side(self.regions[region as usize].lower, corner) == Sign::Positive)
    }

    /// True if a corner is below the upper edge of a region; together with [`Self::region_below`], true if it is
    /// inside.
    fn is_below_upper(&self, region: u32, corner: u32) -> bool {
        // Upper edges go to the left.
        self.side(self.regions[region as usize].upper, corner) == Sign::Positive
    }

    fn node(&mut self, corner: u32, is_above: bool) -> u32 {
        self.nodes.push(Node { corner, up: NONE, down: NONE, is_above });
        number(self.nodes.len() - 1)
    }

    fn join(&mut self, below: u32, above: u32) {
        self.nodes[below as usize].up = above;
        self.nodes[above as usize].down = below;
    }

    /// Opens a region between both edges of a corner on the right, above another region.
    fn open(&mut self, below: Option<u32>, corner: u32, chain: u32) -> u32 {
        let region = number(self.regions.len());
        let upper = self.corners.previous[corner as usize];
        self.regions.push(Region { lower: corner, upper, low: chain, high: chain, last: chain });
        self.region_of[corner as usize] = region;
        self.region_of[upper as usize] = region;
        self.status.insert_above(below, region);
        region
    }

    fn start(&mut self, corner: u32) {
        let below = self.region_below(corner);
        if below.is_some_and(|region| self.is_below_upper(region, corner)) {
            self.out.broken(Contradiction::Start);
        }
        let chain = self.node(corner, true);
        self.open(below, corner, chain);
    }

    fn split(&mut self, corner: u32) {
        let Some(below) = self.region_below(corner).filter(|&region| self.is_below_upper(region, corner)) else {
            self.out.broken(Contradiction::Split);
            return self.start_inverted(corner);
        };
        let Region { upper, high, last, .. } = self.regions[below as usize];
        let Node { corner: seen, is_above, .. } = self.nodes[last as usize];
        self.bridges.push(Bridge { split: corner, seen, is_above });
        // The chain is divided at its last corner, which then belongs to both parts.
        let above = self.nodes[last as usize].up;
        let copy = self.node(seen, is_above);
        if above != NONE {
            self.join(copy, above);
        }
        self.nodes[last as usize].up = NONE;
        let new = self.open(Some(below), corner, copy);
        let (region, other) = (&mut self.regions[below as usize], self.corners.previous[corner as usize]);
        (region.upper, region.high, region.last) = (other, last, last);
        self.region_of[other as usize] = below;
        let region = &mut self.regions[new as usize];
        (region.upper, region.high) = (upper, if high == last { copy } else { high });
        self.region_of[upper as usize] = new;
        self.push_high(below, corner);
        self.push_low(new, corner);
    }

    /// Opens a region at a split vertex that is in no region according to the signs, as a start vertex does.
    fn start_inverted(&mut self, corner: u32) {
        let below = self.region_below(corner);
        let chain = self.node(corner, true);
        self.open(below, corner, chain);
    }

    fn advance_lower(&mut self, corner: u32) {
        let region = self.region_of[self.corners.previous[corner as usize] as usize];
        self.push_low(region, corner);
        self.regions[region as usize].lower = corner;
        self.region_of[corner as usize] = region;
    }

    fn advance_upper(&mut self, corner: u32) {
        let region = self.region_of[corner as usize];
        self.push_high(region, corner);
        let upper = self.corners.previous[corner as usize];
        self.regions[region as usize].upper = upper;
        self.region_of[upper as usize] = region;
    }

    /// Processes a corner whose edges are both on the left: they bound one region, which ends, or two regions, which
    /// merge.
    fn close(&mut self, corner: u32) {
        let above = self.region_of[self.corners.previous[corner as usize] as usize];
        let below = self.region_of[corner as usize];
        if above == below {
            self.status.remove(above);
            self.finish(above, corner);
            return;
        }
        if self.turn_at(corner) == Sign::Positive {
            self.out.broken(Contradiction::End);
        }
        self.status.remove(above);
        self.push_high(below, corner);
        self.push_low(above, corner);
        let Region { upper, low, high, .. } = self.regions[above as usize];
        let node = self.regions[below as usize].high;
        // Both ends at this corner become one node.
        let up = self.nodes[low as usize].up;
        if up == NONE {
            self.regions[below as usize].high = node;
        } else {
            self.join(node, up);
            self.regions[below as usize].high = high;
        }
        self.regions[below as usize].upper = upper;
        self.regions[below as usize].last = node;
        self.region_of[upper as usize] = below;
    }

    /// Cuts off triangles with a corner at the lower end of the chain, while their corners are convex; returns the new
    /// lower end. Up to the last corner of the chain, nothing is between it and the new corner. There even triangles
    /// without area are cut off; they arise only where a vertex is on an edge.
    fn cut_low(&mut self, region: u32, corner: u32) -> u32 {
        let Region { mut low, last, .. } = self.regions[region as usize];
        let v = self.vertex(corner);
        let mut is_past = low == last || !self.cuts;
        loop {
            let up = self.nodes[low as usize].up;
            if up == NONE || !self.cuts {
                return low;
            }
            let [b, a] = [low, up].map(|node| self.vertex(self.nodes[node as usize].corner));
            let sign = self.view.turn(v, a, b);
            if !(sign == Sign::Positive || sign == Sign::Zero && !is_past) {
                if !is_past {
                    self.out.broken(Contradiction::Chain);
                }
                return low;
            }
            self.out.triangle([v, a, b]);
            low = up;
            is_past |= low == last;
        }
    }

    /// Cuts off triangles at the upper end, as `cut_low` does at the lower end.
    fn cut_high(&mut self, region: u32, corner: u32) -> u32 {
        let Region { mut high, last, .. } = self.regions[region as usize];
        let v = self.vertex(corner);
        let mut is_past = high == last || !self.cuts;
        loop {
            let down = self.nodes[high as usize].down;
            if down == NONE || !self.cuts {
                return high;
            }
            let [a, b] = [high, down].map(|node| self.vertex(self.nodes[node as usize].corner));
            let sign = self.view.turn(v, a, b);
            if !(sign == Sign::Positive || sign == Sign::Zero && !is_past) {
                if !is_past {
                    self.out.broken(Contradiction::Chain);
                }
                return high;
            }
            self.out.triangle([v, a, b]);
            high = down;
            is_past |= high == last;
        }
    }

    /// Appends a corner at the lower end of a chain.
    fn push_low(&mut self, region: u32, corner: u32) {
        let low = self.cut_low(region, corner);
        let node = self.node(corner, true);
        self.nodes[low as usize].down = NONE;
        if self.cuts {
            self.join(node, low);
        }
        let Region { high, .. } = self.regions[region as usize];
        let region = &mut self.regions[region as usize];
        (region.low, region.last) = (node, node);
        region.high = if self.cuts { high } else { node };
    }

    /// Appends a corner at the upper end of a chain.
    fn push_high(&mut self, region: u32, corner: u32) {
        let high = self.cut_high(region, corner);
        let node = self.node(corner, false);
        self.nodes[high as usize].up = NONE;
        if self.cuts {
            self.join(high, node);
        }
        let region = &mut self.regions[region as usize];
        (region.high, region.last) = (node, node);
        if !self.cuts {
            region.low = node;
        }
    }

    /// Triangulates the rest of a region at its last corner.
    fn finish(&mut self, region: u32, corner: u32) {
        let low = self.cut_low(region, corner);
        self.nodes[low as usize].down = NONE;
        if self.nodes[low as usize].up == NONE {
            return;
        }
        self.regions[region as usize].low = low;
        // If the last corner was cut off, all remaining corners are on the upper side.
        self.regions[region as usize].last = low;
        let mut high = self.cut_high(region, corner);
        let v = self.vertex(corner);
        while self.nodes[high as usize].down != NONE {
            let down = self.nodes[high as usize].down;
            let [a, b] = [high, down].map(|node| self.vertex(self.nodes[node as usize].corner));
            self.out.triangle([v, a, b]);
            high = down;
        }
    }
}
