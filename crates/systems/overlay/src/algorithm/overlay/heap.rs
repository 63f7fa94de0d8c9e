//! A binary heap with an external order, which may contradict itself.

use predicament_predicates::{Sign, Vertex};

/// Vertices, with access to the first by an order.
#[derive(Default)]
pub(super) struct Heap(Vec<Vertex>);

impl Heap {
    /// The first vertex.
    pub fn first(&self) -> Option<Vertex> {
        self.0.first().copied()
    }

    /// Adds a vertex.
    pub fn push(&mut self, v: Vertex, order: impl Fn(Vertex, Vertex) -> Sign) {
        let mut at = self.0.len();
        self.0.push(v);
        while at > 0 {
            let parent = (at - 1) / 2;
            if order(self.0[at], self.0[parent]) != Sign::Negative {
                break;
            }
            self.0.swap(at, parent);
            at = parent;
        }
    }

    /// Removes the first vertex.
    pub fn pop(&mut self, order: impl Fn(Vertex, Vertex) -> Sign) {
        let Some(last) = self.0.pop() else { return };
        let Some(first) = self.0.first_mut() else { return };
        *first = last;
        let mut at = 0;
        loop {
            let children = 2 * at + 1..(2 * at + 3).min(self.0.len());
            let least = children.reduce(|a, b| if order(self.0[b], self.0[a]) == Sign::Negative { b } else { a });
            match least {
                Some(child) if order(self.0[child], self.0[at]) == Sign::Negative => {
                    self.0.swap(at, child);
                    at = child;
                }
                _ => return,
            }
        }
    }
}
