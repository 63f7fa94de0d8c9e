//! What a report says, section by section; each is one file.

mod contacts;
mod counts;
mod findings;
mod headlines;
mod locate;
mod maps;
mod masses;
mod not_run;
mod precision;
mod run;
mod speed;
mod stages;
mod throughput;
mod ties;

pub use headlines::headlines;

use crate::table::{Cell, Section};
use crate::{Error, RunDir};

/// All sections, in reading order.
pub fn sections(runs: &[RunDir]) -> Result<Vec<Section>, Error> {
    let mut sections = vec![
        run::section(runs),
        counts::section(runs),
        findings::section(runs),
        speed::section(runs)?,
        throughput::section(runs),
        precision::section(runs),
        stages::section(runs),
        ties::section(runs)?,
        locate::section(runs),
        contacts::section(runs),
        masses::section(runs),
        not_run::section(runs),
    ];
    sections.extend(maps::section(runs));
    Ok(sections)
}

/// The number of a run, where there is more than one to tell apart.
fn run_label(runs: &[RunDir], index: usize) -> Option<Cell> {
    (runs.len() > 1).then(|| Cell::from((index + 1).to_string()))
}

/// The head of the column that holds [`run_label`].
fn run_head(runs: &[RunDir]) -> Option<&'static str> {
    (runs.len() > 1).then_some("run")
}

/// The place of a backend in the order of the plans.
fn rank(order: &[&str], backend: &str) -> usize {
    order.iter().position(|b| *b == backend).unwrap_or(order.len())
}

/// The first few names, and how many more there are.
fn some_of<'n>(names: impl ExactSizeIterator<Item = &'n str>, few: usize) -> String {
    let more = names.len().saturating_sub(few);
    let mut text = names.take(few).collect::<Vec<_>>().join(", ");
    if more > 0 {
        text += &format!(" and {more} more");
    }
    text
}
