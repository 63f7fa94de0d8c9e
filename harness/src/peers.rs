//! Peers from crates.io, timed beside our own where the tool is built with
//! `--features peers`. Their answers are judged like everybody's.

use predicament_oracle::{Case, Stopwatch};

/// A peer at its starting line.
pub struct Peer<'a> {
    /// Its name in tables.
    pub name: String,
    /// The version that is linked in.
    pub version: String,
    /// The prepared work.
    pub watch: Box<dyn Stopwatch + 'a>,
    /// The digest of the answers that were judged.
    pub judged: u64,
    /// How many of them are not the exact ones.
    pub wrong: u64,
    /// The first of those, in words.
    pub first_wrong: Option<String>,
}

#[cfg(not(feature = "peers"))]
pub fn runners<'a>(_: &'a Case<'a>) -> Vec<Peer<'a>> {
    Vec::new()
}

#[cfg(feature = "peers")]
mod geo_locate;

#[cfg(feature = "peers")]
pub fn runners<'a>(case: &'a Case<'a>) -> Vec<Peer<'a>> {
    match case.truth() {
        predicament_oracle::Truth::Signs { .. } => Vec::new(),
        predicament_oracle::Truth::Locate(case) => geo_locate::peers(case),
    }
}
