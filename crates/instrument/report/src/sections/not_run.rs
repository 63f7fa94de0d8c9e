//! The section on scenes that were not run, so that readers do not mistake them for successes.

use std::collections::{BTreeMap, BTreeSet};

use super::{rank, run_head, run_label, some_of};
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Class, Error, Origin, RunDir};
use predicament_records::format::{length, thousands};
use predicament_records::{ImportRow, SampledRow};

/// The maximum number of scenes that are listed.
const FEW: usize = 5;

pub fn section(runs: &[RunDir]) -> Result<Section, Error> {
    let mut blocks = Vec::new();
    let (skipped, unnamed) = (not_selected(runs), left_out(runs));
    let scenes_of_class = |class: Class, caption: &str| {
        scenes(runs, caption, |run| {
            let rows = run.summary.iter().filter(|row| row.count(class) > 0);
            rows.map(|row| [&*row.suite, &*row.task, &*row.backend, &*row.scene].map(str::to_owned)).collect()
        })
    };
    let planned = scenes(runs, "Planned and not run", |run| {
        run.not_run().into_iter().map(|pair| [pair.suite, pair.task, pair.backend, pair.scene]).collect()
    });
    let declined = scenes_of_class(Class::Declined, "Declined by the backend");
    let timeout = scenes_of_class(Class::Timeout, "Out of time");
    for table in [skipped, unnamed, planned, declined, timeout] {
        if !table.is_empty() {
            blocks.push(Block::Table(table));
        }
    }
    if blocks.is_empty() {
        let note =
            "Nothing: every suite was selected, every scene was run, and no backend declined or ran out of time.";
        blocks.push(Block::Note(note.to_owned(), Tone::Good));
    }
    // Scenes that were run and judged only in part: neither a success nor a failure of the rest.
    let sampled = sampled(runs)?;
    for table in [sampled, imported(runs)?] {
        if !table.is_empty() {
            blocks.push(Block::Table(table));
        }
    }
    Ok(Section { id: "not-run", title: "What was not run", lead: String::new(), blocks })
}

/// The table of scenes that are too large for the whole truth, once for all backends.
fn sampled(runs: &[RunDir]) -> Result<Table, Error> {
    let mut table = Table::new("Compared with the truth of only a part")
        .words(run_head(runs))
        .words(["suite", "scene", "task", "part"]);
    for (index, run) in runs.iter().enumerate() {
        let rows = run.rows::<SampledRow>()?;
        let scenes: BTreeSet<_> = rows.iter().map(|row| [&row.suite, &row.scene, &row.task, &row.truth_of]).collect();
        for scene in scenes {
            let cells = scene.map(|cell| Cell::from(cell.as_str()));
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    Ok(table)
}

/// The table of scenes that differ from their files.
fn imported(runs: &[RunDir]) -> Result<Table, Error> {
    let mut table = Table::new("Changed by the reader").words(run_head(runs)).words(["suite", "scene", "task"]);
    table = table.of(Origin::of("imports.csv").keys(["suite", "scene", "task"])).numbers([
        "decimals rounded",
        "third coordinates left out",
        "repeated points dropped",
        "rings dropped",
        "faces dropped",
        "regions dropped",
    ]);
    for (index, run) in runs.iter().enumerate() {
        for row in run.rows::<ImportRow>()?.iter().collect::<BTreeSet<_>>() {
            let words = [&row.suite, &row.scene, &row.task].map(|cell| Cell::from(cell.as_str()));
            let counts = row.counts().map(|count| if count == 0 { Cell::from("") } else { thousands(count).into() });
            table.push(run_label(runs, index).into_iter().chain(words).chain(counts).collect());
        }
    }
    Ok(table)
}

fn not_selected(runs: &[RunDir]) -> Table {
    let mut table = Table::new("Suites that were not selected").words(run_head(runs)).words(["suite", "reason"]);
    for (index, run) in runs.iter().enumerate() {
        for skipped in run.plan.not_selected.iter().collect::<BTreeSet<_>>() {
            let cells = [Cell::from(skipped.suite.as_str()), skipped.reason.as_str().into()];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    table
}

/// The table of the tool's backends that run only if they are named.
fn left_out(runs: &[RunDir]) -> Table {
    let mut table = Table::new("Backends that were not named").words(run_head(runs)).words(["not run", "to run them"]);
    for (index, run) in runs.iter().enumerate() {
        let names = run.plan.left_out.join(", ");
        if !names.is_empty() {
            let cells = [Cell::from(names), Cell::code(format!("-b {}", run.plan.left_out.join(",")))];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    table
}

/// A table of scenes by suite, task and backend; `list` gives suite, task, backend and scene.
fn scenes(runs: &[RunDir], caption: &str, list: impl Fn(&RunDir) -> Vec<[String; 4]>) -> Table {
    let order = backends(runs);
    let mut table = Table::new(caption)
        .words(run_head(runs))
        .words(["suite", "task", "backend"])
        .of(Origin::of("summary.csv").keys(["suite", "task", "backend"]))
        .numbers(["scenes"])
        .words(["which"]);
    for (index, run) in runs.iter().enumerate() {
        let mut groups: BTreeMap<(String, String, usize), Vec<String>> = BTreeMap::new();
        for [suite, task, backend, scene] in list(run) {
            groups.entry((suite, task, rank(&order, &backend))).or_default().push(scene);
        }
        for ((suite, task, backend), mut names) in groups {
            names.sort_unstable();
            let cells = [
                suite.into(),
                task.into(),
                order[backend].into(),
                thousands(length(names.len())).into(),
                some_of(names.iter().map(String::as_str), FEW).into(),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    table
}
