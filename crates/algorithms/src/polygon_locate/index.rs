//! The edges of a map, each once, with the regions that they bound.

use predicament_grid::Columns;
use predicament_mesh::PolygonMap;
use predicament_predicates::{Plane, Scene, Vertex};

/// A map made ready for queries; it depends on coordinates only through its
/// broad phase, and on no backend.
#[derive(Clone, Debug)]
pub struct LocateIndex {
    edges: Vec<Edge>,
    /// The distinct sets of owners, one after another; a map has few.
    owner_sets: Vec<Vec<u32>>,
    regions: usize,
    columns: Columns,
}

#[derive(Clone, Copy, Debug)]
struct Edge {
    ends: [Vertex; 2],
    owners: u32,
}

impl LocateIndex {
    /// An index of the map's edges.
    ///
    /// An edge is known by its two vertices, whichever way it runs, and is
    /// owned by the regions that use it an odd number of times: used twice by
    /// one region, it bounds that region on neither side.
    ///
    /// # Panics
    /// If the map uses vertices that the scene lacks, or has 2^32 edges or
    /// regions.
    #[must_use]
    pub fn new(map: &PolygonMap, scene: &Scene) -> LocateIndex {
        let mut uses: Vec<([Vertex; 2], u32)> = map
            .edges()
            .map(|(region, [a, b])| {
                ([a.min(b), a.max(b)], u32::try_from(region).expect("a map has fewer than 2^32 regions"))
            })
            .collect();
        uses.sort_unstable();

        let mut sets = OwnerSets::default();
        let mut edges = Vec::new();
        for uses in uses.chunk_by(|a, b| a.0 == b.0) {
            let odd = uses.chunk_by(|a, b| a == b).filter(|same| same.len() % 2 == 1);
            let owners: Vec<u32> = odd.map(|same| same[0].1).collect();
            if !owners.is_empty() {
                edges.push(Edge { ends: uses[0].0, owners: sets.intern(owners) });
            }
        }

        let point = |v| scene.point2(Plane::Xy, v);
        // A query's candidates share an x: keep them close together in memory.
        for edge in &mut edges {
            let [u, v] = edge.ends;
            if point(v)[0] < point(u)[0] {
                edge.ends = [v, u];
            }
        }
        edges.sort_by(|a, b| point(a.ends[0])[0].total_cmp(&point(b.ends[0])[0]));

        let segments: Vec<_> = edges.iter().map(|edge| edge.ends.map(point)).collect();
        LocateIndex {
            edges,
            owner_sets: sets.into_sets(),
            regions: map.regions().len(),
            columns: Columns::new(&segments),
        }
    }

    /// The number of regions in the map.
    #[must_use]
    pub fn regions(&self) -> usize {
        self.regions
    }

    /// The number of edges that bound a region.
    #[must_use]
    pub fn len(&self) -> usize {
        self.edges.len()
    }

    /// Whether the map bounds nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The numbers of all edges.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = u32> + use<> {
        let count = u32::try_from(self.edges.len()).expect("checked when the columns were made");
        0..count
    }

    /// The two vertices of an edge, from left to right by raw coordinates; the
    /// smaller index first where those are equal.
    ///
    /// # Panics
    /// If there is no such edge.
    #[inline]
    #[must_use]
    pub fn ends(&self, edge: u32) -> [Vertex; 2] {
        self.edges[edge as usize].ends
    }

    /// The regions that an edge bounds, ascending; never none.
    ///
    /// # Panics
    /// If there is no such edge.
    #[inline]
    #[must_use]
    pub fn owners(&self, edge: u32) -> &[u32] {
        self.owner_set(self.owner_set_of(edge))
    }

    /// The number of distinct sets of owners; many edges share one.
    pub(super) fn owner_sets(&self) -> usize {
        self.owner_sets.len()
    }

    #[inline]
    pub(super) fn owner_set_of(&self, edge: u32) -> u32 {
        self.edges[edge as usize].owners
    }

    #[inline]
    pub(super) fn owner_set(&self, set: u32) -> &[u32] {
        &self.owner_sets[set as usize]
    }

    /// The broad phase; its segments are the edges.
    #[inline]
    #[must_use]
    pub fn columns(&self) -> &Columns {
        &self.columns
    }
}

/// Numbers sets in the order in which they first come up.
#[derive(Default)]
struct OwnerSets {
    ids: std::collections::BTreeMap<Vec<u32>, u32>,
}

impl OwnerSets {
    fn intern(&mut self, set: Vec<u32>) -> u32 {
        let next = u32::try_from(self.ids.len()).expect("there are no more sets than edges");
        *self.ids.entry(set).or_insert(next)
    }

    fn into_sets(self) -> Vec<Vec<u32>> {
        let mut sets = vec![Vec::new(); self.ids.len()];
        for (set, id) in self.ids {
            sets[id as usize] = set;
        }
        sets
    }
}
