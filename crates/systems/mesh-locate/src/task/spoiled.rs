//! Right answers with planted faults: they test the checks that no backend's fault reaches.

use crate::algorithm::Location;
use predicament_judge::solids::{Materials, Place};
use predicament_mesh::OUTSIDE;
use predicament_predicates::Scene;

use super::{Located, MeshLocate, ProbedMesh};
use predicament_tasks::{Class, Spoiled};

/// The maximum number of points that the judge locates.
const MOST_ASKED: usize = 200;

pub(super) fn all() -> Vec<Spoiled<MeshLocate>> {
    vec![
        Spoiled::new(
            "mesh-locate-contradicts-itself",
            "each point is reported in no one region",
            "exact",
            &[(Class::Topology, "one region")],
            |_, _, answer: &mut Located| answer.0.iter_mut().for_each(|place| *place = Location::Contradiction),
        ),
        Spoiled::new(
            "mesh-locate-touches",
            "each point is reported on the first triangle",
            "exact",
            &[(Class::Overreach, "exact location")],
            |_, _, answer: &mut Located| answer.0.iter_mut().for_each(|place| *place = Location::On(0)),
        ),
        Spoiled::new(
            "mesh-locate-decides-nothing",
            "each point is undecided, although no zero of the tolerance is involved",
            "tolerance",
            &[(Class::Overreach, "undecided location")],
            |_, _, answer: &mut Located| answer.0.iter_mut().for_each(|place| *place = Location::Undecided),
        ),
        Spoiled::new(
            "mesh-locate-leaves-ties",
            "each point is reported on the first triangle, although ties are broken",
            "sos",
            &[(Class::Inconsistent, "unbroken tie")],
            |_, _, answer: &mut Located| answer.0.iter_mut().for_each(|place| *place = Location::On(0)),
        ),
        Spoiled::new(
            "mesh-locate-far-region",
            "each point is reported in a region that does not exist",
            "sos",
            &[(Class::Topology, "region not around")],
            |_, content: &ProbedMesh, answer: &mut Located| {
                let none = content.mesh.regions();
                answer.0.iter_mut().for_each(|place| *place = Location::In(none));
            },
        ),
        Spoiled::new(
            "mesh-locate-takes-the-other-side",
            "a point on the mesh is reported in another region around it",
            "sos",
            &[(Class::Topology, "direction"), (Class::Topology, "shortcut")],
            |scene: &Scene, content: &ProbedMesh, answer: &mut Located| {
                let judge = Materials::new(scene, content.mesh.triangles(), content.mesh.sides());
                let step = answer.0.len().div_ceil(MOST_ASKED).max(1);
                for (place, v) in answer.0.iter_mut().zip(content.vertices()).step_by(step) {
                    let (Location::In(region), Place::On(triangles)) = (*place, judge.locate(v)) else { continue };
                    let sides = triangles.iter().flat_map(|&triangle| content.mesh.sides()[triangle as usize]);
                    if let Some(other) = sides.into_iter().find(|&other| other != region) {
                        *place = Location::In(other);
                    }
                }
            },
        ),
        Spoiled::new(
            "mesh-locate-next-region",
            "each point in a region is reported in the next region",
            "exact",
            &[(Class::SignFlip, "exact location")],
            |_, content: &ProbedMesh, answer: &mut Located| {
                let count = content.mesh.regions();
                for place in &mut answer.0 {
                    if let Location::In(region) = place {
                        *region = (*region + 1) % count;
                    }
                }
            },
        ),
        Spoiled::new(
            "mesh-locate-misses-the-surface",
            "each point on the mesh is reported outside",
            "exact",
            &[(Class::MissedZero, "missed surface")],
            |_, _, answer: &mut Located| {
                for place in answer.0.iter_mut().filter(|place| matches!(place, Location::On(_))) {
                    *place = Location::In(OUTSIDE);
                }
            },
        ),
    ]
}
