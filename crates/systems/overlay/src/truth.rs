//! The truth about drawings that are rounded to pixels: the crossings of their segments, in rationals.
//!
//! Overlays have no truth except their laws, which are in the [checks](crate::checks::overlay).

use predicament_predicates::{Scene, Vertex};
use predicament_tasks::{Stop, Watch};

/// The maximum number of segments that are checked by their definition; of more, an even sample is checked.
pub(crate) const SEGMENTS: usize = 300;

/// The pairs of segments that cross, exactly.
pub struct Truth {
    /// Pairs of indices, ascending.
    pub crossings: Vec<[u32; 2]>,
    segments: usize,
}

impl Truth {
    /// Finds all pairs that cross.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    ///
    /// # Panics
    /// If there are 2^32 segments.
    pub fn new(scene: &Scene, segments: &[[Vertex; 2]], watch: &Watch) -> Result<Truth, Stop> {
        let number = |at: usize| u32::try_from(at).expect("fewer than 2^32 segments");
        let along = predicament_crossings::truth::crossings(scene, segments, watch)?;
        let of = |(at, along): (usize, &Vec<Vec<u32>>)| -> Vec<[u32; 2]> {
            along.iter().flatten().filter(|&&other| number(at) < other).map(|&other| [number(at), other]).collect()
        };
        let mut crossings: Vec<[u32; 2]> = along.iter().enumerate().flat_map(of).collect();
        crossings.sort_unstable();
        Ok(Truth { crossings, segments: segments.len() })
    }

    /// The parts of the check that are sampled, as text.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        (self.segments > SEGMENTS)
            .then(|| format!("about {SEGMENTS} segments, with all hot pixels; all crossings of chains"))
    }
}
