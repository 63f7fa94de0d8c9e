//! The section about the sources of scenes.

use predicament_records::format::thousands;

use crate::table::{Block, Cell, Section, Table};

/// A source that scenes name.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Source {
    /// The text of the key `source`.
    pub text: String,
    /// The suites of its scenes.
    pub suites: Vec<String>,
    /// The number of its scenes.
    pub scenes: u64,
    /// True for the work of a suite's author or of this tool, false for a publication, a package or a bug report.
    pub is_own: bool,
}

/// The sources of scenes: each publication with its suites, and the scenes of the suites' authors in one row. `None` if
/// no scene names a source.
#[must_use]
pub fn sources(named: &[Source]) -> Option<Section> {
    if named.is_empty() {
        return None;
    }
    let (own, others): (Vec<&Source>, Vec<&Source>) = named.iter().partition(|source| source.is_own);
    let mut table = Table::new("Sources").words(["source", "suites"]).numbers(["scenes"]);
    let mut push = |text: &str, suites: &[String], scenes: u64| {
        table.push(vec![Cell::from(text), Cell::from(suites.join(", ")), Cell::from(thousands(scenes))]);
    };
    for source in others {
        push(&source.text, &source.suites, source.scenes);
    }
    if !own.is_empty() {
        let mut suites: Vec<String> = own.iter().flat_map(|source| source.suites.iter().cloned()).collect();
        suites.sort();
        suites.dedup();
        push(
            "the suites' authors, by hand, by generators or by search",
            &suites,
            own.iter().map(|one| one.scenes).sum(),
        );
    }
    Some(Section {
        id: "sources",
        title: "Sources of the scenes",
        lead: "The sources that the suites name for their scenes. `predicament setup cite --run RUN` prints them as \
             BibTeX."
            .to_owned(),
        blocks: vec![Block::Table(table)],
    })
}
