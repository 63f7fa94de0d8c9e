//! Polygonal maps: regions bounded by rings that share vertices.
//!
//! Two regions with a common border use the *same* vertices along it. A symbolic perturbation moves vertices by
//! identity, so the whole border moves together and the map stays a tiling. Vertices with equal coordinates but
//! different ids would drift apart and open slivers.
//!
//! # The inside of a region
//! The even-odd rule: a point is inside a region iff a ray from it crosses the region's edges an odd number of times.
//! An edge is identified by its two vertices, in either direction; an edge that one region uses twice bounds nothing.
//! This also defines the inside for unusual input:
//! * a ring that visits a vertex twice, or crosses itself or another ring: each part is inside or outside by its
//!   crossing number;
//! * a spike that runs forth and back over the same vertices: it has no effect;
//! * a ring without area, its vertices on one line: nothing is inside, and its edges are boundaries. A perturbation
//!   makes a sliver of it that may hold points of the line;
//! * two vertices at one place: an edge without length, or two borders that look like one. The perturbation decides,
//!   consistently, on which side points between them are.
//!
//! Rings without usable edges are refused: a ring of fewer than three vertices, and an edge from a vertex to itself.

use predicament_predicates::Vertex;

/// A closed chain of vertices; the edge from the last to the first is implied.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Ring {
    vertices: Vec<Vertex>,
}

impl Ring {
    /// The vertices in order; the first is not repeated at the end.
    #[must_use]
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// The directed edges, the closing edge last.
    pub fn edges(&self) -> impl Iterator<Item = [Vertex; 2]> + '_ {
        let next = self.vertices.iter().cycle().skip(1);
        self.vertices.iter().zip(next).map(|(&a, &b)| [a, b])
    }
}

/// A region of a map: all points with an odd crossing number with its rings (outer boundaries, islands and holes
/// alike).
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Region {
    /// The region's name.
    pub name: String,
    /// The rings of the region's boundary.
    pub rings: Vec<Ring>,
}

/// The reason why vertices don't make a map.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum MapError {
    /// A ring has fewer than three vertices.
    ShortRing {
        /// The region's index in the map.
        region: usize,
        /// The region's name.
        name: String,
        /// The ring's index in the region.
        ring: usize,
        /// The number of vertices in the ring.
        vertices: usize,
    },
    /// An edge goes from a vertex to itself.
    LoopEdge {
        /// The region's index in the map.
        region: usize,
        /// The region's name.
        name: String,
        /// The ring's index in the region.
        ring: usize,
        /// The index in the ring where the edge starts.
        at: usize,
    },
}

impl std::fmt::Display for MapError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            MapError::ShortRing { region, name, ring, vertices } => write!(
                f,
                "region {region} (`{name}`), ring {ring}: {vertices} vertices don't bound an area; \
                 drop the ring, or give it three"
            ),
            MapError::LoopEdge { region, name, ring, at } => {
                write!(
                    f,
                    "region {region} (`{name}`), ring {ring}: vertex {at} is repeated at once; drop one of the two"
                )
            }
        }
    }
}

impl std::error::Error for MapError {}

/// Regions over the vertices of one scene.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct PolygonMap {
    regions: Vec<Region>,
}

impl PolygonMap {
    /// An empty map.
    #[must_use]
    pub fn new() -> PolygonMap {
        PolygonMap::default()
    }

    /// Adds a region; a last vertex that repeats the first is dropped.
    ///
    /// # Errors
    /// [`MapError`] for the first invalid ring.
    pub fn push(&mut self, name: impl Into<String>, rings: Vec<Vec<Vertex>>) -> Result<(), MapError> {
        let (region, name) = (self.regions.len(), name.into());
        let mut checked = Vec::with_capacity(rings.len());
        for (ring, mut vertices) in rings.into_iter().enumerate() {
            if vertices.len() > 1 && vertices.first() == vertices.last() {
                vertices.pop();
            }
            if vertices.len() < 3 {
                return Err(MapError::ShortRing { region, name, ring, vertices: vertices.len() });
            }
            let ring_of = Ring { vertices };
            if let Some(at) = ring_of.edges().position(|[a, b]| a == b) {
                return Err(MapError::LoopEdge { region, name, ring, at });
            }
            checked.push(ring_of);
        }
        self.regions.push(Region { name, rings: checked });
        Ok(())
    }

    /// The map with all vertex numbers increased by `by`.
    ///
    /// # Panics
    /// As [`Vertex::input`], if a number becomes too large.
    #[must_use]
    pub fn shifted(mut self, by: usize) -> PolygonMap {
        for vertex in self.regions.iter_mut().flat_map(|region| &mut region.rings).flat_map(|ring| &mut ring.vertices) {
            *vertex = Vertex::input(vertex.index() + by);
        }
        self
    }

    /// The regions, in the order in which they were added.
    #[must_use]
    pub fn regions(&self) -> &[Region] {
        &self.regions
    }

    /// All directed edges with the index of their region; shared borders occur once for each side.
    pub fn edges(&self) -> impl Iterator<Item = (usize, [Vertex; 2])> + '_ {
        self.regions
            .iter()
            .enumerate()
            .flat_map(|(at, region)| region.rings.iter().flat_map(Ring::edges).map(move |edge| (at, edge)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ids(indices: &[usize]) -> Vec<Vertex> {
        indices.iter().map(|&i| Vertex::input(i)).collect()
    }

    #[test]
    fn rings_close_by_themselves() {
        let mut map = PolygonMap::new();
        map.push("closed", vec![ids(&[0, 1, 2, 0])]).unwrap();
        map.push("open", vec![ids(&[0, 1, 2])]).unwrap();
        assert_eq!(map.regions()[0].rings, map.regions()[1].rings);
        assert_eq!(map.edges().count(), 6);
        assert_eq!(map.edges().last(), Some((1, [Vertex::input(2), Vertex::input(0)])));
    }

    #[test]
    fn a_shifted_map_has_the_same_shape() {
        let of = |offset: usize| {
            let at = |indices: &[usize]| ids(&indices.iter().map(|i| i + offset).collect::<Vec<_>>());
            let mut map = PolygonMap::new();
            map.push("ring", vec![at(&[0, 1, 2, 3]), at(&[4, 6, 5])]).unwrap();
            map.push("lake", vec![at(&[4, 5, 6])]).unwrap();
            map
        };
        assert_eq!(of(0).shifted(7), of(7));
        assert_eq!(of(3).shifted(0), of(3));
    }

    #[test]
    fn what_is_no_ring_is_refused_by_place() {
        let mut map = PolygonMap::new();
        map.push("fine", vec![ids(&[0, 1, 2])]).unwrap();
        let mut refused = |name: &str, rings: &[&[usize]]| {
            map.push(name, rings.iter().map(|ring| ids(ring)).collect()).unwrap_err().to_string()
        };
        let short = |ring: usize, vertices: usize| {
            let what = "vertices don't bound an area; drop the ring, or give it three";
            format!("region 1 (`short`), ring {ring}: {vertices} {what}")
        };
        assert_eq!(refused("short", &[&[0, 1, 2], &[3, 4, 3]]), short(1, 2));
        assert_eq!(refused("short", &[&[3, 4]]), short(0, 2));
        assert_eq!(refused("short", &[&[3]]), short(0, 1));
        assert_eq!(refused("short", &[&[7, 7, 7]]), short(0, 2));
        assert_eq!(refused("short", &[&[]]), short(0, 0));
        let again =
            |at: usize| format!("region 1 (`again`), ring 0: vertex {at} is repeated at once; drop one of the two");
        assert_eq!(refused("again", &[&[0, 1, 1, 2]]), again(1));
        assert_eq!(refused("again", &[&[7, 7, 7, 7]]), again(0));
        assert_eq!(map.regions().len(), 1, "what is refused leaves no trace");
    }

    #[test]
    fn rings_may_touch_themselves_and_run_forth_and_back() {
        let mut map = PolygonMap::new();
        let odd: [&[usize]; 4] = [&[0, 1, 2, 0, 3, 4], &[0, 1, 2, 3, 2], &[0, 1, 2, 1], &[0, 1, 0, 2]];
        for ring in odd {
            map.push("odd", vec![ids(ring)]).unwrap();
        }
        assert_eq!(map.edges().count(), 6 + 5 + 4 + 4);
    }
}
