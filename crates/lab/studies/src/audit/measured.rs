//! The command line of the audit, and what it measures.

use predicament_contacts::checks::audit::Symbol;
use predicament_predicates::Dimension;

use super::{Constant, Driver, Hierarchy, Reads, Row, Tally};
use crate::{Common, Precision};

/// The tolerance paper's algorithms at their thresholds, judged by exact distances.
#[derive(Clone, Debug, clap::Args)]
pub struct Audit {
    /// Decisions of each algorithm, precision and variant
    #[arg(long, default_value_t = 1_000_000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub decisions: u64,

    /// Tolerances and drivers with a known fault instead; each has to be found
    #[arg(long)]
    pub planted: bool,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// A row and its counts.
pub type Audited = (Row, Tally);

/// A row, a tolerance that its algorithm reads, and what became of the pairs at it.
pub type Read = (Row, Symbol, Reads);

/// A driver, a dimension, a precision, and what became of the scenes.
pub type Driven = (Driver, Dimension, Precision, Hierarchy);

/// All that an audit measures.
#[derive(Clone, Default, Debug)]
pub struct Measured {
    /// Whole pairs, algorithm by algorithm.
    pub rows: Vec<Audited>,
    /// Single tests, tolerance by tolerance.
    pub reads: Vec<Read>,
    /// Drivers of the hierarchy.
    pub drivers: Vec<Driven>,
    /// The tolerances themselves.
    pub constants: Vec<Constant>,
}
