//! The positions at which backends break.

use predicament_tasks::Knob;
use serde::{Deserialize, Serialize};

use crate::compare::{Measure, Share};

/// The break point of a backend on a task for a knob: a row of `breaks.csv`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct BreakPoint {
    /// The task.
    pub task: String,
    /// The knob.
    pub knob: String,
    /// The direction of the knob: `up`, or `down` for negative factors.
    pub way: String,
    /// The backend's name, with its parameters.
    pub backend: String,
    /// The last position up to which every scene was answered as promised; `None` if the first was not.
    pub holds_to: Option<i32>,
    /// The first position at which a scene was not answered as promised; `None` if all were.
    ///
    /// The break point is between the two positions.
    pub breaks_at: Option<i32>,
    /// The number of wrong scenes there, of those answered.
    pub wrong: u64,
    /// The number of scenes answered there, or at the last position if there is no break.
    pub answered: u64,
    /// The upper end of the interval of the share of wrong scenes there (Wilson's, 95 %).
    pub wrong_high: f64,
    /// The first position at which a scene was declined.
    pub declines_at: Option<i32>,
    /// The number of distinct scenes at each position.
    pub scenes: u64,
    /// The rounding of the scene by the knob: `no`, `yes`, or `beyond 53 bits`.
    pub rounds: String,
}

/// The subjects of some rows, each once, in the order of the rows.
pub(crate) struct Asked<'r> {
    /// The knobs, each with its direction.
    pub(crate) ways: Vec<[&'r str; 2]>,
    pub(crate) backends: Vec<&'r str>,
    pub(crate) tasks: Vec<&'r str>,
}

impl<'r> Asked<'r> {
    pub(crate) fn of(rows: &'r [BreakPoint]) -> Asked<'r> {
        fn distinct<T: PartialEq>(all: impl Iterator<Item = T>) -> Vec<T> {
            all.fold(Vec::new(), |mut found, next| {
                if !found.contains(&next) {
                    found.push(next);
                }
                found
            })
        }
        Asked {
            ways: distinct(rows.iter().map(|row| [row.knob.as_str(), row.way.as_str()])),
            backends: distinct(rows.iter().map(|row| row.backend.as_str())),
            tasks: distinct(rows.iter().map(|row| row.task.as_str())),
        }
    }
}

/// A measure with the knob's position.
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
        answered: 0,
        wrong_high: 1.0,
        declines_at: None,
        scenes: 0,
        rounds: knob.rounds().name().to_owned(),
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
        if found.breaks_at.is_none() {
            let share = Share::of_row(wrong);
            (found.wrong, found.answered, found.wrong_high) = (share.count, share.of, share.interval()[1]);
            if share.count > 0 {
                found.breaks_at = Some(position);
            } else {
                found.holds_to = Some(position);
            }
        }
    }
    found
}
