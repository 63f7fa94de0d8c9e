//! The figures that pages, plots, headlines and `figures.csv` show: speed beside error, like beside like.
//!
//! Every mean here is over what a [`Comparison`] says.

use std::collections::{BTreeMap, BTreeSet};

use crate::comparison::Comparison;
use crate::groups::{ByPair, Errors, Pair, REFERENCE, answered, backends, timed};
use crate::{Error, RunDir, Spread};
use predicament_records::{Lined, geometric_mean};

/// The backends on one task in one run: a panel of the plot.
#[derive(Clone, PartialEq, Debug)]
pub struct Panel<'r> {
    /// The place of the run with the timings in the list of runs.
    pub run: usize,
    pub task: &'r str,
    /// How many families all compared backends were checked and timed on.
    pub families: usize,
    /// How many families any backend was.
    pub of: usize,
    pub marks: Vec<Mark<'r>>,
    /// What each partial backend did, for all backends that did the same.
    pub partial: Vec<Partial<'r>>,
}

/// What a partial backend did, and what it took whom.
#[derive(Clone, PartialEq, Debug)]
pub struct Partial<'r> {
    pub backend: &'r str,
    /// How many families it did.
    pub families: usize,
    /// The geometric means of the times over these very families, in nanoseconds per query, of the backends that did them all.
    pub ns: BTreeMap<&'r str, f64>,
}

/// A backend on a task: its speed beside its errors.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark<'r> {
    pub backend: &'r str,
    /// Whether it did too little to be compared with the others of its panel.
    pub is_partial: bool,
    /// How many families are behind the mark: those of the panel, or its own where it is partial.
    pub families: usize,
    /// Summed over the families.
    pub errors: Errors,
    /// The geometric mean of the families' times, in nanoseconds per query.
    pub ns: f64,
    /// The same of the shortest and of the longest sample of each family.
    pub range: [f64; 2],
    /// The same of the reference over the very same families; none where it did not do all of them.
    pub reference: Option<f64>,
    /// Whether it is compared, and no other compared backend is at least as good in both and better in one.
    pub on_frontier: bool,
}

/// All panels, by run, then task; marks in the order of the backends.
pub fn panels(runs: &[RunDir]) -> Vec<Panel<'_>> {
    let order = backends(runs);
    let mut panels = Vec::new();
    for (run, folder) in runs.iter().enumerate() {
        let (errors, times) = (answered(runs, &[folder]), timed(folder));
        let tasks: BTreeSet<&str> = times.keys().map(|[task, _]| *task).collect();
        for task in tasks {
            let did = |backend: &str| {
                let pairs = times.iter().filter(|([of, _], times)| *of == task && times.contains_key(backend));
                let pairs = pairs.map(|(pair, _)| *pair);
                pairs.filter(|pair| errors.get(pair).is_some_and(|of| of.contains_key(backend))).collect()
            };
            let comparison = Comparison::of(order.iter().map(|&backend| (backend, did(backend))).collect());
            let mean_of = |backend: &str, pairs: &BTreeSet<Pair>, time: fn(Spread) -> f64| {
                let times: Option<Vec<f64>> = pairs.iter().map(|pair| value(&times, pair, backend).map(time)).collect();
                geometric_mean(times?)
            };
            let mean = |backend: &str, pairs: &BTreeSet<Pair>| mean_of(backend, pairs, |spread| spread.median);
            let mut marks: Vec<Mark> = comparison
                .each()
                .filter_map(|(backend, pairs, is_partial)| {
                    let errors = pairs.iter().filter_map(|pair| value(&errors, pair, backend));
                    let (families, errors) = (pairs.len(), Errors::sum(errors));
                    let (ns, reference) = (mean(backend, pairs)?, mean(REFERENCE, pairs));
                    let range =
                        [mean_of(backend, pairs, |spread| spread.min)?, mean_of(backend, pairs, |spread| spread.max)?];
                    Some(Mark { backend, is_partial, families, errors, ns, range, reference, on_frontier: false })
                })
                .collect();
            let partial = comparison.partial.iter().map(|(backend, pairs)| Partial {
                backend,
                families: pairs.len(),
                ns: order.iter().filter_map(|&other| Some((other, mean(other, pairs)?))).collect(),
            });
            let partial = partial.collect();
            marks.sort_by_key(|mark| order.iter().position(|backend| *backend == mark.backend));
            for at in 0..marks.len() {
                let is_beaten = marks.iter().any(|other| !other.is_partial && dominates(other, &marks[at]));
                marks[at].on_frontier = !marks[at].is_partial && !is_beaten;
            }
            if !marks.is_empty() {
                panels.push(Panel { run, task, families: comparison.common.len(), of: comparison.of, marks, partial });
            }
        }
    }
    panels
}

fn value<'r, T: Copy>(of: &ByPair<'r, T>, pair: &Pair<'r>, backend: &str) -> Option<T> {
    of.get(pair)?.get(backend).copied()
}

fn dominates(a: &Mark, b: &Mark) -> bool {
    // Rates as products, so that equal rates are equal whatever their denominators.
    let left = u128::from(a.errors.wrong) * u128::from(b.errors.queries);
    let right = u128::from(b.errors.wrong) * u128::from(a.errors.queries);
    left <= right && a.ns <= b.ns && (left < right || a.ns < b.ns)
}

/// What backends cost beside a reference.
#[derive(Clone, PartialEq, Debug)]
pub struct Prices<'r> {
    /// How many pairs of task and family all compared backends were checked and timed on.
    pub pairs: usize,
    /// How many pairs the reference was.
    pub of: usize,
    pub prices: Vec<Price<'r>>,
}

/// What one backend costs beside a reference.
#[derive(Clone, PartialEq, Debug)]
pub struct Price<'r> {
    pub backend: &'r str,
    /// Whether it did too little to be compared with the others.
    pub is_partial: bool,
    /// How many pairs of task and family are behind the ratio.
    pub pairs: usize,
    /// Summed over these pairs.
    pub errors: Errors,
    /// The geometric mean of the ratios of times to the reference's in the same run.
    pub ratio: f64,
}

/// What the backends cost for which `keep` holds, with their task, on what the reference was checked and timed on.
/// None if that is nothing.
pub fn prices<'r>(runs: &'r [RunDir], reference: &str, keep: impl Fn(&str, &str) -> bool) -> Option<Prices<'r>> {
    let folders: Vec<&RunDir> = runs.iter().filter(|run| !run.throughput.is_empty()).collect();
    let errors = answered(runs, &folders);
    let mut ratios: ByPair<Vec<f64>> = BTreeMap::new();
    for folder in folders {
        for (pair, times) in timed(folder) {
            let Some(base) = times.get(reference) else { continue };
            for (&backend, ns) in &times {
                if keep(pair[0], backend) && value(&errors, &pair, backend).is_some() {
                    ratios.entry(pair).or_default().entry(backend).or_default().push(ns.median / base.median);
                }
            }
        }
    }
    ratios.retain(|_, ratios| ratios.contains_key(reference));
    let order = backends(runs);
    let did = |backend: &str| ratios.iter().filter(|(_, of)| of.contains_key(backend)).map(|(pair, _)| *pair).collect();
    let comparison = Comparison::of(order.iter().map(|&backend| (backend, did(backend))).collect());
    let mut prices: Vec<Price> = comparison
        .each()
        .filter_map(|(backend, pairs, is_partial)| {
            // A pair that was timed in several runs is one pair.
            let of_pair = |pair: &Pair| geometric_mean(ratios.get(pair)?.get(backend)?.iter().copied());
            let ratio = geometric_mean(pairs.iter().filter_map(of_pair))?;
            let errors = Errors::sum(pairs.iter().filter_map(|pair| value(&errors, pair, backend)));
            Some(Price { backend, is_partial, pairs: pairs.len(), errors, ratio })
        })
        .collect();
    prices.sort_by_key(|price| order.iter().position(|backend| *backend == price.backend));
    (!prices.is_empty()).then_some(Prices { pairs: comparison.common.len(), of: comparison.of, prices })
}

/// What all backends cost beside [`REFERENCE`].
pub fn all_prices(runs: &[RunDir]) -> Option<Prices<'_>> {
    prices(runs, REFERENCE, |_, _| true)
}

/// The file that holds all figures.
pub const FILE: &str = "figures.csv";

const COLUMNS: [&str; 16] = [
    "panel",
    "run",
    "backend",
    "standing",
    "basis",
    "families",
    "queries",
    "wrong",
    "failed_checks",
    "ns_per_query",
    "reference",
    "reference_ns_per_query",
    "ratio",
    "frontier",
    "ns_per_query_min",
    "ns_per_query_max",
];

/// `figures.csv`: the marks of all panels, and before them, as panel `all`, what the backends cost over all tasks.
///
/// `basis` is on how many families (for `all`: pairs of task and family) the panel compares, `families` how many are
/// behind the row: as many where `standing` is `compared`, its own where it is `partial`. `ratio` is the time over the
/// reference's on the very same families. `ns_per_query_min` and `ns_per_query_max` are means of the shortest and the longest samples.
///
/// # Errors
/// If memory can't be written to, which does not happen.
pub fn csv(runs: &[RunDir]) -> Result<String, Error> {
    let fail = |error: csv::Error| Error::new(FILE.as_ref(), error.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS).map_err(fail)?;
    let standing = |is_partial: bool| if is_partial { "partial" } else { "compared" }.to_owned();
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| x.to_string());
    if let Some(Prices { pairs, prices, .. }) = all_prices(runs) {
        for price in prices {
            let Errors { queries, wrong, failed } = price.errors;
            let counts = [price.pairs.to_string(), queries.to_string(), wrong.to_string(), failed.to_string()];
            let head = ["all".to_owned(), String::new(), price.backend.to_owned(), standing(price.is_partial)];
            let rest = ["", REFERENCE, "", &price.ratio.to_string(), "", "", ""].map(str::to_owned);
            let record = head.into_iter().chain([pairs.to_string()]).chain(counts).chain(rest);
            writer.write_record(record.collect::<Vec<_>>()).map_err(fail)?;
        }
    }
    for panel in panels(runs) {
        for mark in panel.marks {
            let Errors { queries, wrong, failed } = mark.errors;
            let run = (panel.run + 1).to_string();
            let head = [panel.task.to_owned(), run, mark.backend.to_owned(), standing(mark.is_partial)];
            let counts = [panel.families, mark.families].map(|n| n.to_string());
            let counts = counts.into_iter().chain([queries, wrong, failed].map(|n| n.to_string()));
            let ratio = mark.reference.map(|reference| mark.ns / reference);
            let times = [number(Some(mark.ns)), REFERENCE.to_owned(), number(mark.reference), number(ratio)];
            let record = head.into_iter().chain(counts).chain(times).chain([mark.on_frontier.to_string()]);
            let record = record.chain(mark.range.map(|ns| number(Some(ns))));
            writer.write_record(record.collect::<Vec<_>>()).map_err(fail)?;
        }
    }
    let bytes = writer.into_inner().map_err(|error| Error::new(FILE.as_ref(), error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Error::new(FILE.as_ref(), error.to_string()))
}

/// The rows of the file with their lines.
pub fn lined(runs: &[RunDir]) -> Result<Lined, Error> {
    let fail = |error: csv::Error| Error::new(FILE.as_ref(), error.to_string());
    let text = csv(runs)?;
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let columns = reader.headers().map_err(fail)?.iter().map(str::to_owned).collect();
    // No field has a line end: each row is a line, under the header.
    let rows =
        (2..).zip(reader.records()).map(|(line, record)| Ok((line, record?.iter().map(str::to_owned).collect())));
    Ok(Lined { columns, rows: rows.collect::<Result<_, _>>().map_err(fail)? })
}
