//! The table of other programs' answers: how far they are rounded. (Their times are those of a bench: a table of a run
//! has the same bytes whenever it runs.)

use super::{Bound, Far};
use crate::{Asked, Case, Outcome, Task};

predicament_records::table! {
    /// `replies.csv`: a part of the answer of another program, with the distance by which its vertices are rounded.
    pub struct ReplyRow [Clone, PartialEq, Debug] in "replies.csv" {
        /// The suite's name.
        pub suite: String,
        /// The scene's name in its suite.
        pub scene: String,
        /// The scene's content id.
        pub scene_id: String,
        /// The task.
        pub task: String,
        /// The backend's name, with its parameters.
        pub backend: String,
        /// The part of the answer: `union`, `intersection`, …
        pub part: String,
        /// The number of vertices of the part.
        pub vertices: u64,
        /// The largest distance of a vertex from where it belongs.
        pub distance: f64 ["scene units"],
        /// The same in units in the last place of the scene's largest coordinate.
        pub distance_ulps: f64 ["ulp"],
        /// The same as a part of the largest edge of the scene's bounding box.
        pub distance_over_l: f64 ["L"],
        /// The class of the distance: `agree` for a few units, `rounded`, or `topology` if it is too large.
        pub class: String,
    }
}

/// Adds the row of a part with coordinates.
pub fn add_row<T: Task>(
    case: &Case<'_, T>,
    asked: &Asked<'_>,
    (part, vertices): (&str, usize),
    (bound, far): (&Bound, &Far),
    outcome: &mut Outcome,
) {
    let loaded = case.loaded;
    outcome.row(&ReplyRow {
        suite: loaded.suite.clone(),
        scene: loaded.name.clone(),
        scene_id: loaded.id.clone(),
        task: loaded.task.to_owned(),
        backend: asked.backend.name(),
        part: part.to_owned(),
        vertices: vertices as u64,
        distance: far.distance,
        distance_ulps: far.distance / bound.unit,
        distance_over_l: if bound.extent > 0.0 { far.distance / bound.extent } else { 0.0 },
        class: far.class.name().to_owned(),
    });
}
