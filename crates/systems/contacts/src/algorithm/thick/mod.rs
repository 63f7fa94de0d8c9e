//! Thick primitives: vertices and edges with a radius, for programs that only have floating point.
//!
//! A vertex is a disc; an edge is all that is within its radius of the straight line between two vertices. A point is
//! to the left of an edge, to its right, or *on* it: [`side`] has three values (Rhodes, *Computational Geometry*, the
//! slides on tolerant geometry). Touching primitives are made to coincide, so that later queries are unambiguous:
//! 1. Discs that overlap become one disc, which covers them. Their edges become thicker by as much as their ends move.
//! 2. A disc that overlaps an edge divides it there. The parts are thick enough to cover the old edge. A vertex is at
//!    least as thick as its edges.
//! 3. Edges that still cross are divided by a new vertex, as if it were on both: the edges become thick enough to reach
//!    its rounded position.
//!
//! The results of a step are thick again and may overlap other primitives, so the steps are repeated until nothing
//! changes.
//!
//! # Guarantees
//! Each disc and edge covers the primitives that it was made from. Their thickness is unbounded: if features are closer
//! than the radii, discs merge with them, and larger discs merge with more. [`Settled::largest`] gives the largest
//! radius. The algorithm ends after at most [`MOST_ROUNDS`] rounds; [`Settled::is_settled`] is false if primitives
//! still overlap.

mod round;
mod shape;

use round::Round;

pub use shape::{Disc, Side, side};

/// The maximum number of rounds of [`settle`]; overlaps that remain after them are left.
pub const MOST_ROUNDS: usize = 64;

/// A thick edge between two discs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Edge {
    /// The discs at its ends, by their indices in [`Drawing::discs`].
    pub ends: [u32; 2],
    /// The radius: an upper bound on the distance of the represented edge from the line between the centres of its
    /// ends.
    pub radius: f64,
    /// For each of two polygons, the number of passes from the first end to the second minus the number of passes back.
    pub passes: [i32; 2],
}

/// Discs, and edges between them.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Drawing {
    /// The vertices.
    pub discs: Vec<Disc>,
    /// The edges.
    pub edges: Vec<Edge>,
}

/// The result of [`settle`]: a drawing in which only edges and their ends overlap, and the counts of its changes.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Settled {
    /// The drawing, without edges with as many passes forth as back, and without isolated discs.
    pub drawing: Drawing,
    /// The number of discs that were merged into others.
    pub merged: usize,
    /// The number of times that an edge was divided at an existing disc.
    pub divided: usize,
    /// The number of crossings that became discs.
    pub crossed: usize,
    /// True if nothing overlaps any more; false if [`MOST_ROUNDS`] rounds were not enough.
    pub is_settled: bool,
}

impl Settled {
    /// The largest radius of a disc or an edge.
    #[must_use]
    pub fn largest(&self) -> f64 {
        let discs = self.drawing.discs.iter().map(|disc| disc.radius);
        discs.chain(self.drawing.edges.iter().map(|edge| edge.radius)).fold(0.0, f64::max)
    }
}

/// Merges overlapping discs, and divides edges at discs that overlap them and at crossings, until nothing overlaps.
///
/// # Panics
/// If the index of an edge's end is not that of a disc.
#[must_use]
pub fn settle(drawing: Drawing) -> Settled {
    let mut settled = Settled { drawing, ..Settled::default() };
    for _ in 0..MOST_ROUNDS {
        settled.drawing.tidy();
        let round = Round::of(&settled.drawing);
        let merged = round.merged();
        if merged.count > 0 {
            settled.merged += merged.count;
            settled.drawing.thicken(&merged.discs, &merged.place);
            settled.drawing.replace(merged.discs, &merged.place);
            continue;
        }
        let cuts = round.touched();
        let cuts = if cuts.is_empty() {
            let (discs, cuts) = round.crossed();
            settled.crossed += discs.len();
            settled.drawing.discs.extend(discs);
            cuts
        } else {
            settled.divided += cuts.len();
            cuts
        };
        if cuts.is_empty() {
            settled.is_settled = true;
            break;
        }
        settled.drawing.divide(cuts);
    }
    settled.drawing.tidy();
    settled
}

/// A vertex on an edge: the edge, the position along it, the vertex.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Cut {
    edge: u32,
    along: f64,
    disc: u32,
}

impl Drawing {
    /// Renumbers the ends of edges.
    fn replace(&mut self, discs: Vec<Disc>, place: &[u32]) {
        self.discs = discs;
        for edge in &mut self.edges {
            edge.ends = edge.ends.map(|end| place[end as usize]);
        }
    }

    /// Makes edges thicker by the distance by which their ends move to other discs.
    fn thicken(&mut self, discs: &[Disc], place: &[u32]) {
        for edge in &mut self.edges {
            let moved = edge.ends.map(|end| self.discs[end as usize].apart(discs[place[end as usize] as usize]));
            edge.radius = shape::up(edge.radius + moved[0].max(moved[1]));
        }
    }

    /// Divides edges at their cuts.
    fn divide(&mut self, mut cuts: Vec<Cut>) {
        cuts.sort_by(|a, b| (a.edge, a.along).partial_cmp(&(b.edge, b.along)).unwrap_or(std::cmp::Ordering::Equal));
        for group in cuts.chunk_by(|a, b| a.edge == b.edge) {
            let Edge { ends: [from, to], radius, passes } = self.edges[group[0].edge as usize];
            let line = [from, to].map(|end| self.discs[end as usize].centre);
            let off = |disc: u32| shape::distance_at_most(line, self.discs[disc as usize].centre);
            let stops: Vec<u32> = [from].into_iter().chain(group.iter().map(|cut| cut.disc)).chain([to]).collect();
            let mut parts = stops.windows(2).map(|part| {
                // The old edge is between the two ends of the part; its distance from their line is at most that of the
                // farther end.
                let radius = shape::up(radius + off(part[0]).max(off(part[1])));
                Edge { ends: [part[0], part[1]], radius, passes }
            });
            let parts: Vec<Edge> = parts.by_ref().collect();
            self.edges[group[0].edge as usize] = parts[0];
            self.edges.extend(&parts[1..]);
        }
    }

    /// Merges equal edges, removes edges without effect and isolated discs, and makes discs as thick as their edges.
    fn tidy(&mut self) {
        for edge in &mut self.edges {
            if edge.ends[0] > edge.ends[1] {
                edge.ends.reverse();
                edge.passes = edge.passes.map(|times| -times);
            }
        }
        self.edges.sort_by_key(|edge| edge.ends);
        self.edges.dedup_by(|other, kept| {
            let is_equal = other.ends == kept.ends;
            if is_equal {
                kept.radius = kept.radius.max(other.radius);
                kept.passes = [0, 1].map(|at| kept.passes[at] + other.passes[at]);
            }
            is_equal
        });
        self.edges.retain(|edge| edge.ends[0] != edge.ends[1] && edge.passes != [0, 0]);
        let mut place = vec![u32::MAX; self.discs.len()];
        for edge in &self.edges {
            for end in edge.ends {
                place[end as usize] = 0;
                let disc = &mut self.discs[end as usize];
                disc.radius = disc.radius.max(edge.radius);
            }
        }
        let mut kept = Vec::new();
        for (disc, place) in self.discs.iter().zip(&mut place).filter(|(_, place)| **place == 0) {
            *place = number(kept.len());
            kept.push(*disc);
        }
        self.replace(kept, &place);
    }
}

fn number(place: usize) -> u32 {
    u32::try_from(place).expect("fewer than 2^32 discs and edges")
}
