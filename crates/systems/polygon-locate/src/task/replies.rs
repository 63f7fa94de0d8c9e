//! The judge of other programs' point locators.
//!
//! A program gives one label a probe: the number of a region, [`OUTSIDE`] or [`ON_BORDER`]. On a border, each region
//! there is right, and so is "on the border". "Outside" is right on a border with the outside, not between two regions.

use predicament_predicates::{Query, Scene};
use predicament_tasks::replies::{Array, Arrays, Example, FORM, Form, Part, Replies, Reply, SpoiledReply, Unjudged};
use predicament_tasks::{AnswerLine, Asked, Case, Check, Class, Finding, Outcome};

use super::{Located, MapWithProbes, PolygonLocate};
use crate::answer::Location;

/// The judge.
pub(super) struct Judge;

/// The name of the answer's array.
const LABELS: &str = "labels";
/// The label of a probe in no region.
const OUTSIDE: u32 = u32::MAX;
/// The label of a probe on a border, from programs that say so.
const ON_BORDER: u32 = u32::MAX - 1;
/// The name of the check.
const LABEL: &str = "label";

/// The label of a location: the first region that the probe is in, [`OUTSIDE`] or [`ON_BORDER`].
pub(super) fn label(location: Location<'_>) -> u32 {
    match (location.inside, location.boundary) {
        ([region, ..], _) => *region,
        ([], []) => OUTSIDE,
        ([], _) => ON_BORDER,
    }
}

impl Replies<PolygonLocate> for Judge {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(LABELS, Form::Labels, "the region of each probe, −1 for outside, −2 for a border")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "tilings",
            functions: &[
                ("python", include_str!("../engines/polygon_locate.py")),
                ("cpp", include_str!("../engines/polygon_locate.cpp")),
                ("rust", include_str!("../engines/polygon_locate.rs")),
                ("node", include_str!("../engines/polygon_locate.mjs")),
            ],
        }
    }

    fn judge(
        &self,
        case: &Case<'_, PolygonLocate>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let probes = case.content.vertices();
        let labels = reply.arrays.labels(LABELS, probes.len())?;
        let word = |label: u32| match label {
            OUTSIDE => "outside".to_owned(),
            ON_BORDER => "on a border".to_owned(),
            region => match case.content.map.regions().get(region as usize) {
                Some(region) => region.name.clone(),
                None => format!("region {region}, which does not exist"),
            },
        };
        for (at, (&label, &probe)) in labels.iter().zip(&probes).enumerate() {
            let truth = case.truth.location(at);
            let is_right = match label {
                OUTSIDE => truth.inside.is_empty() && case.truth.is_beside_outside(at),
                ON_BORDER => !truth.boundary.is_empty(),
                region => truth.inside.contains(&region) || truth.boundary.contains(&region),
            };
            let class = if is_right { Class::Agree } else { Class::Topology };
            let exact = || {
                let [inside, border] = [&truth.inside, &truth.boundary].map(|regions| {
                    let names: Vec<String> = regions.iter().map(|&region| word(region)).collect();
                    names.join(", ")
                });
                match (inside.is_empty(), border.is_empty()) {
                    (true, true) => "outside".to_owned(),
                    (false, true) => format!("in {inside}"),
                    (true, false) => format!("on the border of {border}"),
                    (false, false) => format!("in {inside}, on the border of {border}"),
                }
            };
            if asked.budget.answers {
                let (answer, exact) = (word(label), exact());
                outcome.answers.push(AnswerLine { query: at, args: vec![probe], answer, exact, class, stage: "" });
            }
            outcome.note(class, asked.budget.findings_per_class, || {
                let query = Query::of_task("polygon-locate", &[probe]);
                Finding::plain(class, LABEL, vec![query], word(label), exact())
            });
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &MapWithProbes, answer: &Located) -> Arrays {
        let mut arrays = Arrays::default();
        arrays.add(LABELS, Array::Ids(answer.0.iter().map(label).collect()));
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const { &[Check::topology(LABEL, "a program's label: a region that the probe is in, or on the border of")] }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<PolygonLocate>> {
        vec![
            SpoiledReply {
                name: "polygon-locate-reply-loses-points",
                what: "every label is “outside”",
                backend: "exact",
                caught_by: &[(Class::Topology, LABEL)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(labels)) = arrays.get_mut(LABELS) {
                        labels.fill(OUTSIDE);
                    }
                },
            },
            SpoiledReply {
                name: "polygon-locate-reply-loses-borders",
                what: "every label of a probe on a border is “outside”",
                backend: "exact",
                caught_by: &[(Class::Topology, LABEL)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(labels)) = arrays.get_mut(LABELS) {
                        labels.iter_mut().filter(|label| **label == ON_BORDER).for_each(|label| *label = OUTSIDE);
                    }
                },
            },
            SpoiledReply {
                name: "polygon-locate-reply-is-half-an-answer",
                what: "the second half of the labels is missing",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(labels)) = arrays.get_mut(LABELS) {
                        labels.truncate(labels.len() / 2);
                    }
                },
            },
        ]
    }
}
