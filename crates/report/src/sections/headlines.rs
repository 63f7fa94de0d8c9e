//! The numbers on top of a report: unexpected findings, what was not run, and the cost of exact answers.

use std::collections::BTreeSet;

use super::some_of;
use crate::figures::{Price, Prices, all_prices};
use crate::groups::REFERENCE;
use crate::table::{Headline, Tone};
use crate::{Class, Outcome, RunDir};
use predicament_records::format::{counted, factor, length, thousands};

pub fn headlines(runs: &[RunDir]) -> [Headline; 3] {
    [unexpected(runs), not_run(runs), price(runs)]
}

/// What is missing, so that it is not taken for a success.
fn not_run(runs: &[RunDir]) -> Headline {
    let missing: usize = runs.iter().map(|run| run.not_run().len()).sum();
    let broken_off = runs.iter().filter(|run| run.outcome != Outcome::Complete).count();
    let of = |class: Class| runs.iter().flat_map(|run| &run.summary).filter(|row| row.count(class) > 0).count();
    let suites: BTreeSet<&str> =
        runs.iter().flat_map(|run| &run.plan.not_selected).map(|skipped| &*skipped.suite).collect();
    let backends: BTreeSet<&str> = runs.iter().flat_map(|run| &run.plan.left_out).map(String::as_str).collect();
    let mut parts = vec![
        format!("{} declined", thousands(length(of(Class::Declined)))),
        format!("{} out of time", thousands(length(of(Class::Timeout)))),
        format!("{} of the tool not selected", counted(length(suites.len()), "suite")),
        format!("{} not named", counted(length(backends.len()), "backend")),
    ];
    if broken_off > 0 {
        parts.insert(0, format!("{} broken off", counted(length(broken_off), "run")));
    }
    Headline {
        number: thousands(length(missing)),
        label: "pairs of scene and backend planned and not run",
        detail: parts.join("; "),
        tone: if missing + broken_off > 0 { Tone::Bad } else { Tone::Good },
    }
}

fn unexpected(runs: &[RunDir]) -> Headline {
    let pairs: usize = runs.iter().map(|run| run.summary.len()).sum();
    let failed = runs.iter().flat_map(|run| &run.summary).filter(|row| !row.status.passes()).count();
    let answered = runs.iter().flat_map(|run| &run.summary).filter(|row| row.has_answers());
    let queries: u64 = answered.map(|row| row.queries).sum();
    let wrong: u64 = runs.iter().flat_map(|run| &run.summary).map(crate::SummaryRow::wrong).sum();
    let missing: usize = runs.iter().map(|run| run.not_run().len()).sum();
    let detail = format!(
        "of {} of scene and backend; {} of {} answers are wrong, expected ones included",
        counted(length(pairs), "pair"),
        thousands(wrong),
        thousands(queries)
    );
    Headline {
        number: thousands(length(failed)),
        label: "unexpected results",
        detail,
        tone: match failed {
            0 if missing > 0 || pairs == 0 => Tone::Notable,
            0 => Tone::Good,
            _ => Tone::Bad,
        },
    }
}

/// The smallest time relative to the reference among the backends that made no mistake on what they are compared on: the
/// geometric mean over the pairs of task and family that all compared backends did.
fn price(runs: &[RunDir]) -> Headline {
    let none = |detail: String| Headline {
        number: "—".to_owned(),
        label: "the price of being right",
        detail,
        tone: Tone::Muted,
    };
    if runs.iter().flat_map(|run| &run.throughput).all(|row| row.backend != REFERENCE) {
        return none(format!("{REFERENCE}, which times are compared with, was not timed"));
    }
    let Some(Prices { pairs, prices, .. }) = all_prices(runs) else {
        return none(format!("{REFERENCE}, which times are compared with, was not checked wherever it was timed"));
    };
    let (compared, partial): (Vec<Price>, Vec<Price>) = prices.into_iter().partition(|price| !price.is_partial);
    let mut basis = format!(
        "over {} of task and family that all {} did",
        counted(length(pairs), "pair"),
        counted(length(compared.len()), "compared backend")
    );
    if !partial.is_empty() {
        let names: Vec<&str> = partial.iter().map(|price| price.backend).collect();
        basis += &format!("; {} did too few of them to be compared", some_of(names.into_iter(), usize::MAX));
    }
    let right = compared.iter().filter(|price| price.errors.is_right());
    match right.min_by(|a, b| a.ratio.total_cmp(&b.ratio)) {
        None => none(format!("no compared backend is without a mistake {basis}")),
        Some(Price { backend, ratio, .. }) => Headline {
            number: factor(*ratio),
            label: "the time of shewchuk: the price of being right",
            detail: format!(
                "{backend} is the fastest backend without a wrong answer or a failed check on what is compared; geometric \
                 mean {basis}"
            ),
            tone: Tone::Plain,
        },
    }
}
