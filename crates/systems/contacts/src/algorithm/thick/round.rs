//! The overlaps in a drawing.

use predicament_grid::{Bounds, BoxIndex};

use super::shape::{Disc, Side, crossing, distance, side, thick};
use super::{Cut, Drawing, number};

/// A drawing with an index of its discs.
pub(super) struct Round<'d> {
    drawing: &'d Drawing,
    discs: BoxIndex<2>,
}

/// The discs after merging.
pub(super) struct Merged {
    pub discs: Vec<Disc>,
    /// The new index of each old disc.
    pub place: Vec<u32>,
    /// The number of discs that were merged into others.
    pub count: usize,
}

impl<'d> Round<'d> {
    pub fn of(drawing: &'d Drawing) -> Round<'d> {
        Round { drawing, discs: BoxIndex::new(drawing.discs.iter().map(|disc| disc.bounds()).collect()) }
    }

    /// Merges each class of overlapping discs to one disc that covers them.
    pub fn merged(&self) -> Merged {
        let discs = &self.drawing.discs;
        let mut parent: Vec<u32> = (0..number(discs.len())).collect();
        let mut near = Vec::new();
        for (at, disc) in (0..).zip(discs) {
            self.discs.near(&self.discs.boxes()[at as usize], 0.0, &mut near);
            for &other in near.iter().filter(|&&other| other < at) {
                if disc.overlaps(discs[other as usize]) {
                    let [a, b] = [root(&mut parent, at), root(&mut parent, other)];
                    parent[a.max(b) as usize] = a.min(b);
                }
            }
        }
        let mut merged = Merged { discs: Vec::new(), place: vec![0; discs.len()], count: 0 };
        for at in 0..number(discs.len()) {
            let first = root(&mut parent, at);
            if first == at {
                merged.place[at as usize] = number(merged.discs.len());
                merged.discs.push(discs[at as usize]);
            } else {
                // A class begins with its lowest disc.
                let place = merged.place[first as usize];
                merged.place[at as usize] = place;
                let one = &mut merged.discs[place as usize];
                *one = one.cover(discs[at as usize]);
                merged.count += 1;
            }
        }
        merged
    }

    /// Discs on edges that do not end there.
    pub fn touched(&self) -> Vec<Cut> {
        let Drawing { discs, edges } = self.drawing;
        let (mut cuts, mut near) = (Vec::new(), Vec::new());
        for (at, edge) in (0..).zip(edges) {
            let line = self.line(at);
            self.discs.near(&self.edge_bounds(at), 0.0, &mut near);
            near.sort_unstable();
            for &disc in near.iter().filter(|disc| !edge.ends.contains(disc)) {
                let one = discs[disc as usize];
                if side(line, edge.radius, one) == Side::On {
                    cuts.push(Cut { edge: at, along: distance(line, one.centre).1, disc });
                }
            }
        }
        cuts
    }

    /// Crossings of edges that touch no disc but their ends, as new discs after the existing ones.
    pub fn crossed(&self) -> (Vec<Disc>, Vec<Cut>) {
        let Drawing { discs, edges } = self.drawing;
        let index = BoxIndex::new((0..number(edges.len())).map(|at| self.edge_bounds(at)).collect());
        let (mut new, mut cuts, mut near) = (Vec::new(), Vec::new(), Vec::new());
        for (at, edge) in (0..).zip(edges) {
            index.near(&index.boxes()[at as usize], 0.0, &mut near);
            near.sort_unstable();
            for &other in near.iter().filter(|&&other| other < at) {
                let with = edges[other as usize];
                if edge.ends.iter().any(|end| with.ends.contains(end)) {
                    continue;
                }
                let [e, f] = [at, other].map(|at| self.line(at));
                let sides = |line: [[f64; 2]; 2], radius: f64, ends: [u32; 2]| {
                    ends.map(|end| side(line, radius, discs[end as usize]))
                };
                let across = |[a, b]: [Side; 2]| a != b && a != Side::On && b != Side::On;
                if across(sides(e, edge.radius, with.ends)) && across(sides(f, with.radius, edge.ends)) {
                    let (centre, along) = crossing(e, f);
                    let place = number(discs.len() + new.len());
                    // After the division, edges are thick enough to cover the old edges, and vertices are as thick as
                    // their edges.
                    new.push(Disc { centre, radius: 0.0 });
                    cuts.extend([at, other].into_iter().zip(along).map(|(edge, along)| Cut {
                        edge,
                        along,
                        disc: place,
                    }));
                }
            }
        }
        (new, cuts)
    }

    /// The centres of an edge's ends.
    fn line(&self, edge: u32) -> [[f64; 2]; 2] {
        self.drawing.edges[edge as usize].ends.map(|end| self.drawing.discs[end as usize].centre)
    }

    fn edge_bounds(&self, edge: u32) -> Bounds<2> {
        thick(Bounds::of(self.line(edge)), self.drawing.edges[edge as usize].radius)
    }
}

/// The lowest disc of a class.
fn root(parent: &mut [u32], mut at: u32) -> u32 {
    while parent[at as usize] != at {
        parent[at as usize] = parent[parent[at as usize] as usize];
        at = parent[at as usize];
    }
    at
}
