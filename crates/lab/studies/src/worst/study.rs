//! The command line of the search, its survey and its page.

use std::fmt::Write as _;

use predicament_tasks::Contestant;
use serde::Serialize;

use super::{Guard, Observed, errors, guards};
use crate::{Common, Error, File, Host, Precision, Study};

/// The bounds of the tolerance paper against the worst inputs that a search finds.
#[derive(Clone, Debug, clap::Args)]
pub struct Worst {
    /// Steps of each climb
    #[arg(long, default_value_t = 4000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub steps: u64,

    /// Climbs for each bound
    #[arg(long, default_value_t = 6, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub climbs: u64,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The number of bounds: 60 errors and 8 guards, in both precisions.
const BOUNDS: u64 = 2 * (60 + 8);

/// The results of the search.
#[derive(Clone, Default, Debug)]
pub struct Found {
    /// The largest errors found.
    pub errors: Vec<Observed>,
    /// The least guards found.
    pub guards: Vec<Guard>,
}

impl Study for Worst {
    const NAME: &'static str = "worst";
    const ASKS: &'static str = "Search for the inputs that come nearest to the bounds of the tolerance paper";
    const HELP: &'static str = "\
The search climbs: from a random start it changes one thing at a time, and keeps a change if the value is not lower. \
It climbs towards two kinds of bounds:

Errors of the results of Algorithms 1 to 12, in double and in single precision, compared with rationals (roots are \
enclosed to 2^-192). The study `bounds` derives the bounds. It charges every operation with epsilon, but \
rounding to nearest loses at most half of that, so half of a bound can be reached.

Guards: quantities that the paper bounds from below if no sub-pair is within its T-, divided by their bounds, with \
exact distances.

Files in the folder: errors.csv, guards.csv, worst.md (the printed tables).

Exit code 100 if an error exceeds its bound or a guarded quantity is below its bound.

Examples:
  predicament study worst
  predicament study worst --steps 200 --climbs 2 --out target/worst";

    type Measured = Found;

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, _: &[&dyn Contestant], host: &dyn Host) -> Result<Found, Error> {
        let effort = [self.climbs, self.steps];
        host.begin(BOUNDS, "bounds");
        host.turn_to("errors");
        let errors = errors(effort, self.common.seed, host.watch())?;
        host.turn_to("guards");
        let guards = guards(effort, self.common.seed, host.watch())?;
        Ok(Found { errors, guards })
    }

    fn rows(&self, found: &Found) -> Result<Vec<File>, Error> {
        Ok(vec![
            File::csv("errors.csv", found.errors.iter().map(ErrorRow::of))?,
            File::csv("guards.csv", found.guards.iter().map(GuardRow::of))?,
        ])
    }

    fn page(&self, found: &Found) -> String {
        let Worst { steps, climbs, common: Common { seed, .. } } = self;
        let mut page = format!("`predicament study worst --steps {steps} --climbs {climbs} --seed {seed}`\n\n");
        page += "| Algorithm | section | bound | derived | f64 | f64 / bound | f32 | f32 / bound |\n";
        page += "|---|---|---|---:|---:|---:|---:|---:|\n";
        for double in found.errors.iter().filter(|row| row.precision == Precision::Double) {
            let is_single = |row: &&Observed| {
                (row.section, &row.name, row.precision) == (double.section, &double.name, Precision::Single)
            };
            let Some(single) = found.errors.iter().find(is_single) else { continue };
            let _ = writeln!(
                page,
                "| {} | {} | {} | {:.2} | {:.2} | {:.2} | {:.2} | {:.2} |",
                double.algorithm,
                double.section,
                double.name,
                double.derived,
                double.observed,
                double.share(),
                single.observed,
                single.share(),
            );
        }
        page += "\nThe bound and the largest error found, both divided by ε. Errors are relative to the value itself for R, \
                 and to L^p for E.\n\n";
        page += "| Algorithm | f64 | f32 |\n|---|---:|---:|\n";
        for double in found.guards.iter().filter(|row| row.precision == Precision::Double) {
            let is_single = |row: &&Guard| (row.algorithm, row.precision) == (double.algorithm, Precision::Single);
            let Some(single) = found.guards.iter().find(is_single) else { continue };
            let (number, name) = (double.algorithm.number(), double.algorithm.kind.name());
            let _ = writeln!(page, "| {number} {name} | {:.3} | {:.3} |", double.least, single.least);
        }
        page + "\nThe least guard: the smallest ratio found of a guarded quantity to its lower bound, over pairs that \
                cross or are within T₊ and have no sub-pair within T₋.\n"
    }

    /// A guard comes from rounded quotients: some 2⁻⁴⁰ of it is not a violation.
    fn holds(&self, found: &Found) -> bool {
        found.errors.iter().all(|row| row.share() <= 1.0) && found.guards.iter().all(|row| row.least >= 1.0 - 1e-12)
    }
}

/// The columns of an error.
#[derive(Serialize)]
struct ErrorRow<'a> {
    algorithm: u8,
    section: &'static str,
    bound: &'a str,
    precision: &'static str,
    derived: f64,
    observed: f64,
    share: f64,
}

impl<'a> ErrorRow<'a> {
    fn of(row: &'a Observed) -> ErrorRow<'a> {
        ErrorRow {
            algorithm: row.algorithm,
            section: row.section,
            bound: &row.name,
            precision: row.precision.name(),
            derived: row.derived,
            observed: row.observed,
            share: row.share(),
        }
    }
}

/// The columns of a guard.
#[derive(Serialize)]
struct GuardRow {
    algorithm: u8,
    pair: &'static str,
    precision: &'static str,
    least: f64,
    vertices: String,
}

impl GuardRow {
    fn of(row: &Guard) -> GuardRow {
        let vertices = row.pair.iter().flatten().map(|[x, y, z]| format!("{x:e} {y:e} {z:e}"));
        GuardRow {
            algorithm: row.algorithm.number(),
            pair: row.algorithm.kind.name(),
            precision: row.precision.name(),
            least: row.least,
            vertices: vertices.collect::<Vec<_>>().join("; "),
        }
    }
}
