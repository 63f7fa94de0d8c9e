//! What a report says about single findings: their points, the truth, the answer of each backend, and a picture.
//!
//! A few findings of each class and backend are asked again, alone, as `replay` does. What can't be, because a scene has changed, needs data
//! that are not there, or is too large to be loaded for a page, is left out and counted.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::{Level, LoadedScene};
use predicament_judge::verdict;
use predicament_predicates::{Axis, PredicateKind, Query, Question, Vertex};
use predicament_records::{FindingRow, RunDir};
use predicament_report::Detail;
use predicament_report::picture::{Named, pulled_apart, to_scale};
use predicament_tasks::{Contestant, Explanation};

use crate::cmd::replay::{lines, point_lines};
use crate::exit::Failure;
use crate::select::Selector;
use crate::tool::Tool;

/// So many findings of each class, backend and task.
const FEW: usize = 2;
/// Scenes of more queries are not loaded again.
const MOST_QUERIES: u64 = 100_000;

/// Details of a few findings of each class, backend and task, and how many of those that were chosen have none.
pub fn details(runs: &[RunDir], tool: &Tool) -> Result<(Vec<Detail>, usize), Failure> {
    let (mut told, mut missing) = (Vec::new(), 0);
    for run in runs {
        let backends = tool.pick_planned(&run.plan)?;
        let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
        for ((suite, scene), findings) in chosen(run) {
            match load(run, suite, scene, &findings, tool) {
                Some(loaded) => {
                    for finding in findings {
                        match detail(tool, &loaded, finding, &backends) {
                            Some(detail) => told.push(detail),
                            None => missing += 1,
                        }
                    }
                }
                None => missing += findings.len(),
            }
        }
    }
    Ok((told, missing))
}

/// The first few findings about single queries of each class, backend and task, by suite and scene.
fn chosen(run: &RunDir) -> BTreeMap<(&str, &str), Vec<&FindingRow>> {
    let small: BTreeSet<(&str, &str)> = run
        .plan
        .scenes
        .iter()
        .filter(|scene| scene.queries <= MOST_QUERIES)
        .map(|scene| (&*scene.suite, &*scene.scene_id))
        .collect();
    let mut findings: Vec<&FindingRow> = run
        .findings
        .iter()
        .filter(|row| !row.query.is_empty() && small.contains(&(&*row.suite, &*row.scene_id)))
        .collect();
    findings.sort_by_key(|row| [&row.suite, &row.scene, &row.scene_id, &row.task, &row.finding_id]);
    let mut counts: BTreeMap<(&str, &str, &str), usize> = BTreeMap::new();
    let mut chosen: BTreeMap<(&str, &str), Vec<&FindingRow>> = BTreeMap::new();
    for row in findings {
        let count = counts.entry((row.class.name(), &row.backend, &row.task)).or_default();
        if *count < FEW {
            *count += 1;
            chosen.entry((&row.suite, &row.scene)).or_default().push(row);
        }
    }
    chosen
}

/// The scene as it was; none where it is not there any more.
fn load(run: &RunDir, suite: &str, scene: &str, findings: &[&FindingRow], tool: &Tool) -> Option<LoadedScene> {
    let level: Level = run.plan.level.to_string().parse().ok()?;
    let suite = run.plan.paths.get(suite).map_or(suite, String::as_str).to_owned();
    let selection = Selector { suites: vec![suite], filter: None, level, cache: None }.select(tool).ok()?;
    let def = selection.defs().into_iter().find(|def| def.name == scene)?;
    let loaded = selection.load(def).ok()?;
    findings.iter().all(|finding| finding.scene_id == loaded.id).then_some(loaded)
}

fn detail(tool: &Tool, loaded: &LoadedScene, finding: &FindingRow, backends: &[&dyn Contestant]) -> Option<Detail> {
    let (mut text, mut pictures) = (Vec::new(), Vec::new());
    for written in finding.query.split(" | ") {
        let query: Query = written.parse().ok()?;
        let told: Explanation = tool.task(loaded.task).explain_query(loaded, &query, backends).ok()?;
        if !text.is_empty() {
            text.push(String::new());
        }
        text.push(written.to_owned());
        text.extend(point_lines(loaded, &told.vertices));
        text.extend(lines(&told));
        pictures.extend(drawn(loaded, &query).unwrap_or_default());
    }
    Some(Detail { finding: finding.finding_id.clone(), lines: text, pictures })
}

/// Pictures of a query about input vertices in a plane.
fn drawn(loaded: &LoadedScene, query: &Query) -> Option<Vec<(String, String)>> {
    let (question, args) = query.question()?;
    if args.iter().any(|v| v.is_constructed()) {
        return None;
    }
    let axes = match question {
        Question::Orient2d(plane) => plane.axes(),
        Question::Incircle => [Axis::X, Axis::Y],
        _ => return None,
    };
    let place = |axis: Axis| [Axis::X, Axis::Y, Axis::Z].iter().position(|&other| other == axis).unwrap_or(0);
    let at = |v: Vertex| axes.map(|axis| loaded.scene.point(v)[place(axis)]);
    let named = |points: &[[f64; 2]]| -> Vec<Named> {
        let of = args.iter().zip('a'..).zip(points);
        of.map(|((v, letter), &at)| Named { name: format!("{letter} = {v}"), at }).collect()
    };
    let points: Vec<[f64; 2]> = args.iter().map(|&v| at(v)).collect();
    // How far the last point is on which side, from the exact determinant.
    let exact = verdict(&loaded.scene, question, args).determinant.to_f64();
    let (circle, apart, [on, up]) = match question.kind() {
        PredicateKind::Orient2d => (None, along_line(&points, exact)?, ["line a b", "left is up"]),
        _ => {
            let area = verdict(&loaded.scene, Question::Orient2d(predicament_predicates::Plane::Xy), &args[..3]);
            let (circle, apart) = along_circle(&points, exact, area.determinant.to_f64())?;
            (Some(circle), apart, ["circle a b c", "outside is up"])
        }
    };
    let alt = format!("{}, to scale", question.kind().name());
    let across = format!("across the {on} at a scale of its own, from the exact determinant; {up}");
    Some(vec![(alt, to_scale(&named(&points), circle).ok()?), (across, pulled_apart(&named(&apart), on).ok()?)])
}

/// Points by how far they are along the line from a to b, c with its exact distance from it: half of a turn that is positive is to the left.
fn along_line(points: &[[f64; 2]], determinant: f64) -> Option<Vec<[f64; 2]>> {
    let [a, b, c] = *points else { return None };
    let along = [b[0] - a[0], b[1] - a[1]];
    let length = along[0].hypot(along[1]);
    let of = |p: [f64; 2]| ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / length;
    let apart = vec![[0.0, 0.0], [length, 0.0], [of(c), determinant / length]];
    (length > 0.0 && apart.as_flattened().iter().all(|x| x.is_finite())).then_some(apart)
}

/// The circle of a, b and c, and the points by their angles on it, d with its exact distance from it to the outside.
#[allow(clippy::type_complexity)] // a circle, and points
fn along_circle(points: &[[f64; 2]], power: f64, area: f64) -> Option<(([f64; 2], f64), Vec<[f64; 2]>)> {
    let [a, b, c, d] = *points else { return None };
    let [b, c] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
    let squares = [b, c].map(|p| p[0] * p[0] + p[1] * p[1]);
    let twice = 2.0 * (b[0] * c[1] - b[1] * c[0]);
    let from_a = [(c[1] * squares[0] - b[1] * squares[1]) / twice, (b[0] * squares[1] - c[0] * squares[0]) / twice];
    let radius = from_a[0].hypot(from_a[1]);
    let centre = [a[0] + from_a[0], a[1] + from_a[1]];
    let angle = |p: [f64; 2]| (p[1] - centre[1]).atan2(p[0] - centre[0]) * radius;
    // The determinant is the turn of a, b, c times what the square of the distance from the centre lacks to that of the radius.
    let outside = -power / area / (2.0 * radius);
    let mut apart: Vec<[f64; 2]> = points.iter().map(|&p| [angle(p), 0.0]).collect();
    apart[3] = [angle(d), outside];
    let finite = apart.as_flattened().iter().chain(&centre).all(|x| x.is_finite());
    finite.then_some(((centre, radius), apart))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_point_is_on_its_side_of_the_line() {
        // Left of the line from a to b, by 2^-60 of its length.
        let apart = along_line(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0]], 2_f64.powi(-59)).unwrap();
        assert_eq!(apart, [[0.0, 0.0], [2.0, 0.0], [1.0, 2_f64.powi(-60)]]);
        assert_eq!(along_line(&[[1.0, 1.0], [1.0, 1.0], [2.0, 0.0]], 0.0), None);
    }

    #[test]
    fn the_last_point_is_inside_of_the_circle_or_outside() {
        let points = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -2.0]];
        // A turn of 2, and 1 - 4 less than the square of the radius.
        let ((centre, radius), apart) = along_circle(&points, -6.0, 2.0).unwrap();
        assert_eq!((centre, radius), ([0.0, 0.0], 1.0));
        assert_eq!(apart[3][1], 1.5, "outside, about by 1");
        assert!(along_circle(&points, 1e-20, 2.0).unwrap().1[3][1] < 0.0, "inside");
        assert_eq!(along_circle(&[[0.0; 2]; 4], 0.0, 0.0), None);
    }
}
