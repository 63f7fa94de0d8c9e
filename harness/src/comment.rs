//! The gate's verdict as Markdown, short enough for a comment on a pull request.
//!
//! The verdict comes first. Texts from a run or an engine are put into code spans, so that they can neither be a
//! heading nor mention anybody.

use std::collections::BTreeSet;

use predicament_oracle::expect::{Expectations, Unused};
use predicament_predicates::{Class, Severity};
use predicament_records::format::thousands;
use predicament_records::{FindingRow, RunDir, Status, SummaryRow};
use predicament_report::{Block, Section, against, section_markdown};

use crate::baseline::Beside;
use crate::exit::{self, Failure};
use crate::ledger::describe;
use crate::out::{program, word};

/// The maximum number of characters of a comment on the usual services.
pub const LIMIT: usize = 65_536;
/// The number of findings shown, each of another scene, backend or class.
const FIRST: usize = 10;
/// The number of lines of one kind shown before the rest is only counted.
const LINES: usize = 50;
/// The maximum number of characters of a text from a run.
const LONGEST: usize = 200;

/// The results of the gate.
pub struct Comment<'a> {
    /// The run, with the final status of its rows.
    pub run: &'a RunDir,
    /// The earlier run, if there is one.
    pub baseline: Option<&'a RunDir>,
    /// The comparison with the earlier run.
    pub beside: &'a Beside,
    /// Findings that pass because their severity does not fail the gate.
    pub passed: &'a [String],
    /// Expectations that the run does not meet.
    pub unmet: &'a [String],
    /// The command that removes unmet expectations.
    pub prune: &'a str,
    /// The expectations of the run.
    pub expected: &'a Expectations,
    /// Expectations that no run can meet.
    pub unused: &'a Unused,
    /// The severities that fail the gate.
    pub fail_on: &'a [Severity],
    /// The exit code of the gate.
    pub code: u8,
}

impl Comment<'_> {
    /// The text, of at most `limit` bytes.
    ///
    /// # Errors
    /// If a section can't be printed.
    pub fn text(&self, limit: usize) -> Result<String, Failure> {
        let mut text = Bounded::new(limit);
        text.line(&format!("## Gate: {}", self.verdict()));
        text.line("");
        self.counts(&mut text);
        let mut failed: Vec<&SummaryRow> = self.run.summary.iter().filter(|row| !row.status.passes()).collect();
        failed.sort_by_key(|row| std::cmp::Reverse(worst(row)));
        text.list("Not as expected", failed.into_iter().map(describe));
        let worse = self.beside.worse.iter().map(ToString::to_string);
        text.list("❌ Worse than the baseline", worse.chain(self.beside.timings.iter().cloned()));
        text.list("✅ Better than the baseline", self.beside.better.iter().map(ToString::to_string));
        text.list("Let pass", self.passed.iter().cloned());
        text.list("Expectations that are not met any more", self.unmet.iter().cloned());
        if !self.unmet.is_empty() || !self.unused.never.is_empty() {
            text.line(&format!("\nRemove unmet expectations with {}.", code(self.prune)));
        }
        let not_run = self.run.not_run().into_iter();
        text.list("Not run", not_run.map(|pair| format!("{}/{} on {}", pair.suite, pair.scene, pair.backend)));
        text.list("Expectations that nothing can meet", self.unused.never.iter().cloned());
        self.findings(&mut text);
        if let Some(Err(why)) = &self.beside.times {
            text.line(&format!("\nTimes were not judged: {}.", code(why)));
        }
        text.list("Times that were not compared", self.beside.not_compared.iter().cloned());
        if let Some(baseline) = self.baseline {
            let section = against(std::slice::from_ref(self.run), std::slice::from_ref(baseline));
            let section = section.map_err(Failure::usage)?;
            let blocks = section.blocks.into_iter().filter(|block| !matches!(block, Block::Plot { .. })).collect();
            let section = Section { lead: String::new(), blocks, ..section };
            text.line("\n### Beside the baseline");
            text.line("");
            section_markdown(&section).map_err(Failure::usage)?.trim().lines().for_each(|line| text.line(line));
        }
        Ok(text.finish())
    }

    fn verdict(&self) -> String {
        let why = match self.code {
            exit::OK => return "passed".to_owned(),
            exit::UNEXPECTED if self.count(Status::Unexpected) > 0 => "unexpected findings",
            exit::UNEXPECTED => "more findings than in the baseline",
            exit::UNEXPECTED_PASS => "an expected finding did not occur",
            exit::INCOMPLETE => "the run is incomplete",
            exit::SLOWER => "slower than the baseline",
            _ => "not passed",
        };
        format!("failed, {why} (code {})", self.code)
    }

    fn count(&self, status: Status) -> usize {
        self.run.summary.iter().filter(|row| row.status == status).count()
    }

    fn counts(&self, text: &mut Bounded) {
        let times = self.beside.timings.len();
        let columns = [
            ("scenes", self.run.plan.scenes.len()),
            ("backends", self.run.plan.backends.len()),
            ("ok", self.count(Status::Ok)),
            ("expected", self.count(Status::Expected)),
            ("unexpected", self.count(Status::Unexpected)),
            ("unexpected pass", self.count(Status::UnexpectedPass)),
            ("never true", self.unused.never.len()),
            ("not run", self.run.not_run().len()),
            ("worse", self.beside.worse.len()),
            ("better", self.beside.better.len()),
            ("slower", times),
        ];
        let row = |cells: Vec<String>| format!("| {} |", cells.join(" | "));
        text.line(&row(columns.iter().map(|(name, _)| (*name).to_owned()).collect()));
        text.line(&row(columns.iter().map(|_| "---:".to_owned()).collect()));
        text.line(&row(columns.iter().map(|(_, count)| thousands(*count as u64)).collect()));
        let outcome = self.run.outcome.describe();
        text.line(&format!("\nLevel {}, {outcome}; run {}.", self.run.plan.level, code(&self.folder())));
    }

    fn folder(&self) -> String {
        self.run.path.display().to_string()
    }

    /// The first findings of each class, scene and backend that fail the gate, with the command to replay them.
    fn findings(&self, text: &mut Bounded) {
        let mut seen = BTreeSet::new();
        let mut red: Vec<&FindingRow> = self.run.findings.iter().filter(|finding| self.is_red(finding)).collect();
        red.sort_by_key(|finding| std::cmp::Reverse(finding.class.severity()));
        let shown: Vec<&FindingRow> =
            red.into_iter().filter(|of| seen.insert((&of.scene_id, &of.backend, of.class))).take(FIRST).collect();
        if shown.is_empty() {
            return;
        }
        text.line("\n### First findings");
        text.line("");
        let (program, run) = (program(), word(&self.folder()));
        for of in shown {
            let truth = if of.truth.is_empty() { String::new() } else { format!(", truth {}", code(&of.truth)) };
            let query = if of.query.is_empty() { String::new() } else { format!(", {}", code(&of.query)) };
            text.line(&format!(
                "* {} on {}: **{}** ({}){query}: got {}{truth}<br>{}<br>{}",
                code(&format!("{}/{}", of.suite, of.scene)),
                code(&of.backend),
                of.class.name().replace('_', "\\_"),
                code(&of.check),
                code(&of.got),
                code(&format!("{program} replay {} --run {run}", of.finding_id)),
                code(&format!("{program} shrink {} --run {run}", of.finding_id)),
            ));
        }
    }

    /// True if a finding is unexpected, or belongs to a row that became worse.
    fn is_red(&self, finding: &FindingRow) -> bool {
        let FindingRow { suite, scene, backend, class, .. } = finding;
        let level = self.run.plan.level.to_string();
        let is_expected = self.expected.matching(suite, scene, backend, &level).any(|entry| entry.class == *class);
        let place = format!("{suite}/{scene} on {backend}");
        let is_asked = self.fail_on.contains(&class.severity());
        is_asked
            && (!is_expected || self.beside.worse.iter().any(|change| change.place == place && change.class == *class))
    }
}

/// A code span with a text from a run or an engine, on one line and shortened.
fn code(text: &str) -> String {
    let mut span: String = text.chars().take(LONGEST).map(plain).collect();
    if text.chars().nth(LONGEST).is_some() {
        span.push('…');
    }
    format!("`{}`", if span.trim().is_empty() { "-" } else { span.trim() })
}

/// A character, replaced if it could end a code span or a line.
fn plain(c: char) -> char {
    match c {
        '`' => '\'',
        c if c.is_control() => ' ',
        c => c,
    }
}

/// The worst severity of a row.
fn worst(row: &SummaryRow) -> Option<Severity> {
    Class::ALL.into_iter().filter(|class| row.count(*class) > 0).map(Class::severity).max()
}

/// A text that takes whole lines up to a limit and counts the rest.
struct Bounded {
    text: String,
    limit: usize,
    left_out: u64,
}

impl Bounded {
    /// The bytes reserved for the last line.
    const LAST: usize = 120;

    fn new(limit: usize) -> Bounded {
        Bounded { text: String::new(), limit, left_out: 0 }
    }

    fn line(&mut self, line: &str) {
        // After the first line that does not fit, no more lines are added, so that the text is a prefix.
        if self.left_out > 0 || self.text.len() + line.len() + 1 + Bounded::LAST > self.limit {
            self.left_out += 1;
        } else {
            self.text += line;
            self.text.push('\n');
        }
    }

    /// Adds a section with one item per line, if there are any items.
    fn list(&mut self, title: &str, items: impl Iterator<Item = String>) {
        let items: Vec<String> = items.collect();
        if items.is_empty() {
            return;
        }
        self.line(&format!("\n### {title}"));
        self.line("");
        items.iter().take(LINES).for_each(|item| self.line(&format!("* {}", code(item))));
        if items.len() > LINES {
            self.line(&format!("* and {} more", thousands((items.len() - LINES) as u64)));
        }
    }

    fn finish(mut self) -> String {
        if self.left_out > 0 {
            self.text +=
                &format!("\n{} more lines do not fit; the run folder has them all.\n", thousands(self.left_out));
        }
        self.text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_others_say_stays_on_its_line_and_in_its_span() {
        assert_eq!(code("a`b\n# c @d"), "`a'b # c @d`");
        assert_eq!(code(&"x".repeat(300)).chars().count(), LONGEST + 3);
        assert_eq!(code(" "), "`-`");
    }

    #[test]
    fn a_text_is_never_longer_than_its_limit() {
        for limit in [200, 300, 500] {
            let mut text = Bounded::new(limit);
            text.list("Many", (0..400).map(|n| format!("item {n} é")));
            let text = text.finish();
            assert!(text.len() <= limit, "{} of {limit}", text.len());
            assert!(text.ends_with("the run folder has them all.\n"), "{text}");
        }
        let mut text = Bounded::new(LIMIT);
        text.list("Many", (0..60).map(|n| n.to_string()));
        assert!(text.finish().ends_with("* `49`\n* and 10 more\n"));
    }
}
