//! Other crates, timed beside our own where the tool is built with
//! `--features peers`. Their answers are judged like everybody's.

#[cfg(feature = "peers")]
mod contacts;
#[cfg(feature = "peers")]
mod geo_locate;
#[cfg(feature = "peers")]
mod judged;
#[cfg(feature = "peers")]
mod libraries;
#[cfg(feature = "peers")]
mod located;
#[cfg(feature = "peers")]
mod predicate;
#[cfg(feature = "peers")]
mod signs;
#[cfg(feature = "peers")]
mod special;
#[cfg(feature = "peers")]
mod tables;

use predicament_records::Interface;
use predicament_tasks::{AnyCase, Outcome, Stopwatch};

/// Whether peers are linked in.
pub const ANY: bool = cfg!(feature = "peers");

/// A peer at its starting line.
pub struct Peer<'a> {
    /// Its name in tables.
    pub name: String,
    /// The version that is linked in.
    pub version: String,
    /// What became of its answers. It may have been asked fewer queries than
    /// the scene has: none that its documentation rules out.
    pub outcome: Outcome,
    /// The prepared work; none where it panicked.
    pub timed: Option<Timed<'a>>,
    /// What a reader has to be told: the first wrong answer in words, and what was not asked.
    pub remarks: Vec<String>,
}

/// Work that can be timed, and what its answers have to be.
pub struct Timed<'a> {
    /// The prepared work.
    pub watch: Box<dyn Stopwatch + 'a>,
    /// How the crate is asked.
    pub interface: Interface,
    /// The digest of the answers that were judged.
    pub judged: u64,
}

/// The crates that are linked in, with their versions.
#[cfg(not(feature = "peers"))]
pub const VERSIONS: &[(&str, &str)] = &[];

/// The crates that are linked in, with their versions.
#[cfg(feature = "peers")]
pub const VERSIONS: &[(&str, &str)] = &[
    ("axiolid-predicates", env!("PREDICAMENT_AXIOLID_PREDICATES")),
    ("delaunay", env!("PREDICAMENT_DELAUNAY")),
    ("geo", env!("PREDICAMENT_GEO")),
    ("geogram_predicates", env!("PREDICAMENT_GEOGRAM_PREDICATES")),
    ("geometry-predicates", env!("PREDICAMENT_GEOMETRY_PREDICATES")),
    ("hyperlimit", env!("PREDICAMENT_HYPERLIMIT")),
    ("rgeometry", env!("PREDICAMENT_RGEOMETRY")),
    ("rstar", env!("PREDICAMENT_RSTAR")),
    ("simplicity", env!("PREDICAMENT_SIMPLICITY")),
];

/// The peers that can answer the questions of a case.
#[cfg(not(feature = "peers"))]
pub fn runners(_: &dyn AnyCase) -> Vec<Peer<'_>> {
    Vec::new()
}

/// The peers that can answer the questions of a case.
#[cfg(feature = "peers")]
pub fn runners(case: &dyn AnyCase) -> Vec<Peer<'_>> {
    let signs = signs::peers(case).into_iter().chain(special::peers(case));
    signs.chain(geo_locate::peers(case)).chain(contacts::peers(case)).collect()
}

/// What a bench folder says about peers, as Markdown tables.
#[cfg(not(feature = "peers"))]
pub fn tables(_: &std::path::Path) -> Result<String, predicament_records::Error> {
    Ok(String::new())
}

#[cfg(feature = "peers")]
pub use tables::tables;
