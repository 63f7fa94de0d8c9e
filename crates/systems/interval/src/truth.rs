//! The cells of each probe by definition: coordinates compared as numbers, cell by cell.

use predicament_judge::interval as judge;
use predicament_predicates::{Axis, Scene, Vertex};
use predicament_tasks::{Stop, Watch};
use rayon::prelude::*;

use crate::answer::{Found, Place};
use crate::task::content::Cells;

/// The number of probes between two checks of the watch.
const CHUNK: usize = 1024;

/// The true cells of each probe, by the coordinates of cells and probe.
///
/// # Errors
/// [`Stop`] if the watch stops the computation.
pub fn truth(scene: &Scene, content: &Cells, watch: &Watch) -> Result<Vec<Found>, Stop> {
    let chunks: Result<Vec<Vec<Found>>, Stop> = content
        .probes
        .par_chunks(CHUNK)
        .map(|probes| {
            let found = probes.iter().map(|&probe| by_rule(scene, content, judge::place, probe)).collect();
            watch.done(probes.len() as u64).map(|()| found)
        })
        .collect();
    Ok(chunks?.into_iter().flatten().collect())
}

/// The cells of a probe that is displaced further to the right than all ends: the half-open rule.
#[must_use]
pub fn perturbed(scene: &Scene, content: &Cells, probe: Vertex) -> Found {
    by_rule(scene, content, judge::perturbed_place, probe)
}

/// The cells of a probe by one of the judge's rules for coordinates and indices.
fn by_rule(
    scene: &Scene,
    content: &Cells,
    rule: impl Fn(&Scene, Axis, [Vertex; 2], Vertex) -> judge::Place,
    probe: Vertex,
) -> Found {
    let place = |cell| match rule(scene, content.axis, cell, probe) {
        judge::Place::Outside => Place::Outside,
        judge::Place::AtEnd => Place::AtEnd,
        judge::Place::Inside => Place::Inside,
    };
    let places = content.cells.iter().map(|&cell| place(cell));
    places.enumerate().filter(|&(_, place)| place != Place::Outside).collect()
}
