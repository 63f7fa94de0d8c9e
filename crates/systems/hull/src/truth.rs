//! The vertices of small hulls by definition. About the others the [checks](crate::checks) hold the truth.

use crate::checks::{Flaw, Signs};
use predicament_judge::{Judged, hull as definition};
use predicament_predicates::{Scene, Vertex};

/// The most points of a scene whose perturbed hull is found by definition: each sign may be a tie.
const FEW: usize = 9;
/// Pairs of a point and a face that are judged, at level quick and at level full.
pub(crate) const PAIRS: [usize; 2] = [20_000, 1 << 18];

/// What is true about a hull.
pub struct Truth {
    /// Its vertices, by definition, where there are few points.
    extreme: Option<Vec<Vertex>>,
    points: usize,
}

impl Truth {
    /// By definition, if there are few points.
    #[must_use]
    pub fn new(scene: &Scene) -> Truth {
        let is_small = scene.len() <= definition::most(scene.dimension());
        let extreme = is_small.then(|| definition::extreme(&Judged::exact(scene)));
        Truth { extreme, points: scene.len() }
    }

    /// In a few words.
    #[must_use]
    pub fn described(&self) -> String {
        match &self.extreme {
            Some(extreme) => format!("{} of them extreme", extreme.len()),
            None => "too many to count the extreme ones by definition".to_owned(),
        }
    }

    /// What is judged, where it is not all.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        let [most, _] = PAIRS;
        (self.extreme.is_none() && 2 * self.points > most)
            .then(|| "convex at every edge and wound once; points inside: an even sample".to_owned())
    }

    /// `extreme vertices`: those of the definition. Where ties are broken there may be more: all of them by the perturbed
    /// signs where there are very few points, else one at least in each place of the definition's.
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
                let what = format!("no vertex in the place of {missing}, which is extreme");
                return Some(Flaw { check: CHECK, places: 1, vertices: vec![missing], what });
            }
            None => self.extreme.clone()?,
        };
        let differ = |from: &[Vertex], others: &[Vertex]| from.iter().copied().find(|v| !others.contains(v));
        let (vertex, what) = match (differ(&wanted, &found), differ(&found, &wanted)) {
            (Some(missing), _) => (missing, format!("{missing} is extreme by definition and no vertex")),
            (_, Some(other)) => (other, format!("{other} is a vertex and not extreme by definition")),
            _ => return None,
        };
        Some(Flaw { check: CHECK, places: 1, vertices: vec![vertex], what })
    }
}
