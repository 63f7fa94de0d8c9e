//! The command line of the audit, its survey and its rows.

use std::path::{Path, PathBuf};

use predicament_checks::audit::Verdict;
use predicament_tasks::Contestant;
use serde::Serialize;

use super::{Form, Row, Tally, audit, rows, table};
use crate::{Error, File, Host, Study};

/// The tolerance paper's algorithms at their thresholds, judged by exact distances.
#[derive(Clone, Debug, clap::Args)]
pub struct Audit {
    /// Decisions of each algorithm, precision and variant
    #[arg(long, default_value_t = 1_000_000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub decisions: u64,

    /// The seed of the pairs
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
}

/// A row and its counts.
pub type Audited = (Row, Tally);

impl Study for Audit {
    const NAME: &'static str = "audit";
    const ASKS: &'static str = "Hold the tolerance paper's algorithms to their guarantee by exact distances";
    const HELP: &'static str = "\
Pairs of simplices are made at the thresholds of the tolerances, with L between 2^-100 and 2^100
(2^-12 and 2^16 for f32). A pair of which no sub-pair is registered is a decision, and is judged
by exact distances: registered up to T-, not registered beyond T+, guarded quantities above their
bounds, weights in [0, 1]. As a second variant, Algorithms 3 and 8 are those that the paper
prints, and the others rest on them.

Written to the folder: audit.csv, audit.md (the table that is printed).

Exit code 100 if an algorithm that is not as printed breaks the guarantee.

Examples:
  predicament audit
  predicament audit --decisions 10000 --seed 2 --out target/audit";

    type Measured = Vec<Audited>;

    fn out(&self) -> Option<&Path> {
        self.out.as_deref()
    }

    fn survey(&self, _: &[&dyn Contestant], host: &dyn Host) -> Result<Vec<Audited>, Error> {
        let rows = rows();
        host.begin(rows.len() as u64 * self.decisions, "decisions");
        let one = |row: Row| {
            host.turn_to(&format!("Algorithm {} {} {}", row.algorithm.number(), row.precision.name(), row.variant()));
            Ok((row, audit(row, self.decisions, self.seed, host.watch())?))
        };
        rows.into_iter().map(one).collect()
    }

    fn rows(&self, measured: &Vec<Audited>) -> Result<Vec<File>, Error> {
        Ok(vec![File::csv("audit.csv", measured.iter().map(Record::of))?])
    }

    fn page(&self, measured: &Vec<Audited>) -> String {
        table::page(self, measured)
    }

    fn holds(&self, measured: &Vec<Audited>) -> bool {
        measured.iter().all(|(row, tally)| row.form == Form::AsPrinted || tally.violations() == 0)
    }
}

/// The columns of a row.
#[derive(Serialize)]
pub(super) struct Record {
    pub algorithm: u8,
    pub dimension: usize,
    pub pair: &'static str,
    pub ranks: String,
    pub precision: &'static str,
    pub variant: &'static str,
    pub decisions: u64,
    pub ended: u64,
    pub registered: u64,
    pub not_registered: u64,
    pub near: u64,
    pub agree: u64,
    pub in_band: u64,
    pub overreach: u64,
    pub missed: u64,
    pub unguarded: u64,
    pub bad_weight: u64,
    pub weight_error: f64,
    pub least_guard: Option<f64>,
}

impl Record {
    pub(super) fn of((row, tally): &Audited) -> Record {
        let Row { algorithm, precision, .. } = *row;
        let [first, second] = algorithm.kind.ranks();
        Record {
            algorithm: algorithm.number(),
            dimension: algorithm.dimension.count(),
            pair: algorithm.kind.name(),
            ranks: format!("{first} {second}"),
            precision: precision.name(),
            variant: row.variant(),
            decisions: tally.decisions(),
            ended: tally.ended,
            registered: tally.registered,
            not_registered: tally.decisions() - tally.registered,
            near: tally.near,
            agree: tally.count(Verdict::Agree),
            in_band: tally.count(Verdict::InBand),
            overreach: tally.count(Verdict::Overreach),
            missed: tally.count(Verdict::Missed),
            unguarded: tally.count(Verdict::Unguarded),
            bad_weight: tally.count(Verdict::BadWeight),
            weight_error: tally.weight_error,
            least_guard: tally.room,
        }
    }
}
