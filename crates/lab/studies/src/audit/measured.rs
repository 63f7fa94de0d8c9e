//! The command line of the audit, and its measurements.

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

    /// Tolerances and drivers with a known fault instead; each must be found
    #[arg(long)]
    pub planted: bool,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// A row and its counts.
pub type Audited = (Row, Tally);

/// A row, a tolerance that its algorithm reads, and the results of the pairs at it.
pub type Read = (Row, Symbol, Reads);

/// A driver, a dimension, a precision, and the results of the scenes.
pub type Driven = (Driver, Dimension, Precision, Hierarchy);

/// All measurements of an audit.
#[derive(Clone, Default, Debug)]
pub struct Measured {
    /// The results of whole pairs, algorithm by algorithm.
    pub rows: Vec<Audited>,
    /// The results of single tests, tolerance by tolerance.
    pub reads: Vec<Read>,
    /// The results of drivers of the hierarchy.
    pub drivers: Vec<Driven>,
    /// The tolerances, compared with the published ones.
    pub constants: Vec<Constant>,
}
