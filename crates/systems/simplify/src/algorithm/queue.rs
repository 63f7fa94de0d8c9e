//! The queue of edges, the smallest error first.
//!
//! An edge may be in the queue several times. Each has a number, and only the edge's last number counts.

use std::cmp::{Ordering, Reverse};
use std::collections::BinaryHeap;

use predicament_mesh::HalfEdgeMesh;
use predicament_mesh::half_edge::{HalfEdge, MeshVertex};

/// An edge in the queue. Equal errors are ordered by the edge's vertices.
struct Entry {
    error: f64,
    ends: [MeshVertex; 2],
    edge: HalfEdge,
    number: u32,
}

impl Ord for Entry {
    fn cmp(&self, other: &Entry) -> Ordering {
        let order = self.error.total_cmp(&other.error).then(self.ends.cmp(&other.ends));
        order.then(self.number.cmp(&other.number))
    }
}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Entry) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Entry {
    fn eq(&self, other: &Entry) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Entry {}

/// The state of an edge: the number of its entry that counts, and whether it was refused since.
#[derive(Clone, Copy, Default)]
struct Mark {
    number: u32,
    is_refused: bool,
}

pub(super) struct Queue {
    entries: BinaryHeap<Reverse<Entry>>,
    marks: Vec<Mark>,
}

impl Queue {
    /// An empty queue for the edges of a mesh. The mesh gets no further edges.
    pub(super) fn new(mesh: &HalfEdgeMesh) -> Queue {
        let count = mesh.half_edges().last().map_or(0, |h| h.index() + 1);
        Queue { entries: BinaryHeap::with_capacity(count), marks: vec![Mark::default(); count] }
    }

    /// Adds an edge. Its earlier entries count no more.
    pub(super) fn push(&mut self, edge: HalfEdge, error: f64, ends: [MeshVertex; 2]) {
        let mark = &mut self.marks[edge.index()];
        *mark = Mark { number: mark.number + 1, is_refused: false };
        self.entries.push(Reverse(Entry { error, ends, edge, number: mark.number }));
    }

    /// Removes the edge with the smallest error.
    pub(super) fn pop(&mut self) -> Option<HalfEdge> {
        loop {
            let Reverse(Entry { edge, number, .. }) = self.entries.pop()?;
            if self.marks[edge.index()].number == number {
                return Some(edge);
            }
        }
    }

    /// Marks an edge as refused.
    pub(super) fn refuse(&mut self, edge: HalfEdge) {
        self.marks[edge.index()].is_refused = true;
    }

    /// True if the edge was refused, and was not added since.
    pub(super) fn is_refused(&self, edge: HalfEdge) -> bool {
        self.marks[edge.index()].is_refused
    }
}
