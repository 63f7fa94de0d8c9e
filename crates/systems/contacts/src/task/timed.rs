//! Two tables of a bench folder about contacts: times, and the numbers of pairs by outcome. Only the number of
//! primitives does not come from the folder.

use std::collections::BTreeMap;

use super::{Complexes, ContactRow};
use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Scene};
use predicament_records::{Error, PlannedScene, RunDir, Spread};
use predicament_report::text::{in_order, markdown};
use predicament_tasks::on_threads;

/// The number of primitives: edges in the plane, triangles in space.
pub(super) fn primitives(scene: &Scene, complexes: &Complexes) -> u64 {
    let of = |complex: &Complex| match scene.dimension() {
        Dimension::Two => complex.edges().len(),
        Dimension::Three => complex.triangles().len(),
    };
    complexes.both().into_iter().map(of).sum::<usize>() as u64
}

/// The primitives of each scene, by its id.
struct Primitives<'a>(&'a BTreeMap<String, u64>);

impl Primitives<'_> {
    fn of(&self, scene: &PlannedScene) -> Option<u64> {
        self.0.get(&scene.scene_id).copied().filter(|&count| count > 0)
    }
}

/// The tables about contacts of a bench folder, as Markdown; empty if it has none.
///
/// # Errors
/// If the folder can't be read.
pub(super) fn tables(run: &RunDir, primitives: &BTreeMap<String, u64>, threads: &[usize]) -> Result<String, Error> {
    let primitives = Primitives(primitives);
    let mut text = String::new();
    times(&mut text, run, &primitives, threads);
    pairs(&mut text, run, &run.rows()?, &primitives);
    Ok(text)
}

/// The key of a series of scenes of different sizes: their names differ only after the last dash.
fn series(scene: &PlannedScene) -> (&str, &str, &str) {
    (&scene.suite, &scene.task, scene.scene.rsplit_once('-').map_or(&*scene.scene, |(stem, _)| stem))
}

// Counts here are far below 2^53.
#[allow(clippy::cast_precision_loss)]
fn times(text: &mut String, run: &RunDir, primitives: &Primitives<'_>, threads: &[usize]) {
    let mut samples: BTreeMap<(&str, &str, &str), Vec<f64>> = BTreeMap::new();
    for row in &run.throughput {
        let total = row.ns_per_query * row.queries as f64;
        samples.entry((&row.task, &row.family, &row.backend)).or_default().push(total);
    }
    let median = |scene: &PlannedScene, threads: usize, backend: &str| {
        let family = on_threads(&scene.family, threads);
        let samples = samples.get(&(&*scene.task, &*family, backend))?;
        Some(Spread::of(samples.iter().copied())?.median / primitives.of(scene)? as f64)
    };
    let scenes: Vec<&PlannedScene> = run.plan.scenes.iter().filter(|scene| primitives.of(scene).is_some()).collect();
    let backends = in_order(run.throughput.iter().map(|row| row.backend.as_str()));
    let mut rows = Vec::new();
    for scene in &scenes {
        // the smallest scene of the series, if there are different sizes
        let alike = scenes.iter().filter(|other| series(other) == series(scene));
        let smallest = alike.min_by_key(|other| primitives.of(other)).filter(|other| {
            let sizes = in_order(scenes.iter().filter(|s| series(s) == series(other)).map(|s| primitives.of(s)));
            sizes.len() > 1
        });
        for &threads in threads {
            let cell = |backend: &&str| match median(scene, threads, backend) {
                None => String::new(),
                Some(ns) => match smallest.and_then(|smallest| median(smallest, threads, backend)) {
                    Some(first) => format!("{ns:.0} ({:.2})", ns / first),
                    None => format!("{ns:.0}"),
                },
            };
            let cells: Vec<String> = backends.iter().map(cell).collect();
            if cells.iter().any(|cell| !cell.is_empty()) {
                let count = primitives.of(scene).unwrap_or_default();
                let heads = [scene.scene.clone(), count.to_string(), threads.to_string()];
                rows.push(heads.into_iter().chain(cells).collect());
            }
        }
    }
    let heads = ["scene", "primitives", "threads"].into_iter().chain(backends).map(str::to_owned).collect();
    let about = "Contacts: ns per primitive, median (relative to the smallest scene of its kind)";
    markdown(text, about, 1, heads, rows);
}

/// The sums over all kinds of pairs of one level.
#[derive(Clone, Copy, Default)]
struct Level {
    candidates: u64,
    ended: u64,
    registered: u64,
}

#[allow(clippy::cast_precision_loss)] // as above
fn pairs(text: &mut String, run: &RunDir, contacts: &[ContactRow], primitives: &Primitives<'_>) {
    let mut rows: Vec<Vec<String>> = Vec::new();
    for scene in &run.plan.scenes {
        let Some(count) = primitives.of(scene) else { continue };
        let of_scene = || contacts.iter().filter(|row| row.scene_id == scene.scene_id);
        for backend in in_order(of_scene().map(|row| row.backend.as_str())) {
            let mut levels: BTreeMap<u8, Level> = BTreeMap::new();
            for row in of_scene().filter(|row| row.backend == backend) {
                let level = levels.entry(row.rank_a + row.rank_b).or_default();
                level.candidates += row.candidates;
                level.ended += row.ended;
                level.registered += row.registered;
            }
            let cell = |level: &Level| {
                let share = |part: u64| 100.0 * part as f64 / level.candidates.max(1) as f64;
                let each = level.candidates as f64 / count as f64;
                format!("{each:.2}, {:.1} %, {:.1} %", share(level.ended), share(level.registered))
            };
            let cells = (0..=3).map(|level| levels.get(&level).map_or_else(String::new, cell));
            rows.push([scene.scene.clone(), backend.to_owned()].into_iter().chain(cells).collect());
        }
    }
    let heads = ["scene", "backend", "level 0", "level 1", "level 2", "level 3"].map(str::to_owned).to_vec();
    let about = "Contacts: candidates per primitive, share that had already ended, share that was registered";
    markdown(text, about, 2, heads, rows);
}
