//! What a report says, section by section; each is one file.

mod counts;
mod findings;
mod glance;
mod headlines;
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

pub use headlines::headlines;

use crate::layout::{rank, run_head, run_label, some_of};
use crate::table::Section;
use crate::{Error, RunDir};

/// All sections, in reading order; `of_tasks` are those of single tasks.
pub fn sections(runs: &[RunDir], of_tasks: &[Section]) -> Result<Vec<Section>, Error> {
    let mut sections = vec![glance::section(runs), run::section(runs), counts::section(runs), findings::section(runs)];
    sections.extend(invariants::section(runs));
    sections.extend([speed::section(runs)?, throughput::section(runs)]);
    sections.extend(phases::section(runs)?);
    sections.extend([precision::section(runs), stages::section(runs), ties::section(runs)?]);
    sections.extend_from_slice(of_tasks);
    sections.push(not_run::section(runs)?);
    sections.extend(maps::section(runs));
    Ok(sections)
}
