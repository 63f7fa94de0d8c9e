//! Where backends break.

use predicament_tasks::Knob;
use serde::{Deserialize, Serialize};

use crate::compare::Measure;

/// Where a backend breaks on a task as a knob is turned: a row of `breaks.csv`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct BreakPoint {
    /// The task.
    pub task: String,
    /// The knob.
    pub knob: String,
    /// Which way it is turned: `up`, or `down` for negative factors.
    pub way: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// The last position up to which every scene was answered as promised; none if the first was not.
    pub holds_to: Option<i32>,
    /// The first position at which one was not; none if all were. The break point is between the two.
    pub breaks_at: Option<i32>,
    /// Scenes in a thousand that were not, there.
    pub wrong: u32,
    /// The first position at which a scene was declined.
    pub declines_at: Option<i32>,
    /// How many scenes there are at each position.
    pub scenes: u64,
}

/// A measure with where the knob was.
pub(super) struct At<'a> {
    pub knob: Knob,
    pub position: i32,
    pub row: &'a Measure,
}

/// The break point of one backend on one task, from all of its measures for a knob, in the order of the positions.
pub(super) fn break_point(task: &str, knob: Knob, way: &str, backend: &str, rows: &[At<'_>]) -> BreakPoint {
    let is_of = |position: i32| knob != Knob::Scale || position == 0 || (position > 0) == (way == "up");
    let mut found = BreakPoint {
        task: task.to_owned(),
        knob: knob.name().to_owned(),
        way: way.to_owned(),
        backend: backend.to_owned(),
        holds_to: None,
        breaks_at: None,
        wrong: 0,
        declines_at: None,
        scenes: 0,
    };
    for &position in knob.positions().iter().filter(|&&position| is_of(position)) {
        let of = |measure: &str| {
            let is = |at: &&At<'_>| at.knob == knob && at.position == position && at.row.measure == measure;
            rows.iter().find(is).map(|at| at.row)
        };
        let Some(declined) = of("declined") else { continue };
        found.scenes = found.scenes.max(declined.of);
        if declined.value > 0.0 && found.declines_at.is_none() {
            found.declines_at = Some(position);
        }
        let Some(wrong) = of("wrong scenes") else { continue };
        if wrong.value > 0.0 {
            if found.breaks_at.is_none() {
                found.breaks_at = Some(position);
                // A share of a thousand: a small whole number after rounding.
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                let rounded = wrong.value.round() as u32;
                found.wrong = rounded;
            }
        } else if found.breaks_at.is_none() {
            found.holds_to = Some(position);
        }
    }
    found
}
