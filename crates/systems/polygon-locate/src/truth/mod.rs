//! What is true about a map and its probes: where the map is no tiling, what is around each probe, and where it is.
//!
//! The probes of a sample are located edge by edge, by the judge. All are by the sectors around them, whose edges are found
//! by their boxes. Nothing is shared with the algorithm: no index, no cells, no rule about rays.

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

/// What is true about a map and its probes.
pub struct Truth {
    /// The map's own flaws.
    pub flaws: Flaws,
    /// What is around each probe.
    pub surroundings: Surroundings,
    /// Where the probes of a sample are: by all edges of the map, without an index.
    exact: Vec<judge::Location>,
    sample: Sample,
}

impl Truth {
    /// Finds the map's flaws and the truth about the probes.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
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

    /// How many probes were located without an index, if not all.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        (!self.sample.is_all())
            .then(|| format!("probes by all edges: {}; the others by their surroundings", self.sample))
    }

    /// Where a probe is: of the sample by all edges, else as its sectors say.
    #[must_use]
    pub fn location(&self, at: usize) -> judge::Location {
        if self.sample.has(at) {
            return self.exact[at / self.sample.step()].clone();
        }
        let boundary = self.surroundings.boundary(at);
        // A region whose boundary the probe is not on covers all sectors, or none.
        let sector = self.surroundings.sectors(at).next().unwrap_or_default();
        let inside = sector.iter().copied().filter(|region| boundary.binary_search(region).is_err()).collect();
        judge::Location { inside, boundary: boundary.to_vec() }
    }

    /// How many probes stand on each kind of ground.
    #[must_use]
    pub fn grounds(&self, probes: usize) -> Vec<(&'static str, usize)> {
        let count = |ground| (0..probes).filter(|&at| self.surroundings.ground(at) == ground).count();
        Ground::ALL.into_iter().map(|ground| (ground.name(), count(ground))).filter(|&(_, n)| n > 0).collect()
    }
}
