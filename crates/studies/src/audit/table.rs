//! Decisions and violations of each algorithm, as Markdown.

use std::fmt::Write as _;

use super::study::{Audited, Record};
use super::{Audit, Violation};

/// The table, and the first violation of each row that has any.
pub(super) fn page(audit: &Audit, audited: &[Audited]) -> String {
    let mut page = format!("`predicament audit --decisions {} --seed {}`\n\n", audit.decisions, audit.seed);
    page += "| Algorithm | precision | variant | decisions | ended | registered | not | near | agree | in band \
             | overreach | missed | unguarded | bad weight | weight error | least guard |\n";
    page += "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for row in audited {
        let Record { algorithm, pair, ranks, precision, variant, decisions, ended, registered, .. } = Record::of(row);
        let Record { not_registered, near, agree, in_band, overreach, missed, unguarded, .. } = Record::of(row);
        let Record { bad_weight, weight_error, least_guard, .. } = Record::of(row);
        #[allow(clippy::cast_precision_loss)] // a share to be read
        let near = format!("{:.1} %", near as f64 / decisions as f64 * 100.0);
        let guard = least_guard.map_or_else(|| "-".to_owned(), |guard| format!("{guard:.3}"));
        let _ = writeln!(
            page,
            "| {algorithm} {pair} ({ranks}) | {precision} | {variant} | {decisions} | {ended} | {registered} | \
             {not_registered} | {near} | {agree} | {in_band} | {overreach} | {missed} | {unguarded} | {bad_weight} | \
             {weight_error:.1e} | {guard} |",
        );
    }
    page += "\nEnded: besides the decisions, pairs of which a sub-pair is registered. Near: decisions with a distance \
             within 2^-20 of T- or T+, of the pair or, if it has no tolerance, of a facet. Least guard: the smallest \
             quotient of a guarded quantity and its lower bound, of registered pairs.\n";
    let first = audited.iter().filter_map(|(row, tally)| Some((row, tally.first.as_ref()?)));
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

/// All digits: a violation can be repeated.
fn points(simplex: &[[f64; 3]], dimension: usize) -> String {
    let point = |point: &[f64; 3]| point[..dimension].iter().map(|x| format!("{x:e}")).collect::<Vec<_>>().join(", ");
    simplex.iter().map(|vertex| format!("({})", point(vertex))).collect::<Vec<_>>().join(" ")
}
