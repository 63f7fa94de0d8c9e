//! What is true about the probes of a mesh: which region each is in, by crossing sums over all triangles, and by
//! tetrahedra where the mesh is made of some.

use predicament_judge::solids::{Materials, Place};
use predicament_judge::{Sample, sign};
use predicament_mesh::OUTSIDE;
use predicament_predicates::{Question, Scene, Sign, Vertex};
use predicament_tasks::{Stop, Watch};
use rayon::prelude::*;

use crate::task::content::{Probe, ProbedMesh};

/// The work that the truth of one scene may be: triangles looked at.
const BUDGET: u64 = 60_000_000;
/// What the exact signs for one probe cost, in triangles looked at.
const SIGNS: u64 = 20_000;

/// What is true about the probes of a mesh.
pub struct Truth {
    places: Vec<Place>,
    /// Where the probes are among tetrahedra, by their own faces; none where the mesh is not made of any.
    solids: Vec<Option<Place>>,
    sample: Sample,
}

impl Truth {
    /// Finds where a sample of the probes is, by all triangles.
    ///
    /// # Errors
    /// [`Stop`] where the watch says so.
    pub fn new(scene: &Scene, content: &ProbedMesh, watch: &Watch) -> Result<Truth, Stop> {
        let triangles = content.mesh.triangles();
        let sample = Sample::within(BUDGET, content.probes.len(), triangles.len() as u64 + SIGNS);
        let judge = Materials::new(scene, triangles, content.mesh.sides());
        let probes: Vec<Probe> = sample.places().map(|at| content.probes[at]).collect();
        let locate = |probe: &Probe| -> Result<_, Stop> {
            watch.done(0)?;
            let solid = (!content.tetrahedra.is_empty()).then(|| among(scene, &content.tetrahedra, probe.vertex));
            Ok((judge.locate(probe.vertex), solid))
        };
        let found: Vec<(Place, Option<Place>)> = probes.par_iter().map(locate).collect::<Result<_, _>>()?;
        let (places, solids) = found.into_iter().unzip();
        Ok(Truth { places, solids, sample })
    }

    /// How many probes were located by all triangles, if not all.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        (!self.sample.is_all())
            .then(|| format!("probes by all triangles: {}; the others along all axes or by sums alone", self.sample))
    }

    /// The region that a probe is in, if it is of the sample and in one.
    #[must_use]
    pub fn of(&self, at: usize) -> Option<(&Place, Option<&Place>)> {
        let place = at / self.sample.step();
        self.sample.has(at).then(|| (&self.places[place], self.solids[place].as_ref()))
    }

    /// How many probes of the sample are in a region, and how many on the mesh.
    #[must_use]
    pub fn counts(&self) -> [usize; 3] {
        let count = |which: fn(&Place) -> bool| self.places.iter().filter(|place| which(place)).count();
        [
            count(|place| matches!(place, Place::In(_))),
            count(|place| matches!(place, Place::On(_))),
            count(|place| matches!(place, Place::Windings(_))),
        ]
    }
}

/// Where a point is among tetrahedra, each a region: strictly in one, on the border of some, or in none. Borders have no triangles here.
fn among(scene: &Scene, tetrahedra: &[[Vertex; 4]], q: Vertex) -> Place {
    let p = scene.point3(q);
    let mut within = Vec::new();
    for (region, corners) in (1_u32..).zip(tetrahedra) {
        let points = corners.map(|v| scene.point3(v));
        let is_beside =
            |axis: usize| points.iter().all(|c| c[axis] < p[axis]) || points.iter().all(|c| c[axis] > p[axis]);
        if (0..3).any(is_beside) {
            continue;
        }
        // With the point in the place of each corner.
        let signs = [0, 1, 2, 3].map(|at: usize| {
            let mut args = *corners;
            args[at] = q;
            sign(scene, Question::Orient3d, &args)
        });
        if signs.contains(&Sign::Negative) {
            continue;
        }
        if signs.contains(&Sign::Zero) {
            return Place::On(Vec::new());
        }
        within.push((region, 1));
    }
    match within[..] {
        [] => Place::In(OUTSIDE),
        [(region, _)] => Place::In(region),
        _ => Place::Windings(within),
    }
}
