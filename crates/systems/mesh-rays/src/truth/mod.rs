//! The truth about lines and a mesh: every query against every triangle, by linear algebra in integers.
//!
//! Coordinates become integers over one denominator. The place of a hit on its query is a rational: 0 at the first
//! point, 1 at the second. The computation uses no predicate, no constructed vertex and no broad phase. The winding
//! numbers of closed meshes come from another computation, `predicament_judge::solids`.

mod perturbed;
mod solved;

use predicament_judge::Sample;
use predicament_judge::solids::{Materials, Place};
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::{Stop, Watch};
use rayon::prelude::*;

use crate::answer::{Extent, Groups};
use crate::task::content::RayScene;
use solved::Solved;

pub use perturbed::{Perturbed, Ties, is_in_order};
pub use solved::Meeting;

/// The work limit for the truth of one scene, in pairs of a query and a triangle.
const BUDGET: u64 = 400_000;

/// The truth about one query.
#[derive(Clone, Default, Debug)]
pub struct Known {
    /// The hits in order.
    pub groups: Groups,
    /// The triangles that the query meets, borders included, with the part of the query from where to where.
    pub met: Vec<Meeting>,
    /// The triangles that the whole line meets, borders included.
    pub on_line: Vec<u32>,
    /// The times that the query leaves the mesh, minus the times that it enters it; `None` if an end is on the mesh, or
    /// the mesh is not closed.
    pub crossings: Option<i64>,
}

/// The truth about a sample of the queries.
pub struct Truth {
    known: Vec<Known>,
    sample: Sample,
}

impl Truth {
    /// Solves a sample of the queries.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
    pub fn new(scene: &Scene, content: &RayScene, watch: &Watch) -> Result<Truth, Stop> {
        let sample = Sample::within(BUDGET, content.rays.len(), content.triangles.len() as u64 + 1);
        let solved = Solved::new(scene, &content.triangles);
        let sides = vec![[0, 1]; content.triangles.len()];
        let judge = Materials::new(scene, &content.triangles, &sides);
        let places: Vec<usize> = sample.places().collect();
        let one = |&at: &usize| -> Result<Known, Stop> {
            watch.done(1)?;
            let ends = content.rays[at];
            let mut known = solved.query(ends, content.extent);
            known.crossings = content.is_closed().then(|| crossings(&judge, ends, content.extent)).flatten();
            Ok(known)
        };
        let known = places.par_iter().map(one).collect::<Result<_, _>>()?;
        Ok(Truth { known, sample })
    }

    /// The number of queries that are solved, as text, if not all are.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        (!self.sample.is_all()).then(|| format!("queries tested against all triangles: {}", self.sample))
    }

    /// The truth about a query, if it is in the sample.
    #[must_use]
    pub fn of(&self, at: usize) -> Option<&Known> {
        self.sample.has(at).then(|| &self.known[at / self.sample.step()])
    }

    /// The solved queries.
    #[must_use]
    pub fn known(&self) -> &[Known] {
        &self.known
    }
}

/// The difference of the winding numbers of the mesh around the ends of a query.
fn crossings(judge: &Materials<'_>, [p, q]: [Vertex; 2], extent: Extent) -> Option<i64> {
    let winding = |v: Vertex| match judge.locate(v) {
        Place::On(_) => None,
        Place::In(region) => Some(i64::from(region)),
        Place::Windings(all) => Some(all.iter().find(|(region, _)| *region == 1).map_or(0, |(_, winding)| *winding)),
    };
    match extent {
        Extent::Line => Some(0),
        Extent::Ray => winding(p),
        Extent::Segment => Some(winding(p)? - winding(q)?),
    }
}
