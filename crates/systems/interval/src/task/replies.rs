//! The judge of other programs' cells of a line.
//!
//! A program gives one label a probe: the number of a cell, [`OUTSIDE`] or [`AT_END`]. At an end, each cell there is
//! right, and so is "at an end"; at an end of the whole row, so is "outside".

use predicament_predicates::{Query, Scene};
use predicament_tasks::replies::{Array, Arrays, Example, FORM, Form, Part, Replies, Reply, SpoiledReply, Unjudged};
use predicament_tasks::{AnswerLine, Asked, Case, Check, Class, Finding, Outcome};

use super::{Cells, CellsFound, Interval, describe};
use crate::answer::{Found, Place};

/// The judge.
pub(super) struct Judge;

/// The name of the answer's array.
const LABELS: &str = "labels";
/// The label of a probe in no cell.
const OUTSIDE: u32 = u32::MAX;
/// The label of a probe at an end, from programs that do not say of which cell.
const AT_END: u32 = u32::MAX - 1;
/// The name of the check.
const CELL: &str = "cell";

/// The label of an answer: the first cell that the probe is in or at an end of, or [`OUTSIDE`].
pub(super) fn label(found: &Found) -> u32 {
    match found.first() {
        Some(&(cell, _)) => u32::try_from(cell).expect("fewer than 2^32 cells"),
        None => OUTSIDE,
    }
}

impl Replies<Interval> for Judge {
    fn parts(&self) -> &'static [Part] {
        const { &[Part::new(LABELS, Form::Labels, "the cell of each probe, −1 for outside, −2 for an end of a cell")] }
    }

    fn example(&self) -> Example {
        Example {
            suites: "intervals",
            functions: &[
                ("python", include_str!("../engines/interval.py")),
                ("cpp", include_str!("../engines/interval.cpp")),
                ("rust", include_str!("../engines/interval.rs")),
                ("node", include_str!("../engines/interval.mjs")),
            ],
        }
    }

    /// Adds the probes: a suite does not list them.
    fn more(&self, _: &Scene, content: &Cells, question: &mut Arrays) {
        question.add_vertices("probes", &content.probes);
    }

    fn judge(
        &self,
        case: &Case<'_, Interval>,
        asked: &Asked<'_>,
        reply: &Reply,
        outcome: &mut Outcome,
    ) -> Result<(), Unjudged> {
        let content = case.content;
        let labels = reply.arrays.labels(LABELS, content.probes.len())?;
        let along = |v| case.scene().coordinate(content.axis, v);
        let row = [content.cells.first().map(|cell| along(cell[0])), content.cells.last().map(|cell| along(cell[1]))];
        for (at, (&label, (&probe, truth))) in labels.iter().zip(content.probes.iter().zip(&case.truth)).enumerate() {
            let is_at_row_end = row.contains(&Some(along(probe)));
            let class = if is_right(label, truth, is_at_row_end) { Class::Agree } else { Class::Topology };
            if asked.budget.answers {
                let (answer, exact) = (word(label), describe(truth));
                outcome.answers.push(AnswerLine { query: at, args: vec![probe], answer, exact, class, stage: "" });
            }
            outcome.note(class, asked.budget.findings_per_class, || {
                let query = Query::of_task("interval", &[probe]);
                Finding::plain(class, CELL, vec![query], word(label), describe(truth))
            });
        }
        Ok(())
    }

    fn reply_of(&self, _: &Scene, _: &Cells, answer: &CellsFound) -> Arrays {
        let mut arrays = Arrays::default();
        arrays.add(LABELS, Array::Ids(answer.0.iter().map(label).collect()));
        arrays
    }

    fn checks(&self) -> &'static [Check] {
        const { &[Check::topology(CELL, "a program's label: a cell that the probe is in, or at an end of")] }
    }

    fn spoiled(&self) -> Vec<SpoiledReply<Interval>> {
        vec![
            SpoiledReply {
                name: "interval-reply-is-one-cell-off",
                what: "every label is the number of the next cell but one",
                backend: "exact",
                caught_by: &[(Class::Topology, CELL)],
                spoil: |_, _, arrays| each(arrays, |label| label.wrapping_add(2)),
            },
            SpoiledReply {
                name: "interval-reply-says-end",
                what: "every label says that the probe is at an end",
                backend: "exact",
                caught_by: &[(Class::Topology, CELL)],
                spoil: |_, _, arrays| each(arrays, |_| AT_END),
            },
            SpoiledReply {
                name: "interval-reply-loses-probes",
                what: "every label is “outside”",
                backend: "exact",
                caught_by: &[(Class::Topology, CELL)],
                spoil: |_, _, arrays| each(arrays, |_| OUTSIDE),
            },
            SpoiledReply {
                name: "interval-reply-has-a-label-too-many",
                what: "the last label is given twice",
                backend: "exact",
                caught_by: &[(Class::Topology, FORM)],
                spoil: |_, _, arrays| {
                    if let Some(Array::Ids(labels)) = arrays.get_mut(LABELS)
                        && let Some(&last) = labels.last()
                    {
                        labels.push(last);
                    }
                },
            },
        ]
    }
}

/// True if a label is right for a probe with these cells; the probe may be at an end of the whole row.
fn is_right(label: u32, truth: &Found, is_at_row_end: bool) -> bool {
    match label {
        OUTSIDE => truth.is_empty() || is_at_row_end,
        AT_END => truth.iter().any(|(_, place)| *place == Place::AtEnd),
        label => truth.iter().any(|&(cell, _)| cell == label as usize),
    }
}

fn word(label: u32) -> String {
    match label {
        OUTSIDE => "in none".to_owned(),
        AT_END => "at an end".to_owned(),
        cell => format!("in {cell}"),
    }
}

fn each(arrays: &mut Arrays, change: impl Fn(u32) -> u32) {
    if let Some(Array::Ids(labels)) = arrays.get_mut(LABELS) {
        labels.iter_mut().for_each(|label| *label = change(*label));
    }
}
