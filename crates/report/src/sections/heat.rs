//! Where something is wrong: a cell for each backend and suite, in the tone of the share of its answers that are wrong.

use std::collections::BTreeMap;

use super::rank;
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Class, Origin, RunDir, SummaryRow};
use predicament_records::format::{counted, per_million, significant, thousands};

pub fn section(runs: &[RunDir]) -> Section {
    let order = backends(runs);
    let mut suites: Vec<&str> = runs.iter().flat_map(|run| &run.summary).map(|row| &*row.suite).collect();
    suites.sort_unstable();
    suites.dedup();
    let mut sums: BTreeMap<(usize, &str), Sums> = BTreeMap::new();
    for row in runs.iter().flat_map(|run| &run.summary) {
        sums.entry((rank(&order, &row.backend), &row.suite)).or_default().add(row);
    }
    let mut table = Table::new("")
        .heat()
        .words(["backend"])
        .of(Origin::of("summary.csv").keys(["backend"]).across("suite"))
        .numbers(suites.iter().copied());
    for (at, backend) in order.iter().enumerate() {
        let cells: Vec<Cell> = suites
            .iter()
            .map(|&suite| sums.get(&(at, suite)).map_or_else(Cell::default, |sums| sums.cell(backend, suite)))
            .collect();
        if sums.keys().any(|(of, _)| *of == at) {
            table.push([Cell::code(*backend)].into_iter().chain(cells).collect());
        }
    }
    Section {
        id: "heat",
        title: "Where something is wrong",
        lead: "The share of answers that are wrong, by backend and suite; ✗ and a number are failed checks of whole scenes. Ties broken and values within a tolerance \
               are what a backend promises and may. An empty cell was not run. A cell leads to its findings."
            .to_owned(),
        blocks: vec![Block::table_or(table, "No scene was checked.")],
    }
}

/// The sums over the scenes of a suite on one backend.
#[derive(Default)]
struct Sums {
    scenes: u64,
    declined: u64,
    unexpected: u64,
    queries: u64,
    wrong: u64,
    /// Failed checks of whole scenes, panics and timeouts.
    failed: u64,
    /// Broken ties and values within a tolerance.
    legal: u64,
}

impl Sums {
    fn add(&mut self, row: &SummaryRow) {
        let of = |classes: &[Class]| classes.iter().map(|&class| row.count(class)).sum::<u64>();
        self.scenes += 1;
        self.unexpected += u64::from(!row.status.passes());
        self.failed += of(&[Class::Topology, Class::Panic, Class::Timeout]);
        if row.has_answers() {
            self.queries += row.queries;
            self.wrong += row.wrong();
            self.legal += of(&[Class::TieBroken, Class::InBand]);
        } else {
            self.declined += u64::from(row.count(Class::Declined) > 0);
        }
    }

    fn cell(&self, backend: &str, suite: &str) -> Cell {
        let rate = per_million(self.wrong, self.queries).unwrap_or(0.0);
        let text = match (self.wrong, self.failed) {
            (0, 0) if self.declined == self.scenes => "–".to_owned(),
            (0, 0) => "0".to_owned(),
            (0, failed) => format!("✗{}", thousands(failed)),
            (_, 0) => share(rate),
            (_, failed) => format!("{} ✗{}", share(rate), thousands(failed)),
        };
        let mut title = format!(
            "{backend} on {suite}, {}: {} wrong of {}, {}, {} ties broken or within a tolerance",
            counted(self.scenes, "scene"),
            thousands(self.wrong),
            counted(self.queries, "answer"),
            counted(self.failed, "failed check"),
            thousands(self.legal),
        );
        if self.declined > 0 {
            title += &format!(", {} declined", thousands(self.declined));
        }
        if self.unexpected > 0 {
            title += &format!("; {} not expected", thousands(self.unexpected));
        }
        let cell = Cell::from(text).tone(self.tone(rate)).title(title);
        let cell = if self.unexpected > 0 { cell.framed() } else { cell };
        if self.wrong + self.failed == 0 { cell } else { cell.link(filter(backend, suite)) }
    }

    fn tone(&self, rate: f64) -> Tone {
        match (self.wrong, self.failed) {
            (0, 0) if self.declined == self.scenes => Tone::Muted,
            (0, 0) if self.legal > 0 => Tone::Legal,
            (0, 0) => Tone::Good,
            _ if rate >= 10_000.0 || self.failed >= self.scenes => Tone::Heat3,
            _ if rate >= 100.0 || self.failed > 0 => Tone::Heat2,
            _ => Tone::Heat1,
        }
    }
}

/// A share that is given in millionths, short: as a percentage where that is not too small.
fn share(per_million: f64) -> String {
    match per_million {
        rate if rate > 1e6 => ">100\u{a0}%".to_owned(),
        rate if rate >= 95_000.0 => format!("{:.0}\u{a0}%", rate / 1e4),
        rate if rate >= 950.0 => format!("{}\u{a0}%", significant(rate / 1e4, 1)),
        rate => format!("{}\u{a0}ppm", significant(rate, 1)),
    }
}

/// The anchor that shows the findings of a backend on a suite.
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

    #[test]
    fn anchors_hold_any_name() {
        assert_eq!(filter("sos:per-mesh", "a b&c"), "#findings?backend=sos%3Aper-mesh&suite=a%20b%26c");
    }

    #[test]
    fn shares_are_short() {
        let shares = [2e6, 1e6, 123_456.0, 12_345.0, 1_234.0, 123.0, 0.123].map(share);
        let shares = shares.map(|share| share.replace('\u{a0}', " "));
        assert_eq!(shares, [">100 %", "100 %", "12 %", "1 %", "0.1 %", "100 ppm", "0.1 ppm"]);
    }

    #[test]
    fn the_tone_follows_what_is_wrong() {
        let sums = |wrong, failed, legal, declined| Sums {
            scenes: 10,
            queries: 1_000_000,
            wrong,
            failed,
            legal,
            declined,
            unexpected: 0,
        };
        let tone = |sums: Sums| sums.tone(per_million(sums.wrong, sums.queries).unwrap());
        assert_eq!(tone(sums(0, 0, 0, 0)), Tone::Good);
        assert_eq!(tone(sums(0, 0, 5, 0)), Tone::Legal);
        assert_eq!(tone(sums(0, 0, 0, 10)), Tone::Muted);
        assert_eq!(tone(sums(1, 0, 5, 0)), Tone::Heat1);
        assert_eq!(tone(sums(0, 1, 0, 0)), Tone::Heat2);
        assert_eq!(tone(sums(20_000, 0, 0, 0)), Tone::Heat3);
        assert_eq!(tone(sums(0, 10, 0, 0)), Tone::Heat3);
    }
}
