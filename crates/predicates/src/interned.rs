//! A list of constructions that holds each once.
//!
//! A vertex is its definition, so the same definition always gives the same
//! vertex. Ids are places in the list: they depend on the order in which
//! definitions are added and on nothing else.

use std::collections::HashMap;

use crate::{Construction, Vertex};

/// Constructions in canonical form, by id, and the id of each.
#[derive(Clone, PartialEq, Default)]
pub(crate) struct Interned {
    list: Vec<Construction>,
    /// The inverse of `list`; never iterated, as its order is arbitrary.
    vertices: HashMap<Construction, Vertex>,
}

impl Interned {
    /// In the order of their ids.
    #[inline]
    pub(crate) fn list(&self) -> &[Construction] {
        &self.list
    }

    /// The vertex of a construction that is in the list.
    pub(crate) fn vertex(&self, construction: &Construction) -> Option<Vertex> {
        self.vertices.get(construction).copied()
    }

    /// Adds a construction that is not in the list.
    pub(crate) fn push(&mut self, construction: Construction) -> Vertex {
        let vertex = Vertex::constructed(self.list.len());
        self.list.push(construction);
        self.vertices.insert(construction, vertex);
        vertex
    }

    /// Removes all but the first so many.
    pub(crate) fn truncate(&mut self, count: usize) {
        for construction in self.list.drain(count..) {
            self.vertices.remove(&construction);
        }
    }
}

/// The list alone.
impl std::fmt::Debug for Interned {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.list.fmt(f)
    }
}
