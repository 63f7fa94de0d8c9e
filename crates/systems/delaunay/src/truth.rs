//! The extent of the checks on a scene.
//!
//! The [checks](crate::checks) themselves are the truth about a Delaunay triangulation: they test the points and the
//! triangles by the judge's signs.

use predicament_predicates::Scene;

/// The number of triangles and of edges that are checked by exact signs, at level quick and at level full.
pub(crate) const PAIRS: [usize; 2] = [20_000, 1 << 18];

/// The part of a scene that the checks cover.
pub struct Truth {
    points: usize,
}

impl Truth {
    /// The truth of a scene, which covers all of its points.
    #[must_use]
    pub fn new(scene: &Scene) -> Truth {
        Truth { points: scene.len() }
    }

    /// The judged part of the scene, if it is not the whole.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        let [most, _] = PAIRS;
        (3 * self.points > most).then(|| "edges, hull and copies; turns and circles: an even sample".to_owned())
    }
}
