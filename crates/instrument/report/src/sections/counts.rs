//! The section on the numbers of answers by class: over everything, then suite by suite.

use std::collections::BTreeMap;

use super::{rank, run_head, run_label};
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Class, Origin, RunDir, Status, SummaryRow};
use predicament_records::format::{length, per_million, significant, thousands};

/// The maximum number of unexpected scenes that are listed.
const MANY: usize = 50;

pub fn section(runs: &[RunDir]) -> Section {
    let rows = || runs.iter().flat_map(|run| &run.summary);
    let seen = |class: &Class| rows().any(|row| row.count(*class) > 0);
    let (occurred, never): (Vec<Class>, Vec<Class>) = Class::ALL.into_iter().partition(seen);
    let order = backends(runs);

    let mut totals: BTreeMap<(usize, usize), Sums> = BTreeMap::new();
    let mut suites: BTreeMap<(usize, &str, usize), Sums> = BTreeMap::new();
    for (index, run) in runs.iter().enumerate() {
        for row in &run.summary {
            let backend = rank(&order, &row.backend);
            totals.entry((index, backend)).or_default().add(row);
            suites.entry((index, &row.suite, backend)).or_default().add(row);
        }
    }
    let mut by_backend = table("By backend, over all suites", runs, &["backend"], &occurred);
    for ((index, backend), sums) in &totals {
        let label = run_label(runs, *index).into_iter().chain([order[*backend].into()]);
        by_backend.push(label.chain(sums.cells(&occurred)).collect());
    }
    let mut by_suite = table("By suite and backend", runs, &["suite", "backend"], &occurred);
    for ((index, suite, backend), sums) in &suites {
        let label = run_label(runs, *index).into_iter().chain([(*suite).into(), order[*backend].into()]);
        by_suite.push(label.chain(sums.cells(&occurred)).collect());
    }

    let mut blocks = Vec::new();
    if totals.is_empty() {
        blocks.push(Block::Note("No scene was checked.".to_owned(), Tone::Notable));
    } else {
        let alarming = alarming(runs, &order);
        if !alarming.is_empty() {
            blocks.push(Block::Table(alarming));
        }
        blocks.extend([Block::Table(by_backend), Block::Table(by_suite)]);
        if !never.is_empty() {
            let names: Vec<&str> = never.into_iter().map(Class::name).collect();
            blocks.push(Block::Note(format!("Classes that never occurred: {}.", names.join(", ")), Tone::Muted));
        }
    }
    Section {
        id: "answers",
        title: "Answers by class",
        lead: "Each answer is compared with the truth and with what its backend promised. A scene is expected if \
               expected.toml lists all its findings. It is unexpected if a finding is not listed, or if a listed \
               finding did not occur; the latter counts as mended, and its expectation can be pruned. Wrong answers \
               are overreach, missed_zero, sign_flip, inconsistent and nan. Queries are counted only for scenes that \
               were answered."
            .to_owned(),
        blocks,
    }
}

/// The table of scenes that the gate rejects.
fn alarming(runs: &[RunDir], order: &[&str]) -> Table {
    let failed = || runs.iter().flat_map(|run| &run.summary).filter(|row| !row.status.passes());
    let mut caption = "Not as expected".to_owned();
    let count = failed().count();
    if count > MANY {
        caption += &format!(": the first {MANY} of {}", thousands(length(count)));
    }
    let mut table = Table::new(caption)
        .words(run_head(runs))
        .words(["suite", "scene", "task", "backend"])
        .of(Origin::of("summary.csv").keys(["suite", "scene", "task", "backend"]).under("scene", "scene_id"))
        .words(["status", "classes"]);
    let mut left = MANY;
    for (index, run) in runs.iter().enumerate() {
        let mut rows: Vec<&SummaryRow> = run.summary.iter().filter(|row| !row.status.passes()).collect();
        rows.sort_by_key(|r| ([&*r.suite, &*r.scene, &*r.scene_id, &*r.task], rank(order, &r.backend)));
        for row in rows.into_iter().take(left) {
            left -= 1;
            let classes = Class::ALL.into_iter().filter(|&class| class != Class::Agree && row.count(class) > 0);
            let classes: Vec<String> =
                classes.map(|class| format!("{class} {}", thousands(row.count(class)))).collect();
            let cells = [
                row.suite.as_str().into(),
                Cell::from(row.scene.as_str()).detail(&*row.scene_id),
                row.task.as_str().into(),
                row.backend.as_str().into(),
                Cell::from(row.status.name()).tone(tone_of(row.status)),
                classes.join(", ").into(),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    table
}

/// The tone of a status: an unexpected finding is bad, an expected one that is gone is not.
fn tone_of(status: Status) -> Tone {
    match status {
        Status::Unexpected => Tone::Bad,
        Status::UnexpectedPass => Tone::Good,
        Status::Ok | Status::Expected => Tone::Plain,
    }
}

fn table(caption: &str, runs: &[RunDir], labels: &[&str], classes: &[Class]) -> Table {
    Table::new(caption)
        .basis("counts of answers and of failed checks; the last column is wrong answers per million answered queries")
        .words(run_head(runs))
        .words(labels.iter().copied())
        .of(Origin::of("summary.csv").keys(labels.iter().copied()))
        .numbers(["scenes", "expected", "unexpected", "mended", "queries"])
        .numbers(classes.iter().map(|class| class.name()))
        .numbers(["wrong per million"])
}

/// The sums over some scenes on one backend.
#[derive(Default)]
struct Sums {
    scenes: usize,
    expected: usize,
    unexpected: usize,
    /// The number of expected findings that are gone.
    mended: usize,
    queries: u64,
    wrong: u64,
    classes: BTreeMap<Class, u64>,
    /// The classes of scenes that the gate rejects.
    alarming: BTreeMap<Class, u64>,
}

impl Sums {
    fn add(&mut self, row: &SummaryRow) {
        self.scenes += 1;
        self.expected += usize::from(row.status == Status::Expected);
        self.unexpected += usize::from(row.status == Status::Unexpected);
        self.mended += usize::from(row.status == Status::UnexpectedPass);
        // Declined queries do not count as asked.
        self.queries += if row.has_answers() { row.queries } else { 0 };
        self.wrong += row.wrong();
        for class in Class::ALL {
            *self.classes.entry(class).or_default() += row.count(class);
            if row.status == Status::Unexpected {
                *self.alarming.entry(class).or_default() += row.count(class);
            }
        }
    }

    fn cells(&self, classes: &[Class]) -> impl Iterator<Item = Cell> {
        let scenes = [
            Cell::count(length(self.scenes)),
            Cell::count(length(self.expected)),
            alarm(length(self.unexpected), self.unexpected > 0),
            Cell::count(length(self.mended)).tone(if self.mended > 0 { Tone::Good } else { Tone::Muted }),
            Cell::count(self.queries),
        ];
        let counts = classes.iter().map(|class| {
            let count = self.classes.get(class).copied().unwrap_or(0);
            let alarming = self.alarming.get(class).copied().unwrap_or(0) > 0;
            match class {
                Class::Agree | Class::TieBroken | Class::InBand => Cell::count(count),
                _ => alarm(count, alarming),
            }
        });
        let rate = per_million(self.wrong, self.queries).map_or_else(|| "—".to_owned(), |rate| significant(rate, 3));
        let rate = Cell::from(rate).tone(if self.wrong == 0 { Tone::Muted } else { Tone::Plain });
        scenes.into_iter().chain(counts).chain([rate])
    }
}

/// A count of errors, expected or not.
fn alarm(count: u64, alarming: bool) -> Cell {
    Cell::count(count).tone(match count {
        0 => Tone::Muted,
        _ if alarming => Tone::Bad,
        _ => Tone::Notable,
    })
}
