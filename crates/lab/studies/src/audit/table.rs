//! The page of an audit: decisions and violations of each algorithm, as Markdown.

use std::fmt::Write as _;

use super::measured::{Audited, Measured, Read};
use super::records::{ConstantRecord, DriverRecord, ReadRecord, Record};
use super::{Audit, Row, Violation};

/// The tables, and the first violation of each row that has any.
pub(super) fn page(audit: &Audit, measured: &Measured) -> String {
    let planted = if audit.planted { " --planted" } else { "" };
    let mut page =
        format!("`predicament study audit --decisions {} --seed {}{planted}`\n\n", audit.decisions, audit.common.seed);
    if !audit.planted {
        page += &whole_pairs(&measured.rows);
        page += "\n";
    }
    page += &single_tests(&measured.reads);
    page += "\n";
    page += &drivers(measured);
    page += "\n";
    page += &constants(measured);
    let of_rows = measured.rows.iter().filter_map(|(row, tally)| Some((row, tally.first.as_ref()?)));
    let of_reads = measured.reads.iter().filter_map(|(row, _, reads)| Some((row, reads.first.as_ref()?)));
    page + &firsts(of_rows.chain(of_reads))
}

/// The table of each algorithm on pairs without a registered sub-pair.
fn whole_pairs(audited: &[Audited]) -> String {
    let mut page = String::new();
    page += "| Algorithm | precision | variant | decisions | ended | registered | not | near | agree | in band \
             | overreach | missed | unguarded | bad weight | misread | weight error | least guard |\n";
    page += "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for row in audited {
        let Record { algorithm, pair, ranks, precision, variant, decisions, ended, registered, .. } = Record::of(row);
        let Record { not_registered, near, agree, in_band, overreach, missed, unguarded, .. } = Record::of(row);
        let Record { bad_weight, misread, weight_error, least_guard, .. } = Record::of(row);
        #[allow(clippy::cast_precision_loss)] // a share for display
        let near = format!("{:.1} %", near as f64 / decisions as f64 * 100.0);
        let guard = least_guard.map_or_else(|| "-".to_owned(), |guard| format!("{guard:.3}"));
        let _ = writeln!(
            page,
            "| {algorithm} {pair} ({ranks}) | {precision} | {variant} | {decisions} | {ended} | \
             {registered} | {not_registered} | {near} | {agree} | {in_band} | {overreach} | {missed} | {unguarded} | {bad_weight} | \
             {misread} | {weight_error:.1e} | {guard} |",
        );
    }
    page += "\nEnded: pairs with a registered sub-pair, which are not decisions. Near: decisions with a distance within \
             2^-20 of T- or T+; the distance of the pair or, if the pair has no tolerance, of a facet. \
             Least guard: the smallest ratio of a guarded quantity to its lower bound, over registered pairs.\n";
    page
}

/// The table of each algorithm on pairs at each tolerance that it reads.
fn single_tests(reads: &[Read]) -> String {
    let mut page = "| Algorithm | precision | variant | reads | asked | registered | T- within | beyond | T within \
                    | beyond | T+ within | beyond | misread |\n"
        .to_owned();
    page += "|---|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for row in reads {
        let ReadRecord { algorithm, pair, precision, variant, reads, asked, registered, misread, .. } =
            ReadRecord::of(row);
        let hits = row.2.hits.as_flattened().iter().map(u64::to_string).collect::<Vec<_>>().join(" | ");
        let _ = writeln!(
            page,
            "| {algorithm} {pair} | {precision} | {variant} | {reads} | {asked} | {registered} | {hits} | {misread} |"
        );
    }
    page += "\nPairs at a tolerance, queried whatever their sub-pairs are. Within and beyond: values at most 2^-10 below \
             or above T-, T or T+. Misread: a pair was registered although a test must fail, or not registered although \
             all tests must pass.\n";
    page
}

/// The table of the tolerances and their ratios to the published ones.
fn constants(measured: &Measured) -> String {
    let mut page = "| figure | precision | variant | tolerance | T- | T | T+ | as published |\n".to_owned();
    page += "|---|---|---|---|---:|---:|---:|---|\n";
    for constant in &measured.constants {
        let ConstantRecord { dimension, precision, variant, tolerance, lower, width, upper, is_published } =
            ConstantRecord::of(constant);
        let figure = if dimension == 2 { 1 } else { 5 };
        let said = if is_published { "yes" } else { "no" };
        let _ = writeln!(
            page,
            "| {figure} | {precision} | {variant} | {tolerance} | {lower:.6} | {width:.6} | {upper:.6} | {said} |"
        );
    }
    page += "\nT-, T and T+ divided by the published values, for the one of 16 lengths L where the ratios are furthest \
             from 1. As published: the ratios are within 2^-20 of 1.\n";
    page
}

/// The table of the hierarchy's drivers.
fn drivers(measured: &Measured) -> String {
    let mut page = "| space | precision | driver | scenes | registered | ended | agree | in band | overreach | missed \
                    | unguarded | bad weight | unasked | misread |\n"
        .to_owned();
    page += "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for row in &measured.drivers {
        let DriverRecord { dimension, precision, driver, scenes, registered, ended, .. } = DriverRecord::of(row);
        let DriverRecord { agree, in_band, overreach, missed, unguarded, .. } = DriverRecord::of(row);
        let DriverRecord { bad_weight, unasked, misread, .. } = DriverRecord::of(row);
        let _ = writeln!(
            page,
            "| {dimension}D | {precision} | {driver} | {scenes} | {registered} | {ended} | {agree} | {in_band} | \
             {overreach} | {missed} | {unguarded} | {bad_weight} | {unasked} | {misread} |"
        );
    }
    page += "\nThe driver of the hierarchy answers scenes of one pair and its faces.\n";
    page
}

/// The first decision of each row that broke the guarantee.
fn firsts<'a>(first: impl Iterator<Item = (&'a Row, &'a Violation)>) -> String {
    let mut page = String::new();
    for (at, (row, violation)) in first.enumerate() {
        if at == 0 {
            page += "\nThe first decision of each row that breaks the guarantee:\n\n";
            page += "| Algorithm | precision | variant | | L | distance over L | first | second |\n";
            page += "|---|---|---|---|---:|---:|---|---|\n";
        }
        let Violation { verdict, length, pair, distance } = violation;
        let [first, second] = pair.each_ref().map(|simplex| points(simplex, row.algorithm.dimension.count()));
        let _ = writeln!(
            page,
            "| {} | {} | {} | {} | {length:e} | {:.2e} | {first} | {second} |",
            row.algorithm.number(),
            row.precision.name(),
            row.variant(),
            verdict.name(),
            distance / length,
        );
    }
    page
}

/// The coordinates with all digits, so that a violation can be repeated.
fn points(simplex: &[[f64; 3]], dimension: usize) -> String {
    let point = |point: &[f64; 3]| point[..dimension].iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(", ");
    simplex.iter().map(|vertex| format!("({})", point(vertex))).collect::<Vec<_>>().join(" ")
}
