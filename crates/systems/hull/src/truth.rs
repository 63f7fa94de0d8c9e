//! The vertices of small hulls by definition. Larger hulls are judged by the [checks](crate::checks) alone.

use crate::checks::{Flaw, Signs};
use predicament_judge::{Judged, hull as definition};
use predicament_predicates::{Scene, Vertex};

/// The maximum number of points for which the perturbed hull is computed by definition: each sign may be a tie.
const FEW: usize = 9;
/// The number of pairs of a point and a face that are judged, at level quick and at level full.
pub(crate) const PAIRS: [usize; 2] = [20_000, 1 << 18];

/// The truth about a hull.
pub struct Truth {
    /// The hull's vertices by definition, if there are few points.
    extreme: Option<Vec<Vertex>>,
    points: usize,
}

impl Truth {
    /// The truth of a scene: by definition, if there are few points.
    #[must_use]
    pub fn new(scene: &Scene) -> Truth {
        let is_small = scene.len() <= definition::most(scene.dimension());
        let extreme = is_small.then(|| definition::extreme(&Judged::exact(scene)));
        Truth { extreme, points: scene.len() }
    }

    /// The source of the truth, in a few words.
    #[must_use]
    pub fn described(&self) -> String {
        match &self.extreme {
            Some(extreme) => format!("{} of them extreme", extreme.len()),
            None => "too many points to find the extreme ones by definition".to_owned(),
        }
    }

    /// The judged part of the hull, if it is not the whole.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        let [most, _] = PAIRS;
        (self.extreme.is_none() && 2 * self.points > most)
            .then(|| "convex at every edge and wound once; points inside: an even sample".to_owned())
    }

    /// Checks `extreme vertices`: the vertices by definition. With broken ties there may be more: with very few points,
    /// exactly the vertices by the perturbed signs, otherwise at least one in each place of the definition's vertices.
    #[must_use]
    pub fn not_extreme(&self, scene: &Scene, signs: Signs<'_>, vertices: &[Vertex]) -> Option<Flaw> {
        const CHECK: &str = "extreme vertices";
        let mut found = vertices.to_vec();
        found.sort_unstable();
        let wanted = match signs.perturbed {
            Some(perturbed) if scene.len() <= FEW => definition::extreme(perturbed),
            Some(_) => {
                let is_there = |v: Vertex| found.iter().any(|&w| scene.has(w) && scene.point(v) == scene.point(w));
                let missing = self.extreme.as_ref()?.iter().copied().find(|&v| !is_there(v))?;
                let what = format!("{missing} is extreme, but the hull has no vertex at its place");
                return Some(Flaw { check: CHECK, places: 1, vertices: vec![missing], what });
            }
            None => self.extreme.clone()?,
        };
        let differ = |from: &[Vertex], others: &[Vertex]| from.iter().copied().find(|v| !others.contains(v));
        let (vertex, what) = match (differ(&wanted, &found), differ(&found, &wanted)) {
            (Some(missing), _) => (missing, format!("{missing} is extreme by definition, but not a vertex")),
            (_, Some(other)) => (other, format!("{other} is a vertex, but not extreme by definition")),
            _ => return None,
        };
        Some(Flaw { check: CHECK, places: 1, vertices: vec![vertex], what })
    }
}
