//! What is true about a Delaunay triangulation is said by its [checks](crate::checks), which look at the points and the
//! triangles by the judge's signs. Here is how much of a scene they look at.

use predicament_predicates::Scene;

/// How many triangles and how many edges are held against exact signs, at level quick and at level full.
pub(crate) const PAIRS: [usize; 2] = [20_000, 1 << 18];

/// How much of a scene the checks are about.
pub struct Truth {
    points: usize,
}

impl Truth {
    /// Of a scene: all of its points.
    #[must_use]
    pub fn new(scene: &Scene) -> Truth {
        Truth { points: scene.len() }
    }

    /// What is judged, where it is not all.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        let [most, _] = PAIRS;
        (3 * self.points > most).then(|| "edges, hull and copies; turns and circles: an even sample".to_owned())
    }
}
