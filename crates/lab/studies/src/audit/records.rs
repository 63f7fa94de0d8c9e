//! The columns of the tables of an audit.

use predicament_contacts::checks::audit::Verdict;
use serde::Serialize;

use super::measured::{Audited, Driven, Read};
use super::{Constant, Row};

/// The columns of a tolerance that an algorithm reads.
#[derive(Serialize)]
pub(super) struct ReadRecord {
    pub algorithm: u8,
    pub dimension: usize,
    pub pair: &'static str,
    pub precision: &'static str,
    pub variant: &'static str,
    pub reads: &'static str,
    pub asked: u64,
    pub registered: u64,
    pub lower_within: u64,
    pub lower_beyond: u64,
    pub width_within: u64,
    pub width_beyond: u64,
    pub upper_within: u64,
    pub upper_beyond: u64,
    pub misread: u64,
}

impl ReadRecord {
    pub(super) fn of((row, symbol, reads): &Read) -> ReadRecord {
        let Row { algorithm, precision, .. } = *row;
        let [[lower_within, lower_beyond], [width_within, width_beyond], [upper_within, upper_beyond]] = reads.hits;
        ReadRecord {
            algorithm: algorithm.number(),
            dimension: algorithm.dimension.count(),
            pair: algorithm.kind.name(),
            precision: precision.name(),
            variant: row.variant(),
            reads: symbol.name(),
            asked: reads.asked,
            registered: reads.registered,
            lower_within,
            lower_beyond,
            width_within,
            width_beyond,
            upper_within,
            upper_beyond,
            misread: reads.misread,
        }
    }
}

/// The columns of a constant.
#[derive(Serialize)]
pub(super) struct ConstantRecord {
    pub dimension: usize,
    pub precision: &'static str,
    pub variant: &'static str,
    pub tolerance: &'static str,
    pub lower: f64,
    pub width: f64,
    pub upper: f64,
    pub is_published: bool,
}

impl ConstantRecord {
    pub(super) fn of(constant: &Constant) -> ConstantRecord {
        let [lower, width, upper] = constant.quotients;
        ConstantRecord {
            dimension: constant.dimension.count(),
            precision: constant.precision.name(),
            variant: constant.form.name(),
            tolerance: constant.symbol.name(),
            lower,
            width,
            upper,
            is_published: constant.is_published(),
        }
    }
}

/// The columns of a driver.
#[derive(Serialize)]
pub(super) struct DriverRecord {
    pub dimension: usize,
    pub precision: &'static str,
    pub driver: &'static str,
    pub scenes: u64,
    pub registered: u64,
    pub ended: u64,
    pub agree: u64,
    pub in_band: u64,
    pub overreach: u64,
    pub missed: u64,
    pub unguarded: u64,
    pub bad_weight: u64,
    pub unasked: u64,
    pub misread: u64,
}

impl DriverRecord {
    pub(super) fn of((driver, dimension, precision, found): &Driven) -> DriverRecord {
        let [agree, in_band, overreach, missed, unguarded, bad_weight, unasked, misread] =
            Verdict::ALL.map(|verdict| found.count(verdict));
        DriverRecord {
            dimension: dimension.count(),
            precision: precision.name(),
            driver: driver.name(),
            scenes: found.scenes,
            registered: found.registered,
            ended: found.ended,
            agree,
            in_band,
            overreach,
            missed,
            unguarded,
            bad_weight,
            unasked,
            misread,
        }
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
    pub misread: u64,
    pub weight_error: f64,
    pub least_guard: Option<f64>,
}

impl Record {
    pub(super) fn of((row, tally): &Audited) -> Record {
        let Row { algorithm, precision, .. } = *row;
        let [first, second] = algorithm.kind.ranks();
        let [agree, in_band, overreach, missed, unguarded, bad_weight, _, misread] =
            Verdict::ALL.map(|verdict| tally.count(verdict));
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
            agree,
            in_band,
            overreach,
            missed,
            unguarded,
            bad_weight,
            misread,
            weight_error: tally.weight_error,
            least_guard: tally.room,
        }
    }
}
