//! What a report says, section by section; each is one file.

mod against;
mod counts;
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
mod speed;
mod stages;
mod throughput;
mod ties;

pub use against::against;
pub use headlines::headlines;

use crate::layout::{rank, run_head, run_label, some_of};
use crate::table::Section;
use crate::{Error, RunDir};

/// The sections of the first screen, which are never folded.
pub const FIRST: [&str; 4] = ["against", "heat", "glance", "compare"];
/// The other sections that are open at first.
pub const UNFOLDED: [&str; 2] = ["findings", "speed"];

/// All sections, in reading order; `of_tasks` are those of single tasks, and of the comparison of backends, which comes with the first.
pub fn sections(runs: &[RunDir], of_tasks: &[Section]) -> Result<Vec<Section>, Error> {
    let (first, of_tasks): (Vec<_>, Vec<_>) = of_tasks.iter().cloned().partition(|section| FIRST.contains(&section.id));
    let (mut sections, first): (Vec<_>, Vec<_>) = first.into_iter().partition(|section| section.id == "against");
    sections.extend([heat::section(runs), glance::section(runs)?]);
    sections.extend(first);
    sections.extend([findings::section(runs), run::section(runs), counts::section(runs)]);
    sections.extend(invariants::section(runs));
    sections.extend([speed::section(runs)?, throughput::section(runs)]);
    sections.extend(phases::section(runs)?);
    sections.extend([precision::section(runs), stages::section(runs), ties::section(runs)?]);
    sections.extend(of_tasks);
    sections.push(not_run::section(runs)?);
    sections.extend(maps::section(runs));
    Ok(sections)
}
