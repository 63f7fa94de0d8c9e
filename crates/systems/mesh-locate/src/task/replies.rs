//! The judge of other programs' point locators in meshes.
//!
//! A program gives one label a probe: the number of a region, 0 for outside, or [`ON_SURFACE`]. On the surface, each
//! region beside a triangle there is right, and so is "on the surface".

use predicament_judge::solids::{Materials, Place};
use predicament_mesh::OUTSIDE;
use predicament_predicates::{Query, Scene};
use predicament_tasks::replies::{Array, Arrays, Example, Form, Part, Replies, Reply, SpoiledReply, Unjudged};
use predicament_tasks::{AnswerLine, Asked, Case, Check, Class, Finding, Outcome};

use super::content::ProbedMesh;
use super::{Located, MeshLocate};
use crate::algorithm::Location;

/// The judge.
pub(super) struct Judge;

/// The name of the answer's array.
const LABELS: &str = "labels";
/// The label of a probe on the surface, from programs that say so.
const ON_SURFACE: u32 = u32::MAX - 1;
/// The name of the check.
const LABEL: &str = "label";

/// The label of a location: the region, or [`ON_SURFACE`]; `None` for a location without a place.
pub(super) fn label(location: &Location) -> Option<u32> {
    match location {
        Location::In(region) => Some(*region),
        Location::On(_) => Some(ON_SURFACE),
        Location::Undecided | Location::Contradiction => None,
    }
}

/// The maximum number of probes that the judge locates although they are not in the sample of the truth.
const MOST_ASKED_LATER: usize = 2_000;

impl Replies<MeshLocate> for Judge {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(LABELS, Form::Labels, "the region of each probe, 0 for outside, −2 for the surface")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "mesh-points",
            functions: &[
                ("python", include_str!("../engines/mesh_locate.py")),
                ("cpp", include_str!("../engines/mesh_locate.cpp")),
                ("rust", include_str!("../engines/mesh_locate.rs")),
                ("node", include_str!("../engines/mesh_locate.mjs")),
            ],
        }
    }

    fn judge(
        &self,
        case: &Case<'_, MeshLocate>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let content = case.content;
        let probes = content.vertices();
        let labels = reply.arrays.labels(LABELS, probes.len())?;
        let judge = Materials::new(case.scene(), content.mesh.triangles(), content.mesh.sides());
        let (mut later, mut left) = (0, 0);
        let word = |label: u32| match label {
            OUTSIDE => "outside".to_owned(),
            ON_SURFACE => "on the surface".to_owned(),
            region => format!("region {region}"),
        };
        for (at, (&label, &probe)) in labels.iter().zip(&probes).enumerate() {
            let located;
            let truth = match case.truth.of(at) {
                Some((place, _)) => place,
                None if later < MOST_ASKED_LATER => {
                    later += 1;
                    asked.watch.done(0)?;
                    located = judge.locate(probe);
                    &located
                }
                None => {
                    left += 1;
                    continue;
                }
            };
            let is_right = match truth {
                // The mesh contradicts itself there: every label is as good as another.
                Place::Windings(_) => true,
                Place::In(region) => label == *region,
                Place::On(triangles) => {
                    let sides = |&triangle: &u32| content.mesh.sides()[triangle as usize];
                    label == ON_SURFACE || triangles.iter().any(|triangle| sides(triangle).contains(&label))
                }
            };
            let class = if is_right { Class::Agree } else { Class::Topology };
            let exact = || match truth {
                Place::In(region) => word(*region),
                Place::On(triangles) => format!("on the surface, at triangle {}", triangles[0]),
                Place::Windings(_) => "where the mesh contradicts itself".to_owned(),
            };
            if asked.budget.answers {
                let (answer, exact) = (word(label), exact());
                outcome.answers.push(AnswerLine { query: at, args: vec![probe], answer, exact, class, stage: "" });
            }
            outcome.note(class, asked.budget.findings_per_class, || {
                let query = Query::of_task("mesh-locate", &[probe]);
                Finding::plain(class, LABEL, vec![query], word(label), exact())
            });
        }
        outcome.sampled = (left > 0).then(|| format!("{} of {} labels", probes.len() - left, probes.len()));
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &ProbedMesh, answer: &Located) -> Arrays {
        let labels = answer.0.iter().map(|location| label(location).unwrap_or(ON_SURFACE));
        let mut arrays = Arrays::default();
        arrays.add(LABELS, Array::Ids(labels.collect()));
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const { &[Check::topology(LABEL, "a program's label: the region of the probe, or one beside it")] }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<MeshLocate>> {
        vec![SpoiledReply {
            name: "mesh-locate-reply-turns-inside-out",
            what: "labels 0 and 1 are exchanged",
            backend: "exact",
            caught_by: &[(Class::Topology, LABEL)],
            spoil: |_, _, arrays| {
                if let Some(Array::Ids(labels)) = arrays.get_mut(LABELS) {
                    for label in labels.iter_mut().filter(|label| **label < 2) {
                        *label = 1 - *label;
                    }
                }
            },
        }]
    }
}
