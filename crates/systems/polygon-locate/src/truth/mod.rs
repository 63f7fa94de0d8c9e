//! The truth about a map and its probes: the map's flaws, the surroundings of each probe, and its location.
//!
//! The judge locates a sample of the probes edge by edge. The sectors around a probe locate all probes; boxes find the
//! edges of sectors. Nothing is shared with the algorithm: no index, no cells, no rule about rays.

mod edge;
mod edges;
mod flaws;
mod surroundings;

pub use edges::Edges;
pub use flaws::{Edge, Flaws, map_flaws};
pub use surroundings::{Ground, Surroundings, surroundings};

use predicament_judge::{Judged, Sample, locate as judge};
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::{Stop, Watch};
use rayon::prelude::*;

use crate::task::content::MapWithProbes;

/// The truth about a map and its probes.
pub struct Truth {
    /// The map's own flaws.
    pub flaws: Flaws,
    /// The surroundings of each probe.
    pub surroundings: Surroundings,
    /// The locations of a sample of the probes, by all edges of the map, without an index.
    exact: Vec<judge::Location>,
    sample: Sample,
}

impl Truth {
    /// Finds the map's flaws and the truth about the probes.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    pub fn new(scene: &Scene, content: &MapWithProbes, watch: &Watch) -> Result<Truth, Stop> {
        let (edges, probes) = (Edges::new(&content.map, scene), content.vertices());
        let session = Judged::exact(scene);
        let flaws = map_flaws(&edges, &session);
        watch.done(0)?;
        let surroundings = surroundings(&edges, &session, &probes);
        watch.done(0)?;
        let regions = content.map.regions().iter();
        let rings = regions.map(|region| region.rings.iter().map(|ring| ring.vertices().to_vec()).collect());
        let borders = judge::Borders::new(scene, &rings.collect::<Vec<Vec<Vec<Vertex>>>>());
        let sample = judge::sample(probes.len(), borders.len());
        let places: Vec<usize> = sample.places().collect();
        let exact = places.par_iter().map(|&place| borders.locate(probes[place])).collect();
        watch.done(probes.len() as u64)?;
        Ok(Truth { flaws, surroundings, exact, sample })
    }

    /// The number of probes located without an index, as text, if not all are.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        (!self.sample.is_all())
            .then(|| format!("probes tested against all edges: {}; other probes by their surroundings", self.sample))
    }

    /// The location of a probe: by all edges if it is in the sample, otherwise by its sectors.
    #[must_use]
    pub fn location(&self, at: usize) -> judge::Location {
        if self.sample.has(at) {
            return self.exact[at / self.sample.step()].clone();
        }
        let boundary = self.surroundings.boundary(at);
        // A region covers all sectors or none, unless the probe is on its boundary.
        let sector = self.surroundings.sectors(at).next().unwrap_or_default();
        let inside = sector.iter().copied().filter(|region| boundary.binary_search(region).is_err()).collect();
        judge::Location { inside, boundary: boundary.to_vec() }
    }

    /// True if a sector around a probe is in no region: the probe is outside, or on a border of the outside.
    #[must_use]
    pub fn is_beside_outside(&self, at: usize) -> bool {
        self.surroundings.sectors(at).any(<[u32]>::is_empty)
    }

    /// The number of probes on each kind of ground.
    #[must_use]
    pub fn grounds(&self, probes: usize) -> Vec<(&'static str, usize)> {
        let count = |ground| (0..probes).filter(|&at| self.surroundings.ground(at) == ground).count();
        Ground::ALL.into_iter().map(|ground| (ground.name(), count(ground))).filter(|&(_, n)| n > 0).collect()
    }
}
