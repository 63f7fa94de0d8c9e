//! Where backends break.

use predicament_tasks::Knob;
use serde::{Deserialize, Serialize};

use crate::compare::{Measure, Share};

/// Where a backend breaks on a task as a knob is turned: a row of `breaks.csv`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
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
    /// Scenes that were not, there, of those answered.
    pub wrong: u64,
    /// Scenes that were answered there; at the last position that was looked at, where there is no break.
    pub answered: u64,
    /// The upper end of the share of wrong scenes that is not surprising there (Wilson's, 95 %).
    pub wrong_high: f64,
    /// The first position at which a scene was declined.
    pub declines_at: Option<i32>,
    /// How many distinct scenes there are at each position.
    pub scenes: u64,
    /// Whether turning the knob rounds the scene: `no`, `yes`, or `beyond 53 bits`.
    pub rounds: String,
}

/// What there are rows of, each once, in the order of the rows.
pub(crate) struct Asked<'r> {
    /// The knobs, each with the way that it is turned.
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
