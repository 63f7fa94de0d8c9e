//! Thick primitives: vertices and edges with a radius, for programs that have nothing but floating point.
//!
//! A vertex is a disc, an edge is all that is within its radius of the straight line between two vertices. A point is to the left
//! of an edge, to its right, or *on* it: [`side`] has three values (Rhodes, *Computational Geometry*, the slides on tolerant
//! geometry). What touches is made to coincide, so that no later question has an ambiguous answer:
//! 1. Discs that overlap become one disc, which covers them. Their edges become thicker by as much as their ends move.
//! 2. A disc that overlaps an edge divides it there. The parts are as thick as they have to be to cover the edge that was.
//!    A vertex is at least as thick as its edges.
//! 3. Edges that still cross are divided by a new vertex as if it were on both: wherever rounding has put it, it reaches them.
//!
//! Whatever a step makes is thick again and may overlap something else, so that the steps are repeated until nothing changes.
//!
//! # What holds
//! Each disc and edge covers what it has come from. Nothing bounds how thick they become: where features are closer than the
//! radii, discs swallow them, and the larger they are the more they swallow. [`Settled::largest`] tells.
//! It ends after [`MOST_ROUNDS`] rounds at the latest; [`Settled::is_settled`] says whether something still overlapped.

mod round;
mod shape;

use round::Round;

pub use shape::{Disc, Side, side};

/// The most rounds that [`settle`] makes; a drawing in which something overlaps after these is left as it is.
pub const MOST_ROUNDS: usize = 64;

/// A thick edge between two discs.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Edge {
    /// The discs at its ends, by their places in [`Drawing::discs`].
    pub ends: [u32; 2],
    /// Its radius: how far what it stands for may be from the line between the centres of its ends.
    pub radius: f64,
    /// How many times each of two polygons passes it from its first end to its second, less how many times back.
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

/// The result of [`settle`]: a drawing in which nothing overlaps but edges with their ends, and how it was made.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct Settled {
    /// The drawing. Edges that are passed as often forth as back are left out, and discs without edges.
    pub drawing: Drawing,
    /// How many discs were merged into others.
    pub merged: usize,
    /// How many times an edge was divided at a disc that was there.
    pub divided: usize,
    /// How many crossings became discs.
    pub crossed: usize,
    /// Whether nothing overlaps any more; false after [`MOST_ROUNDS`] rounds that were not enough.
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

/// Merges discs that overlap, and divides edges at discs that overlap them and where they cross, until nothing overlaps.
///
/// # Panics
/// If an edge ends in a disc that is not there.
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

/// A vertex on an edge: the edge, how far along it, the vertex.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Cut {
    edge: u32,
    along: f64,
    disc: u32,
}

impl Drawing {
    /// Gives the edges other ends.
    fn replace(&mut self, discs: Vec<Disc>, place: &[u32]) {
        self.discs = discs;
        for edge in &mut self.edges {
            edge.ends = edge.ends.map(|end| place[end as usize]);
        }
    }

    /// Makes edges as much thicker as their ends move to other discs.
    fn thicken(&mut self, discs: &[Disc], place: &[u32]) {
        for edge in &mut self.edges {
            let moved = edge.ends.map(|end| self.discs[end as usize].apart(discs[place[end as usize] as usize]));
            edge.radius = shape::up(edge.radius + moved[0].max(moved[1]));
        }
    }

    /// Divides edges where they are cut.
    fn divide(&mut self, mut cuts: Vec<Cut>) {
        cuts.sort_by(|a, b| (a.edge, a.along).partial_cmp(&(b.edge, b.along)).unwrap_or(std::cmp::Ordering::Equal));
        for group in cuts.chunk_by(|a, b| a.edge == b.edge) {
            let Edge { ends: [from, to], radius, passes } = self.edges[group[0].edge as usize];
            let line = [from, to].map(|end| self.discs[end as usize].centre);
            let off = |disc: u32| shape::distance_at_most(line, self.discs[disc as usize].centre);
            let stops: Vec<u32> = [from].into_iter().chain(group.iter().map(|cut| cut.disc)).chain([to]).collect();
            let mut parts = stops.windows(2).map(|part| {
                // The edge that was is between the two of them, no farther off than its farther end.
                let radius = shape::up(radius + off(part[0]).max(off(part[1])));
                Edge { ends: [part[0], part[1]], radius, passes }
            });
            let parts: Vec<Edge> = parts.by_ref().collect();
            self.edges[group[0].edge as usize] = parts[0];
            self.edges.extend(&parts[1..]);
        }
    }

    /// Makes one of equal edges, leaves out those without effect and discs without edges, and makes discs as thick as their edges.
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
