//! The edges of a map, each once, with the regions that they bound.

use std::collections::BTreeMap;

use predicament_grid::{Cells, Columns, Labels};
use predicament_mesh::PolygonMap;
use predicament_predicates::{Plane, Scene, Vertex};

/// The edges of a map with a broad phase over them. It depends on raw coordinates only, not on a backend.
#[derive(Clone, Debug)]
pub struct LocateIndex {
    edges: Vec<Edge>,
    /// The distinct sets of regions: the owners of edges first, then the sets that cover cells. A map has few.
    sets: Vec<Vec<u32>>,
    owner_sets: usize,
    regions: usize,
    cells: Cells,
    columns: Columns,
}

#[derive(Clone, Copy, Debug)]
struct Edge {
    ends: [Vertex; 2],
    owners: u32,
}

impl LocateIndex {
    /// Builds the index of a map's edges.
    ///
    /// Two vertices identify an edge, in either direction. Its owners are the regions that use it an odd number of
    /// times: if a region uses it twice, it bounds that region on neither side.
    ///
    /// # Panics
    /// If the map uses vertices that the scene lacks, or has 2^32 edges or regions.
    #[must_use]
    pub fn new(map: &PolygonMap, scene: &Scene) -> LocateIndex {
        let mut uses: Vec<([Vertex; 2], u32)> = map
            .edges()
            .map(|(region, [a, b])| {
                ([a.min(b), a.max(b)], u32::try_from(region).expect("a map has fewer than 2^32 regions"))
            })
            .collect();
        uses.sort_unstable();

        let mut sets = Sets::default();
        let mut edges = Vec::new();
        for uses in uses.chunk_by(|a, b| a.0 == b.0) {
            let odd = uses.chunk_by(|a, b| a == b).filter(|same| same.len() % 2 == 1);
            let owners: Vec<u32> = odd.map(|same| same[0].1).collect();
            if !owners.is_empty() {
                edges.push(Edge { ends: uses[0].0, owners: sets.intern(&owners) });
            }
        }
        let owner_sets = sets.sets.len();

        let point = |v| scene.point2(Plane::Xy, v);
        // A query's candidates share an x: their edges are adjacent in memory.
        for edge in &mut edges {
            let [u, v] = edge.ends;
            if point(v)[0] < point(u)[0] {
                edge.ends = [v, u];
            }
        }
        edges.sort_by(|a, b| point(a.ends[0])[0].total_cmp(&point(b.ends[0])[0]));

        let segments: Vec<_> = edges.iter().map(|edge| edge.ends.map(point)).collect();
        let columns = Columns::new(&segments);
        let cells = Cells::new(&segments, &mut Cover { edges: &edges, sets: &mut sets, regions: Vec::new() });
        LocateIndex { edges, sets: sets.sets, owner_sets, regions: map.regions().len(), cells, columns }
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

    /// True if the map bounds no region.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.edges.is_empty()
    }

    /// The indices of all edges.
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

    /// The regions that an edge bounds, ascending; never empty.
    ///
    /// # Panics
    /// If there is no such edge.
    #[inline]
    #[must_use]
    pub fn owners(&self, edge: u32) -> &[u32] {
        self.set(self.owners_of(edge))
    }

    /// The number of owner sets: sets with smaller indices are owners; many edges share one set.
    pub(super) fn owner_sets(&self) -> usize {
        self.owner_sets
    }

    #[inline]
    pub(super) fn owners_of(&self, edge: u32) -> u32 {
        self.edges[edge as usize].owners
    }

    #[inline]
    pub(super) fn set(&self, set: u32) -> &[u32] {
        &self.sets[set as usize]
    }

    /// The cells: the edges near a point, and the regions that cover it from above.
    #[inline]
    pub(super) fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The broad phase that visits all edges above a point; its segments are the edges.
    #[inline]
    #[must_use]
    pub fn columns(&self) -> &Columns {
        &self.columns
    }
}

/// A numbering of sets, in the order in which they first occur.
#[derive(Default)]
struct Sets {
    sets: Vec<Vec<u32>>,
    ids: BTreeMap<Vec<u32>, u32>,
}

impl Sets {
    fn intern(&mut self, set: &[u32]) -> u32 {
        if let Some(&id) = self.ids.get(set) {
            return id;
        }
        let id = u32::try_from(self.sets.len()).expect("fewer than 2^32 distinct sets of regions");
        self.sets.push(set.to_vec());
        self.ids.insert(set.to_vec(), id);
        id
    }
}

/// The sum of owners while the cells are built.
struct Cover<'a> {
    edges: &'a [Edge],
    sets: &'a mut Sets,
    regions: Vec<u32>,
}

impl Labels for Cover<'_> {
    fn clear(&mut self) {
        self.regions.clear();
    }

    fn toggle(&mut self, edge: u32) {
        let owners = self.edges[edge as usize].owners;
        for region in &self.sets.sets[owners as usize] {
            match self.regions.binary_search(region) {
                Ok(at) => {
                    self.regions.remove(at);
                }
                Err(at) => self.regions.insert(at, *region),
            }
        }
    }

    fn number(&mut self) -> u32 {
        self.sets.intern(&self.regions)
    }
}
