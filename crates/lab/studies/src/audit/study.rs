//! The survey of the audit and its rows.

use predicament_contacts::checks::audit::Symbol;
use predicament_contacts::task::thresholds;
use predicament_predicates::Dimension;
use predicament_tasks::Contestant;
use predicament_tolerance::Misscaled;

use super::measured::{Audit, Audited, Driven, Measured, Read};
use super::records::{ConstantRecord, DriverRecord, ReadRecord, Record};
use super::{Algorithm, Constant, Driver, Form, Row, audit, constants, hierarchy, read, rows, table};
use crate::{Common, Error, File, Host, Precision, Study};

/// The number of decisions per pair at each tolerance.
const READS: u64 = 10;
/// The number of decisions per scene of the hierarchy.
const SCENES: u64 = 50;

impl Audit {
    fn read_rows(&self) -> Vec<(Row, Symbol)> {
        let forms: Vec<Form> = match self.planted {
            false => vec![Form::Corrected],
            true => Misscaled::visible().map(Form::Misscaled).collect(),
        };
        let rows = forms.into_iter().flat_map(|form| {
            Algorithm::all().flat_map(move |algorithm| {
                Precision::ALL.into_iter().map(move |precision| Row { algorithm, precision, form })
            })
        });
        let with = |row: Row| {
            let symbols = thresholds::reads(row.algorithm.kind, row.algorithm.dimension).iter();
            symbols.filter(move |symbol| row.concerns(**symbol)).map(move |&symbol| (row, symbol))
        };
        rows.flat_map(with).collect()
    }

    fn constants(&self) -> Vec<Constant> {
        match self.planted {
            false => constants(Form::Corrected),
            true => Misscaled::ALL.into_iter().flat_map(|misscaled| constants(Form::Misscaled(misscaled))).collect(),
        }
    }

    fn drivers(&self) -> Vec<(Driver, Dimension, Precision)> {
        let drivers = if self.planted { Driver::PLANTED.to_vec() } else { vec![Driver::Honest] };
        let dimensions = [Dimension::Two, Dimension::Three];
        let of =
            |driver| dimensions.into_iter().flat_map(move |d| Precision::ALL.into_iter().map(move |p| (driver, d, p)));
        drivers.into_iter().flat_map(of).collect()
    }
}

impl Study for Audit {
    const NAME: &'static str = "audit";
    const ASKS: &'static str = "Check the tolerance paper's algorithms against their guarantee, by exact distances";
    const HELP: &'static str = "\
Pairs of simplices are made at the thresholds of the tolerances, with L between 2^-100 and 2^100 (2^-12 and 2^16 for \
f32). A pair without a registered sub-pair is a decision. Exact distances judge it: it must be registered up to T-, \
and must not be registered beyond T+; guarded quantities must be above their bounds, and weights in [0, 1]. In a \
second variant, Algorithms 3 and 8 are those that the paper prints, and the other algorithms use them.

Each tolerance that an algorithm reads also has its own pairs, a tenth as many. They are queried whatever their \
sub-pairs are, so that each test is checked alone. The driver of the hierarchy is checked against the guarantee on \
scenes of one pair, a fiftieth as many.

Everything is checked against the tolerances that the paper publishes, and so are the tolerances themselves. With \
--planted the study audits tolerances that are twice or half of the correct values, and drivers with a known fault; \
it has to find each of them.

Files in the folder: audit.csv, reads.csv, hierarchy.csv, constants.csv, audit.md (the printed tables).

Exit code 100 if an algorithm other than a printed one breaks the guarantee; with --planted, if a fault does not.

Examples:
  predicament study audit
  predicament study audit --decisions 10000 --seed 2 --out target/audit
  predicament study audit --decisions 10000 --planted";

    type Measured = Measured;

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, _: &[&dyn Contestant], host: &dyn Host) -> Result<Measured, Error> {
        let rows = if self.planted { Vec::new() } else { rows() };
        let (reads, drivers) = (self.read_rows(), self.drivers());
        let [pairs, scenes] = [READS, SCENES].map(|part| self.decisions.div_ceil(part));
        let all = rows.len() as u64 * self.decisions + reads.len() as u64 * pairs + drivers.len() as u64 * scenes;
        host.begin(all, "decisions");
        let name =
            |row: Row| format!("Algorithm {} {} {}", row.algorithm.number(), row.precision.name(), row.variant());
        let one = |row: Row| -> Result<Audited, Error> {
            host.turn_to(&name(row));
            Ok((row, audit(row, self.decisions, self.common.seed, host.watch())?))
        };
        let rows = rows.into_iter().map(one).collect::<Result<_, _>>()?;
        let one = |(row, symbol): (Row, Symbol)| -> Result<Read, Error> {
            host.turn_to(&format!("{} {}", name(row), symbol.name()));
            Ok((row, symbol, read(row, symbol, pairs, self.common.seed, host.watch())?))
        };
        let reads = reads.into_iter().map(one).collect::<Result<_, _>>()?;
        let one = |(driver, dimension, precision): (Driver, Dimension, Precision)| -> Result<Driven, Error> {
            host.turn_to(&format!("hierarchy {}D {} {}", dimension.count(), precision.name(), driver.name()));
            Ok((
                driver,
                dimension,
                precision,
                hierarchy(driver, dimension, precision, scenes, self.common.seed, host.watch())?,
            ))
        };
        let drivers = drivers.into_iter().map(one).collect::<Result<_, _>>()?;
        Ok(Measured { rows, reads, drivers, constants: self.constants() })
    }

    fn rows(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        Ok(vec![
            File::csv("audit.csv", measured.rows.iter().map(Record::of))?,
            File::csv("reads.csv", measured.reads.iter().map(ReadRecord::of))?,
            File::csv("hierarchy.csv", measured.drivers.iter().map(DriverRecord::of))?,
            File::csv("constants.csv", measured.constants.iter().map(ConstantRecord::of))?,
        ])
    }

    fn page(&self, measured: &Measured) -> String {
        table::page(self, measured)
    }

    fn holds(&self, measured: &Measured) -> bool {
        let is_found = |violations: u64| (violations > 0) == self.planted;
        measured.rows.iter().all(|(row, tally)| row.form == Form::AsPrinted || tally.violations() == 0)
            && measured.reads.iter().all(|(.., reads)| is_found(reads.misread))
            && measured.drivers.iter().all(|(.., found)| is_found(found.violations()))
            && measured.constants.iter().all(|constant| constant.is_published() != self.planted)
    }
}
