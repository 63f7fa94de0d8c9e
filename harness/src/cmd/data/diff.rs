//! `diff`: the changes from one run to another, as Markdown for a comment or as JSON for a script.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use predicament_predicates::Severity;
use predicament_records::{RunDir, SummaryRow};
use predicament_report::{Block, Section, against, section_markdown};
use predicament_tasks::Class;
use serde_json::{Value, json};

use crate::baseline::Change;
use crate::exit::{self, Failure};
use crate::progress;

const EXAMPLES: &str = "\
A pair of scene and backend has changed if its status or the count of a class has changed. Changes for the worse and \
for the better come first, the worst severity on top: broken, not done, rounded. Times that both folders have are \
shown with their intervals, but do not change the exit code; `gate --baseline` judges times. The exit code is 100 if \
a pair that was added or became worse is not as expected, and 0 otherwise. An improvement is never a failure.

Examples:
  predicament data diff out/main out/branch > comment.md
  predicament data diff out/main out/branch --json | jq .changed
  predicament report out/branch --against out/main --out out/report    the same as a page, with plots";

/// Show what changed from one run to another
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The later run; or the earlier run and the later run
    #[arg(required = true, num_args = 1..=2, value_name = "RUN")]
    pub runs: Vec<PathBuf>,

    /// The earlier run, if only one run is named
    #[arg(long, value_name = "RUN")]
    pub baseline: Option<PathBuf>,

    /// Markdown for a comment, or one JSON object: the pairs of scene and backend that were added, removed and changed
    #[arg(long, value_enum, default_value_t = Format::Md)]
    pub format: Format,
}

/// The output format.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Format {
    /// Markdown.
    Md,
    /// One JSON object.
    Json,
}

impl Args {
    /// The folders of the earlier and of the later run.
    fn folders(&self) -> Result<[&PathBuf; 2], Failure> {
        match (&self.baseline, self.runs.as_slice()) {
            (Some(before), [now]) | (None, [before, now]) => Ok([before, now]),
            (Some(_), _) => Err(Failure::usage(
                "two runs and --baseline are three runs; name one, and the earlier one by --baseline",
            )),
            (None, _) => Err(Failure::usage("the earlier run is missing; name it by --baseline")),
        }
    }
}

type Key<'r> = [&'r str; 5];

/// The worst severity in which a pair is worse, then the worst in which it is better.
type Rank = [Option<Severity>; 2];

/// The number of changes listed before the rest is only counted.
const LINES: usize = 50;

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    let _working = progress::working("comparing runs");
    let folders = args.folders()?;
    let [before, now] = folders.map(RunDir::open);
    let (before, now) = (before.map_err(Failure::usage)?, now.map_err(Failure::usage)?);
    let [old, new] = [&before, &now].map(pairs);
    let keys: BTreeSet<&Key<'_>> = old.keys().chain(new.keys()).collect();
    let (mut added, mut removed, mut changed, mut unchanged) = (Vec::new(), Vec::new(), Vec::new(), 0_usize);
    let (mut alarming, mut changes) = (0_usize, Vec::new());
    for key in keys {
        match (old.get(key), new.get(key)) {
            (Some(old), Some(new)) if old == new => unchanged += 1,
            (old, new) => {
                let of = old.zip(new).map_or_else(Vec::new, |(old, new)| Change::of(old, new));
                let is_worse = of.iter().any(|change| change.is_worse);
                let is_news = old.is_none_or(|old| is_worse || old.status.passes() && of.is_empty());
                alarming += usize::from(is_news && new.is_some_and(|row| !row.status.passes()));
                let told = (worst(&of), told(*key, old.copied(), new.copied(), &of));
                changes.extend(of);
                match (old, new) {
                    (None, _) => added.push(told),
                    (_, None) => removed.push(told),
                    _ => changed.push(told),
                }
            }
        }
    }
    changes.sort_by_key(|change| Reverse(change.class.severity()));
    // Worse pairs come first, the worst severity on top; pairs that are only better come last.
    let ordered = |mut told: Vec<(Rank, Value)>| {
        told.sort_by_key(|(rank, _)| Reverse(*rank));
        told.into_iter().map(|(_, told)| told).collect::<Vec<Value>>()
    };
    if args.format == Format::Json {
        let [added, removed, changed] = [added, removed, changed].map(ordered);
        say!("{}", json!({ "unchanged": unchanged, "added": added, "removed": removed, "changed": changed }));
    } else {
        let section = against(std::slice::from_ref(&now), std::slice::from_ref(&before)).map_err(Failure::usage)?;
        let blocks = section.blocks.into_iter().filter(|block| !matches!(block, Block::Plot { .. }));
        let section = Section { lead: String::new(), blocks: blocks.collect(), ..section };
        say!("## {} → {}", folders[0].display(), folders[1].display());
        for (title, is_worse) in [("❌ Worse", true), ("✅ Better", false)] {
            let of: Vec<&Change> = changes.iter().filter(|change| change.is_worse == is_worse).collect();
            if !of.is_empty() {
                say!("\n### {title}\n");
                of.iter().take(LINES).for_each(|change| say!("* `{change}`"));
            }
            if of.len() > LINES {
                say!("* and {} more", of.len() - LINES);
            }
        }
        say!("\n{}", section_markdown(&section).map_err(Failure::usage)?.trim());
    }
    Ok(if alarming > 0 { exit::UNEXPECTED } else { exit::OK })
}

fn pairs(run: &RunDir) -> BTreeMap<Key<'_>, &SummaryRow> {
    let rows = run.summary.iter();
    rows.map(|row| ([&*row.suite, &*row.scene, &*row.scene_id, &*row.task, &*row.backend], row)).collect()
}

fn worst(changes: &[Change]) -> Rank {
    [true, false].map(|is_worse| {
        changes.iter().filter(|change| change.is_worse == is_worse).map(|change| change.class.severity()).max()
    })
}

/// A pair with the classes whose counts differ, before and now, and the severities in which it is worse and better.
fn told(
    [suite, scene, scene_id, task, backend]: Key<'_>,
    old: Option<&SummaryRow>,
    new: Option<&SummaryRow>,
    changes: &[Change],
) -> Value {
    let count = |row: Option<&SummaryRow>, class| row.map_or(0, |row| row.count(class));
    let classes: serde_json::Map<String, Value> = Class::ALL
        .into_iter()
        .map(|class| (class, [count(old, class), count(new, class)]))
        .filter(|(_, [old, new])| old != new)
        .map(|(class, counts)| (class.name().to_owned(), json!(counts)))
        .collect();
    let status = |row: Option<&SummaryRow>| row.map(|row| row.status.name());
    let [worse, better] = worst(changes).map(|severity| severity.map(Severity::name));
    json!({
        "suite": suite, "scene": scene, "scene_id": scene_id, "task": task, "backend": backend,
        "status": [status(old), status(new)], "classes": classes, "worse": worse, "better": better,
    })
}
