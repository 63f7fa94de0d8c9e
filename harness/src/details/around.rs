//! A raster around the last vertex of a finding's query, with the answers of every backend.

use predicament_corpus::LoadedScene;
use predicament_predicates::Query;
use predicament_records::FindingRow;
use predicament_report::sheet;
use predicament_tasks::signs::truth;
use predicament_tasks::{Contestant, Watch};

use super::apart::distance;
use crate::interrupt;
use crate::pixels::columns;
use crate::pixels::{Step, Walk, axes, exact, tile};

/// The number of places in a row.
const SIDE: usize = 40;
/// The number of screen pixels per place.
const ZOOM: usize = 3;
/// Scenes with more vertices take too long to prepare for a page.
const MOST_VERTICES: usize = 20_000;

/// The sheet with its description. `None` if the finding is not about a sign of input vertices or the scene is too
/// large.
pub fn picture(loaded: &LoadedScene, finding: &FindingRow, backends: &[&dyn Contestant]) -> Option<(String, String)> {
    let query: Query = finding.query.split(" | ").next()?.parse().ok()?;
    let (question, args) = query.question()?;
    if loaded.scene.len() > MOST_VERTICES || args.iter().any(|v| v.is_constructed()) {
        return None;
    }
    let axes = axes(question, &loaded.scene);
    let walker = args[args.len() - 1];
    // The step is chosen so that the line, circle, plane or sphere of the query goes through the picture.
    #[allow(clippy::cast_precision_loss)] // a few dozen
    let length = distance(loaded, &query).map_or(0.0, |distance| 3.0 * distance / SIDE as f64);
    let largest = loaded.scene.point(walker).iter().map(|x| x.abs()).fold(0.0, f64::max);
    let step = if length.is_finite() && length > largest * f64::EPSILON { Step::Length(length) } else { Step::Ulps(1) };
    let walk = Walk { scene: &loaded.scene, query: &query, place: args.len() - 1, axes, step, side: SIDE };
    let raster = walk.raster().ok()?;
    let quiet = |_: u64| {};
    let signs = truth(&raster.scene, &raster.content.queries, &Watch::new(interrupt::flag(), None, &quiet)).ok()?;
    let mut tiles = vec![("exact signs".to_owned(), exact(&signs, SIDE).ok()?)];
    // A backend that declines is reported elsewhere.
    let answered = |backend: &&dyn Contestant| {
        tile(&raster.scene, &raster.content, &signs, SIDE, *backend).ok().map(|tile| (backend.name(), tile))
    };
    tiles.extend(backends.iter().filter_map(answered));
    let [x, y] = axes.map(|axis| axis.name());
    let places = match step {
        Step::Ulps(_) => "neighbouring doubles".to_owned(),
        Step::Length(length) => format!("places {length:.1e} apart"),
    };
    let alt = format!("{query} while {walker} moves over {SIDE} x {SIDE} {places} in {x} and {y}");
    Some((alt, sheet("red negative, yellow zero, blue positive; dark is wrong", &columns(tiles), ZOOM).ok()?))
}
