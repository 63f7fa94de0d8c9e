//! A bench folder as five tables: times by vertex id, times by raw
//! coordinates, times in batches, times on maps, and wrong answers. All of it is read back from the folder, so
//! every number can be traced to a row.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use predicament_records::{Error, Interface, RunDir, Spread, SummaryRow, ThroughputRow};
use predicament_report::text::{in_order, markdown};
use predicament_tasks::Class;

/// The peer whose time is one.
const ONE: &str = "robust";

/// The backend whose time is one on maps, where no peer asks for single signs.
const ONE_ON_MAPS: &str = "sos";

/// The backend whose time is one in batches, of which no peer has any.
const ONE_IN_BATCHES: &str = "shewchuk";

const MAPS: &str = "polygon-locate";

/// What the names of backends start with that were asked by raw coordinates.
pub const RAW: &str = "raw:";

/// What a bench folder says about peers, as Markdown.
///
/// # Errors
/// That of a folder that cannot be read.
pub fn tables(folder: &Path) -> Result<String, Error> {
    let run = RunDir::open(folder)?;
    let mut text = String::new();
    let of_sign = |row: &ThroughputRow| row.task != MAPS;
    let is_raw = |row: &ThroughputRow| row.backend.starts_with(RAW);
    let in_batches = |row: &ThroughputRow| matches!(row.interface, Interface::Batch | Interface::Loop);
    let by_id = "Asked by vertex id, in sessions of a prepared scene";
    times(&mut text, &run, by_id, ONE, |row| of_sign(row) && !is_raw(row) && !in_batches(row));
    let raw = "Asked by raw coordinates, nothing prepared";
    times(&mut text, &run, raw, ONE, |row| of_sign(row) && is_raw(row));
    let batches = "Asked in batches by vertex id";
    times(&mut text, &run, batches, ONE_IN_BATCHES, |row| in_batches(row));
    times(&mut text, &run, "Points of maps located", ONE_ON_MAPS, |row| !of_sign(row));
    wrong(&mut text, &run);
    Ok(text)
}

/// Medians in nanoseconds, with their ratios to the backend whose name ends like this one.
fn times(text: &mut String, run: &RunDir, title: &str, one_is: &str, of: impl Fn(&ThroughputRow) -> bool) {
    let mut samples: BTreeMap<(&str, &str, &str), Vec<f64>> = BTreeMap::new();
    // contacts have tables of their own
    let timed = || run.throughput.iter().filter(|row| of(row) && !row.task.starts_with("contacts"));
    for row in timed() {
        samples.entry((&row.task, &row.family, &row.backend)).or_default().push(row.ns_per_query);
    }
    let median =
        |task, family, backend| Some(Spread::of(samples.get(&(task, family, backend))?.iter().copied())?.median);
    let backends = in_order(timed().map(|row| row.backend.as_str()));
    let lines = in_order(timed().map(|row| (&*row.task, &*row.family)));
    let rows = lines.into_iter().map(|(task, family)| {
        let one = backends.iter().find(|name| name.ends_with(one_is)).and_then(|one| median(task, family, one));
        let cells = backends.iter().map(|backend| match (median(task, family, backend), one) {
            (Some(ns), Some(one)) => format!("{ns:.1} ({:.2})", ns / one),
            (Some(ns), None) => format!("{ns:.1}"),
            (None, _) => String::new(),
        });
        [task.to_owned(), family.to_owned()].into_iter().chain(cells).collect()
    });
    let heads = ["task", "family"].into_iter().chain(backends.iter().copied());
    let about = format!("{title}: ns per query, median (ratio to {one_is})");
    markdown(text, &about, 2, heads.map(str::to_owned).collect(), rows.collect());
}

/// Answers that break a promise, for the scenes in which a backend has some.
fn wrong(text: &mut String, run: &RunDir) {
    let shown = |row: &&SummaryRow| !row.backend.starts_with(RAW);
    let backends = in_order(run.summary.iter().filter(shown).map(|row| row.backend.as_str()));
    let cells: BTreeMap<(&str, &str), &SummaryRow> =
        run.summary.iter().map(|row| ((row.scene_id.as_str(), row.backend.as_str()), row)).collect();
    let rows = run.plan.scenes.iter().filter_map(|scene| {
        let cell =
            |backend: &&str| cells.get(&(scene.scene_id.as_str(), *backend)).map_or_else(String::new, |row| count(row));
        let cells: Vec<String> = backends.iter().map(cell).collect();
        let bad = cells.iter().any(|cell| cell.chars().any(|c| c.is_ascii_digit() && c != '0'));
        bad.then(|| [scene.scene.clone(), scene.queries.to_string()].into_iter().chain(cells).collect())
    });
    let rows: Vec<Vec<String>> = rows.collect();
    if rows.is_empty() {
        text.push_str("\nNobody gave a wrong answer.\n");
        return;
    }
    let heads = ["scene", "queries"].into_iter().chain(backends.iter().copied());
    markdown(text, "Wrong answers", 1, heads.map(str::to_owned).collect(), rows);
}

/// How many are wrong, and how many of them are no answers at all.
fn count(row: &SummaryRow) -> String {
    let [nan, panic, declined] = [Class::Nan, Class::Panic, Class::Declined].map(|class| row.count(class));
    if declined > 0 {
        return "declined".to_owned();
    }
    let mut cell = (row.wrong() + row.count(Class::Topology)).to_string();
    for (n, what) in [(nan, "NaN"), (panic, "panics")] {
        if n > 0 {
            // A String takes everything.
            let _ = write!(cell, ", {n} {what}");
        }
    }
    cell
}
