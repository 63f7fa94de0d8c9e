//! `diff`: what changed from one run to another, as Markdown for a comment or as JSON for a script.

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use predicament_records::{RunDir, SummaryRow};
use predicament_report::{Block, Section, against, section_markdown};
use predicament_tasks::Class;
use serde_json::{Value, json};

use crate::exit::{self, Failure};

const EXAMPLES: &str = "\
A scene on a backend has changed if a count of any class or its status has. Times, where both folders have some, are
shown with their intervals and decide nothing: `gate --baseline` does that. Code 100 where something that changed or
was added is not as expected, 0 otherwise.

Examples:
  predicament diff out/main out/branch > comment.md
  predicament diff out/main out/branch --json | jq .changed
  predicament report out/branch --against out/main --out out/report    the same as a page, with plots";

/// Show what changed from one run to another
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The earlier run
    pub before: PathBuf,

    /// The later one
    pub now: PathBuf,

    /// Print one JSON object: the pairs of scene and backend that were added, removed and changed, with their counts
    #[arg(long)]
    pub json: bool,
}

type Key<'r> = [&'r str; 5];

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    let [before, now] = [&args.before, &args.now].map(RunDir::open);
    let (before, now) = (before.map_err(Failure::usage)?, now.map_err(Failure::usage)?);
    let [old, new] = [&before, &now].map(pairs);
    let keys: BTreeSet<&Key<'_>> = old.keys().chain(new.keys()).collect();
    let (mut added, mut removed, mut changed, mut unchanged) = (Vec::new(), Vec::new(), Vec::new(), 0_usize);
    let mut alarming = 0_usize;
    for key in keys {
        match (old.get(key), new.get(key)) {
            (Some(old), Some(new)) if old == new => unchanged += 1,
            (old, new) => {
                alarming += usize::from(new.is_some_and(|row| !row.status.passes()));
                let told = told(*key, old.copied(), new.copied());
                match (old, new) {
                    (None, _) => added.push(told),
                    (_, None) => removed.push(told),
                    _ => changed.push(told),
                }
            }
        }
    }
    if args.json {
        say!("{}", json!({ "unchanged": unchanged, "added": added, "removed": removed, "changed": changed }));
    } else {
        let section = against(std::slice::from_ref(&now), std::slice::from_ref(&before)).map_err(Failure::usage)?;
        let blocks = section.blocks.into_iter().filter(|block| !matches!(block, Block::Plot { .. }));
        let section = Section { lead: String::new(), blocks: blocks.collect(), ..section };
        say!("## {} → {}", args.before.display(), args.now.display());
        say!("\n{}", section_markdown(&section).map_err(Failure::usage)?.trim());
    }
    Ok(if alarming > 0 { exit::UNEXPECTED } else { exit::OK })
}

fn pairs(run: &RunDir) -> BTreeMap<Key<'_>, &SummaryRow> {
    let rows = run.summary.iter();
    rows.map(|row| ([&*row.suite, &*row.scene, &*row.scene_id, &*row.task, &*row.backend], row)).collect()
}

/// A pair with the classes whose counts differ, before and now.
fn told([suite, scene, scene_id, task, backend]: Key<'_>, old: Option<&SummaryRow>, new: Option<&SummaryRow>) -> Value {
    let count = |row: Option<&SummaryRow>, class| row.map_or(0, |row| row.count(class));
    let classes: serde_json::Map<String, Value> = Class::ALL
        .into_iter()
        .map(|class| (class, [count(old, class), count(new, class)]))
        .filter(|(_, [old, new])| old != new)
        .map(|(class, counts)| (class.name().to_owned(), json!(counts)))
        .collect();
    let status = |row: Option<&SummaryRow>| row.map(|row| row.status.name());
    json!({
        "suite": suite, "scene": scene, "scene_id": scene_id, "task": task, "backend": backend,
        "status": [status(old), status(new)], "classes": classes,
    })
}
