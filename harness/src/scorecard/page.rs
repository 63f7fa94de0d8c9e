//! Tables of faults and of checks, as text, JSON, CSV and a page.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use predicament_oracle::faults::Area;
use serde_json::{Value, json};

use super::declared::{Declarations, Of, not_needed};
use super::entries::Entry;
use super::verdict::{Verdict, idle, needed_by, verdict};
use crate::colour::{Paint, paint};
use crate::shrinking::Measure;

/// The entries with their records, and the checks that count.
pub struct Card<'a> {
    pub checks: &'a Declarations,
    pub entries: &'a [Entry],
    /// The checks whose findings are ignored.
    pub off: BTreeSet<usize>,
    /// True if all scenes were run. Otherwise any finding catches a fault.
    pub is_whole: bool,
    /// True if all faults are included too, so that the checks that no fault needs can be listed.
    pub is_complete: bool,
}

/// A line of the card.
struct Line {
    name: String,
    area: &'static str,
    verdict: &'static str,
    is_good: bool,
    /// The checks that found the fault, or the checks that missed it.
    by: Vec<String>,
    scenes: Option<u64>,
    queries: Option<u64>,
    shrunk: Option<Measure>,
}

impl Card<'_> {
    fn entry(&self, entry: &Entry) -> Line {
        let verdict = verdict(entry, &self.off, self.is_whole);
        let checks: Vec<usize> = match &verdict {
            Verdict::Missed(missed) => missed.clone(),
            _ => entry.record.found.keys().copied().filter(|check| !self.off.contains(check)).collect(),
        };
        let find = entry.until_caught();
        Line {
            name: entry.name.clone(),
            area: entry.area.map_or("", Area::name),
            verdict: verdict.name(),
            is_good: verdict.is_good(),
            by: checks.into_iter().map(|check| self.checks.0[check].to_string()).collect(),
            scenes: (find.scenes > 0).then_some(find.scenes),
            queries: (find.scenes > 0).then_some(find.queries),
            shrunk: entry.record.shrunk,
        }
    }

    /// The line of a check that is off: caught if faults are missed without it.
    fn off(&self, check: usize) -> Line {
        let declared = &self.checks.0[check];
        let (verdict, is_good, by) = match (not_needed(declared), needed_by(self.entries, check)) {
            (Some(why), _) => ("not needed", true, vec![why.to_owned()]),
            (None, faults) if faults.is_empty() => ("NOT NEEDED", false, Vec::new()),
            (None, faults) => ("caught", true, faults.into_iter().map(|fault| fault.name.clone()).collect()),
        };
        let of = match declared.tasks.as_slice() {
            [] => declared.place(),
            [one] => (*one).to_owned(),
            [first, others @ ..] => format!("{first} and {} more", others.len()),
        };
        let name = format!("off: {declared} of {of}");
        Line { name, area: Area::Checks.name(), verdict, is_good, by, scenes: None, queries: None, shrunk: None }
    }

    fn lines(&self) -> Vec<Line> {
        let entries = self.entries.iter().map(|entry| self.entry(entry));
        let checks = if self.is_complete { 0..self.checks.0.len() } else { 0..0 };
        entries.chain(checks.map(|check| self.off(check))).collect()
    }

    /// Findings that no task declares.
    fn undeclared(&self) -> BTreeSet<&str> {
        self.entries.iter().flat_map(|entry| &entry.record.undeclared).map(String::as_str).collect()
    }

    /// True if all lines are good.
    pub fn is_good(&self) -> bool {
        self.lines().iter().all(|line| line.is_good) && self.undeclared().is_empty()
    }

    /// The card as text: a line for each fault, and for each check that no fault needs.
    pub fn text(&self) -> String {
        let all = self.lines();
        let shown: Vec<&Line> = all
            .iter()
            .enumerate()
            .filter(|(at, line)| *at < self.entries.len() || !line.is_good)
            .map(|(_, line)| line)
            .collect();
        let width = shown.iter().map(|line| line.name.chars().count()).max().unwrap_or(0);
        let with_sizes = all.iter().any(|line| line.shrunk.is_some());
        let number = |count: Option<u64>| count.map_or_else(String::new, |count| count.to_string());
        let mut text =
            format!("{:<width$}  {:<10}  {:<10} {:>6} {:>9}", "fault", "area", "verdict", "scenes", "queries");
        if with_sizes {
            let _ = write!(text, " {:>6} {:>6}", "points", "pieces");
        }
        text += "  by\n";
        for line in shown {
            let Line { name, area, verdict, scenes, queries, .. } = line;
            let (scenes, queries) = (number(*scenes), number(*queries));
            let shown = paint(if line.is_good { Paint::Good } else { Paint::Bad }, &format!("{verdict:<10}"));
            let _ = write!(text, "{name:<width$}  {area:<10}  {shown} {scenes:>6} {queries:>9}");
            if with_sizes {
                let [points, pieces] = match line.shrunk {
                    Some(Measure { points, pieces, .. }) => [points, pieces].map(|count| count.to_string()),
                    None => [String::new(), String::new()],
                };
                let _ = write!(text, " {points:>6} {pieces:>6}");
            }
            let _ = writeln!(text, "  {}", line.by.join(", "));
        }
        for finding in self.undeclared() {
            let _ = writeln!(text, "NOT DECLARED: {finding}");
        }
        let good = all.iter().take(self.entries.len()).filter(|line| line.is_good).count();
        let _ = writeln!(text, "{good} of {} as expected", self.entries.len());
        if self.is_complete {
            let excused = self.checks.0.iter().filter(|declared| not_needed(declared).is_some()).count();
            let idle = idle(self.checks, self.entries).len();
            let needed = self.checks.0.len() - excused - idle;
            let _ = writeln!(
                text,
                "{needed} of {} checks turn the card red if they are switched off; {excused} more need no fault, and `--checks` says why",
                needed + idle
            );
        }
        text
    }

    /// The card as JSON objects, one per line: a fault, or a check that is off.
    pub fn json(&self) -> String {
        let object = |line: &Line| -> Value {
            json!({
                "name": line.name,
                "area": line.area,
                "verdict": line.verdict,
                "good": line.is_good,
                "checks": line.by,
                "scenes": line.scenes,
                "queries": line.queries,
                "points": line.shrunk.map(|size| size.points),
                "pieces": line.shrunk.map(|size| size.pieces),
            })
        };
        let mut text: String = self.lines().iter().map(|line| format!("{}\n", object(line))).collect();
        for finding in self.undeclared() {
            let _ = writeln!(text, "{}", json!({ "name": finding, "verdict": "NOT DECLARED", "good": false }));
        }
        text
    }

    /// The card as CSV.
    pub fn csv(&self) -> Result<String, String> {
        let head = ["fault", "area", "verdict", "scenes", "queries", "points", "pieces", "by"];
        let number = |count: Option<u64>| count.map_or_else(String::new, |count| count.to_string());
        let size = |count: Option<usize>| count.map_or_else(String::new, |count| count.to_string());
        let rows = self.lines().into_iter().map(|line| {
            [
                line.name,
                line.area.to_owned(),
                line.verdict.to_owned(),
                number(line.scenes),
                number(line.queries),
                size(line.shrunk.map(|size| size.points)),
                size(line.shrunk.map(|size| size.pieces)),
                line.by.join(", "),
            ]
        });
        csv(head, rows)
    }
}

/// A table as CSV.
fn csv<const N: usize>(head: [&str; N], rows: impl Iterator<Item = [String; N]>) -> Result<String, String> {
    let mut table = csv::Writer::from_writer(Vec::new());
    let told = |error: csv::Error| error.to_string();
    table.write_record(head).map_err(told)?;
    rows.into_iter().try_for_each(|row| table.write_record(row)).map_err(told)?;
    let bytes = table.into_inner().map_err(|error| error.to_string())?;
    String::from_utf8(bytes).map_err(|error| error.to_string())
}

/// The faults that a check has to find, or the reason why there are none.
fn needs(checks: &Declarations, entries: &[Entry], check: usize) -> String {
    let faults: Vec<&str> =
        entries.iter().filter(|entry| entry.wants.contains(&check)).map(|entry| entry.name.as_str()).collect();
    not_needed(&checks.0[check]).map_or_else(|| faults.join(", "), |why| format!("none: {why}"))
}

/// All checks as CSV.
pub fn checks_csv(checks: &Declarations, entries: &[Entry]) -> Result<String, String> {
    let rows = checks.0.iter().enumerate().map(|(at, declared)| {
        [
            declared.name().to_owned(),
            declared.class().map_or("", |class| class.name()).to_owned(),
            declared.place(),
            declared.means().to_owned(),
            needs(checks, entries, at),
        ]
    });
    csv(["check", "class", "tasks", "holds", "faults"], rows)
}

/// All checks as lines of text.
pub fn checks_text(checks: &Declarations, entries: &[Entry]) -> String {
    let mut text = String::new();
    for (at, declared) in checks.0.iter().enumerate() {
        let _ = writeln!(text, "{declared} of {}: {}", declared.place(), declared.means());
        let _ = writeln!(text, "    faults: {}", needs(checks, entries, at));
    }
    text
}

/// The page `docs/CHECKS.md`.
pub fn checks_page(checks: &Declarations, entries: &[Entry]) -> String {
    let faults = entries.iter().filter(|entry| entry.is_fault()).count();
    let guards = checks.0.iter().filter(|declared| declared.class().is_none()).count();
    let mut text = format!(
        "\
<!-- made by `predicament setup selftest --checks --format md`; a test holds this page to it -->
# Checks

The judge and the tool's own tests have {} checks. A finding that none of them declares is a mistake in the judge, and
turns `gate` and `selftest` red. {faults} planted faults show that the checks are needed: if a check is switched off
(`predicament setup selftest --without NAME`), the tool misses a fault, and the scorecard is red. A check that no fault
needs states the reason. [METHODOLOGY](METHODOLOGY.md) explains how answers are judged;
[CONTRIBUTING](../CONTRIBUTING.md) explains how to plant a fault.

A check has a class and a name (the column `check` of `findings.csv`). The tasks that report it declare it. `invariant`
stands for the statements that an algorithm checks itself; a finding of such a statement has the statement as its name.
The last {guards} checks have no class: they test the judge and the readers against independent facts.

| check | class | tasks | property that it checks | faults that need it |
| --- | --- | --- | --- | --- |
",
        checks.0.len()
    );
    let cell = |text: &str| text.replace('|', "\\|").replace('_', "\\_");
    for (at, declared) in checks.0.iter().enumerate() {
        let class = declared.class().map_or("", |class| class.name());
        let more = match declared.of {
            Of::Judge(check) if check.thorough => "; only in thorough runs (`--level full`)",
            _ => "",
        };
        let faults = needs(checks, entries, at);
        let faults = if not_needed(declared).is_some() {
            faults
        } else {
            faults.split(", ").map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
        };
        let _ = writeln!(
            text,
            "| {} | {} | {} | {}{more} | {faults} |",
            cell(declared.name()),
            cell(class),
            declared.place(),
            cell(declared.means()),
        );
    }
    text
}
