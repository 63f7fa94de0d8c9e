//! The truth about the probes of a mesh: their regions, by crossing sums over all triangles, and by tetrahedra if the
//! mesh is made of them.

use predicament_judge::solids::{Materials, Place};
use predicament_judge::{Sample, sign};
use predicament_mesh::OUTSIDE;
use predicament_predicates::{Question, Scene, Sign, Vertex};
use predicament_tasks::{Stop, Watch};
use rayon::prelude::*;

use crate::task::content::{Probe, ProbedMesh};

/// The work limit for the truth of one scene, in triangles tested.
const BUDGET: u64 = 60_000_000;
/// The cost of the exact signs for one probe, in triangles tested.
const SIGNS: u64 = 20_000;

/// The truth about the probes of a mesh.
pub struct Truth {
    places: Vec<Place>,
    /// The locations of the probes among tetrahedra, by the tetrahedra's faces; `None` if the mesh is not made of
    /// tetrahedra.
    solids: Vec<Option<Place>>,
    sample: Sample,
}

impl Truth {
    /// Locates a sample of the probes, by all triangles.
    ///
    /// # Errors
    /// [`Stop`] if the watch stops the computation.
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

    /// The number of probes located by all triangles, as text, if not all are.
    #[must_use]
    pub fn sampled(&self) -> Option<String> {
        (!self.sample.is_all()).then(|| {
            format!("probes tested against all triangles: {}; other probes only along all axes or by sums", self.sample)
        })
    }

    /// The true location of a probe, if it is in the sample; the second value is its location among tetrahedra.
    #[must_use]
    pub fn of(&self, at: usize) -> Option<(&Place, Option<&Place>)> {
        let place = at / self.sample.step();
        self.sample.has(at).then(|| (&self.places[place], self.solids[place].as_ref()))
    }

    /// The numbers of sampled probes in a region, on the mesh, and in neither.
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

/// The location of a point among tetrahedra, each a region: strictly inside one, on the border of some, or in none.
/// Borders have no triangles here.
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
        // The signs with the point in place of each corner.
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
