//! The section on where errors are: a cell for each backend and suite, in the tone of its share of wrong answers; with
//! few scenes, a cell for each scene.

use std::collections::{BTreeMap, BTreeSet};

use super::rank;
use crate::comparison::{Standing, judged_whole};
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Origin, RunDir, Status, SummaryRow};
use predicament_records::format::{counted, per_million, significant, thousands};

/// The maximum numbers of suites and of scenes for which a column is a scene.
const FEW: (usize, usize) = (2, 30);

pub fn section(runs: &[RunDir]) -> Section {
    let order = backends(runs);
    let rows = || runs.iter().flat_map(|run| &run.summary);
    let suites: BTreeSet<&str> = rows().map(|row| &*row.suite).collect();
    let scenes: BTreeSet<[&str; 2]> = rows().map(|row| [&*row.suite, &*row.scene]).collect();
    let by_scene = suites.len() <= FEW.0 && scenes.len() <= FEW.1;
    let column_of = |row: &'_ SummaryRow| if by_scene { row.scene.clone() } else { row.suite.clone() };
    let columns: BTreeSet<String> = rows().map(column_of).collect();
    let whole = judged_whole(runs);
    let mut sums: BTreeMap<(usize, String), Sums> = BTreeMap::new();
    for row in rows() {
        let sums = sums.entry((rank(&order, &row.backend), column_of(row))).or_default();
        sums.suites.insert(&row.suite);
        sums.rows += 1;
        sums.better += u64::from(row.status == Status::UnexpectedPass);
        sums.standing.add(row, whole.contains(&*row.task));
    }
    let mut table = Table::new("")
        .heat()
        .words(["backend"])
        .of(Origin::of("summary.csv").keys(["backend"]).across(if by_scene { "scene" } else { "suite" }))
        .numbers(columns.iter().map(String::as_str));
    for (at, backend) in order.iter().enumerate() {
        let cell = |column: &String| {
            sums.get(&(at, column.clone())).map_or_else(Cell::default, |sums| sums.cell(backend, column))
        };
        if sums.keys().any(|(of, _)| *of == at) {
            table.push([Cell::code(*backend)].into_iter().chain(columns.iter().map(cell)).collect());
        }
    }
    let of = if by_scene { "scene" } else { "suite" };
    Section {
        id: "heat",
        title: "Errors by backend",
        lead: format!(
            "The share of wrong answers, by backend and {of}. ✗ and a number count whole scenes with a broken law; ≈ \
             counts scenes that are off by rounding alone. Broken ties and values within a tolerance are not wrong \
             if the backend promises them. A frame marks a finding that no expectation lists; a tick marks an \
             expected finding that did not occur. An empty cell was not run. A cell links to its findings."
        ),
        blocks: vec![Block::table_or(table, "No scene was checked.")],
    }
}

/// The sums for a backend on the scenes of a column.
#[derive(Default)]
struct Sums<'r> {
    suites: BTreeSet<&'r str>,
    standing: Standing,
    /// The number of results.
    rows: u64,
    /// The number of expected findings that are gone.
    better: u64,
}

impl Sums<'_> {
    fn cell(&self, backend: &str, column: &str) -> Cell {
        let Standing { answers, scenes, unexpected } = &self.standing;
        let rate = per_million(answers.wrong, answers.asked()).unwrap_or(0.0);
        let mut words = Vec::new();
        if answers.wrong > 0 {
            words.push(share(rate));
        }
        if scenes.broken > 0 {
            words.push(format!("✗{}", thousands(scenes.broken)));
        }
        if scenes.rounded > 0 {
            words.push(format!("≈{}", thousands(scenes.rounded)));
        }
        if words.is_empty() {
            words.push(if self.is_undone() { "–" } else { "0" }.to_owned());
        }
        if self.better > 0 {
            words.push("✓".to_owned());
        }
        let mut title = format!(
            "{backend} on {column}: {} wrong of {}, {} undecided, {} not done; {} with a broken law, {} rounded, {} not done",
            thousands(answers.wrong),
            counted(answers.asked(), "answer"),
            thousands(answers.undecided),
            thousands(answers.not_done),
            counted(scenes.broken, "scene"),
            thousands(scenes.rounded),
            thousands(scenes.not_done),
        );
        if *unexpected > 0 {
            title += &format!("; {} not expected", counted(*unexpected, "result"));
        }
        if self.better > 0 {
            title += &format!("; {} better than expected", counted(self.better, "result"));
        }
        let cell = Cell::from(words.join(" ")).tone(self.tone(rate)).title(title);
        let cell = if *unexpected > 0 { cell.framed() } else { cell };
        match self.suites.first() {
            Some(suite) if answers.wrong + scenes.broken + scenes.rounded > 0 => cell.link(filter(backend, suite)),
            _ => cell,
        }
    }

    fn is_undone(&self) -> bool {
        let Standing { answers, scenes, .. } = &self.standing;
        answers.asked() == answers.not_done && scenes.asked() == scenes.not_done
    }

    fn tone(&self, rate: f64) -> Tone {
        let Standing { answers, scenes, .. } = &self.standing;
        match (answers.wrong, scenes.broken) {
            (0, 0) if self.is_undone() => Tone::Muted,
            (0, 0) if answers.undecided + scenes.rounded > 0 => Tone::Legal,
            (0, 0) => Tone::Good,
            (_, broken) if rate >= 10_000.0 || broken > 0 && broken == scenes.done() => Tone::Heat3,
            (_, broken) if rate >= 100.0 || broken > 0 => Tone::Heat2,
            _ => Tone::Heat1,
        }
    }
}

/// A share, given in millionths, in a short form: a percentage unless it is too small.
fn share(per_million: f64) -> String {
    match per_million {
        rate if rate >= 95_000.0 => format!("{:.0}\u{a0}%", rate / 1e4),
        rate if rate >= 950.0 => format!("{}\u{a0}%", significant(rate / 1e4, 1)),
        rate => format!("{}\u{a0}ppm", significant(rate, 1)),
    }
}

/// The anchor that filters the findings for a backend on a suite.
fn filter(backend: &str, suite: &str) -> String {
    let escaped = |text: &str| {
        let safe = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
        text.chars()
            .map(|c| {
                if safe(c) {
                    c.to_string()
                } else {
                    c.encode_utf8(&mut [0; 4]).bytes().map(|byte| format!("%{byte:02X}")).collect()
                }
            })
            .collect::<String>()
    };
    format!("#findings?backend={}&suite={}", escaped(backend), escaped(suite))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::comparison::{Answers, Scenes};

    #[test]
    fn anchors_hold_any_name() {
        assert_eq!(filter("sos:per-mesh", "a b&c"), "#findings?backend=sos%3Aper-mesh&suite=a%20b%26c");
    }

    #[test]
    fn shares_are_short() {
        let shares = [1e6, 123_456.0, 12_345.0, 1_234.0, 123.0, 0.123].map(share);
        let shares = shares.map(|share| share.replace('\u{a0}', " "));
        assert_eq!(shares, ["100 %", "12 %", "1 %", "0.1 %", "100 ppm", "0.1 ppm"]);
    }

    #[test]
    fn the_tone_follows_what_is_wrong() {
        let tone = |answers: [u64; 3], scenes: [u64; 3]| {
            let [right, undecided, wrong] = answers;
            let [held, broken, not_done] = scenes;
            let answers = Answers { right, undecided, wrong, not_done: 0 };
            let scenes = Scenes { held, broken, not_done, rounded: 0 };
            let sums = Sums { standing: Standing { answers, scenes, unexpected: 0 }, ..Sums::default() };
            sums.tone(per_million(wrong, answers.asked()).unwrap_or(0.0))
        };
        assert_eq!(tone([1_000_000, 0, 0], [10, 0, 0]), Tone::Good);
        assert_eq!(tone([1_000_000, 5, 0], [10, 0, 0]), Tone::Legal);
        assert_eq!(tone([0, 0, 0], [0, 0, 10]), Tone::Muted);
        assert_eq!(tone([1_000_000, 5, 1], [10, 0, 0]), Tone::Heat1);
        assert_eq!(tone([1_000_000, 0, 0], [9, 1, 0]), Tone::Heat2);
        assert_eq!(tone([980_000, 0, 20_000], [10, 0, 0]), Tone::Heat3);
        assert_eq!(tone([0, 0, 0], [0, 10, 0]), Tone::Heat3);
    }
}
