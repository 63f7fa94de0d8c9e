//! The two numbers on top: is anything wrong, and what does being right cost?

use std::collections::{BTreeMap, BTreeSet};

use crate::groups::{REFERENCE, backends, timings};
use crate::table::{Headline, Tone};
use crate::{Class, RunDir};
use predicament_records::format::{counted, factor, length, thousands};
use predicament_records::geometric_mean;

pub fn headlines(runs: &[RunDir]) -> [Headline; 2] {
    [unexpected(runs), price(runs)]
}

fn unexpected(runs: &[RunDir]) -> Headline {
    let pairs: usize = runs.iter().map(|run| run.summary.len()).sum();
    let failed = runs.iter().flat_map(|run| &run.summary).filter(|row| !row.status.passes()).count();
    let answered = runs.iter().flat_map(|run| &run.summary).filter(|row| row.has_answers());
    let queries: u64 = answered.map(|row| row.queries).sum();
    let wrong: u64 = runs.iter().flat_map(|run| &run.summary).map(crate::SummaryRow::wrong).sum();
    let missing: usize = runs.iter().map(|run| run.not_run().len()).sum();
    let mut detail = format!(
        "of {} of scene and backend; {} of {} answers are wrong, expected ones included",
        counted(length(pairs), "pair"),
        thousands(wrong),
        thousands(queries)
    );
    if missing > 0 {
        detail += &format!("; {} planned and not run", thousands(length(missing)));
    }
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

/// The smallest time relative to the reference among the backends that made no
/// mistake, wherever the reference was timed: the geometric mean over tasks and families.
fn price(runs: &[RunDir]) -> Headline {
    let none = |detail: String| Headline {
        number: "—".to_owned(),
        label: "the price of being right",
        detail,
        tone: Tone::Muted,
    };

    let timings: Vec<_> = runs.iter().map(timings).collect();
    let mut ratios: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    let mut cells = 0;
    for timings in &timings {
        for (&[task, family, backend], reference) in timings {
            if backend != REFERENCE {
                continue;
            }
            cells += 1;
            for backend in backends(runs) {
                if let Some(timing) = timings.get(&[task, family, backend]) {
                    ratios.entry(backend).or_default().push(timing.spread.median / reference.spread.median);
                }
            }
        }
    }
    if cells == 0 {
        return none(format!("{REFERENCE}, which times are compared with, was not timed"));
    }

    let rows = || runs.iter().flat_map(|run| &run.summary);
    let checked: BTreeSet<&str> = rows().filter(|row| row.has_answers()).map(|row| &*row.backend).collect();
    let scene_failed = [Class::Topology, Class::Panic, Class::Timeout];
    let mistaken: BTreeSet<&str> = rows()
        .filter(|row| row.wrong() > 0 || scene_failed.into_iter().any(|class| row.count(class) > 0))
        .map(|row| &*row.backend)
        .collect();
    let right = |backend: &str| checked.contains(backend) && !mistaken.contains(backend);
    let candidates = ratios.into_iter().filter(|(backend, ratios)| right(backend) && ratios.len() == cells);
    let means = candidates.filter_map(|(backend, ratios)| Some((geometric_mean(ratios)?, backend)));
    let Some((ratio, backend)) = means.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return none(format!("no backend without a mistake was timed wherever {REFERENCE} was"));
    };
    Headline {
        number: factor(ratio),
        label: "the time of shewchuk: the price of being right",
        detail: format!(
            "{backend} is the fastest backend without a wrong answer or a failed check; geometric mean over {} \
             of task and family",
            counted(length(cells), "pair")
        ),
        tone: Tone::Plain,
    }
}
