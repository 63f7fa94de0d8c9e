//! The sections of a report; each is one file.

mod against;
mod counts;
mod decimals;
mod findings;
mod glance;
mod headlines;
mod heat;
mod invariants;
mod maps;
mod not_run;
mod phases;
mod precision;
mod run;
mod sources;
mod speed;
mod stages;
mod throughput;
mod ties;

pub use against::against;
pub use glance::ranking;
pub use headlines::headlines;
pub use sources::{Source, sources};

use crate::groups::Times;
use crate::layout::{rank, run_head, run_label, some_of};
use crate::table::Section;
use crate::table::{Block, Tone};
use crate::{Error, RunDir};

/// The sections of the first screen, which are never folded.
pub const FIRST: [&str; 6] = ["against", "glance", "heat", "tradeoff", "which", "compare"];
/// The other sections that are open at first.
pub const UNFOLDED: [&str; 2] = ["findings", "speed"];

/// All sections, in reading order. `of_tasks` are the sections of single tasks, and of the comparison of backends,
/// which comes among the first. An empty section is left out, and listed at the end.
pub fn sections(runs: &[RunDir], of_tasks: &[Section]) -> Result<Vec<Section>, Error> {
    let times = Times::of(runs);
    let (mut first, of_tasks): (Vec<_>, Vec<_>) =
        of_tasks.iter().cloned().partition(|section| FIRST.contains(&section.id));
    first.extend([glance::section(runs, &times), heat::section(runs)]);
    first.extend(glance::drawn(runs, &times)?);
    first.sort_by_key(|section| FIRST.iter().position(|id| *id == section.id));
    let mut empty = Vec::new();
    let mut rest: Vec<Section> = [
        ("Findings", findings::section(runs)),
        ("What was run", Some(run::section(runs))),
        ("Answers by class", Some(counts::section(runs))),
        ("Broken invariants", invariants::section(runs)),
        ("Speed against error", speed::section(runs, &times)?),
        ("Throughput", throughput::section(runs)),
        ("Phases", phases::section(runs)?),
        ("Precision plans", precision::section(runs)),
        ("Stages", stages::section(runs)),
        ("Ties", ties::section(runs, &times)?),
    ]
    .into_iter()
    .filter_map(|(title, section)| {
        if section.is_none() {
            empty.push(title);
        }
        section
    })
    .collect();
    // A section with only notes says that its task was not asked.
    let (silent, of_tasks): (Vec<_>, Vec<_>) =
        of_tasks.into_iter().partition(|section| section.blocks.iter().all(|block| matches!(block, Block::Note(..))));
    empty.extend(silent.iter().map(|section| section.title));
    rest.extend(of_tasks);
    rest.extend(decimals::section(runs)?);
    let mut last = not_run::section(runs)?;
    if !empty.is_empty() {
        let note = format!("Sections with nothing to show, which are left out: {}.", empty.join(", "));
        last.blocks.push(Block::Note(note, Tone::Muted));
    }
    Ok(first.into_iter().chain(rest).chain([last]).chain(maps::section(runs)).collect())
}
