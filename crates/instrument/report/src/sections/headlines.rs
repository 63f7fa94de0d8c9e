//! The numbers on top of a report: unexpected findings, pairs that were not run, and the price of being right.

use std::collections::BTreeSet;

use crate::comparison::{Share, standing};
use crate::figures::{Mark, Scope, faultless, marks};
use crate::groups::{REFERENCE, Times, Way};
use crate::table::{Headline, Tone};
use crate::{Class, Outcome, RunDir, Status};
use predicament_records::format::{counted, factor, length, thousands};

pub fn headlines(runs: &[RunDir]) -> [Headline; 3] {
    [unexpected(runs), not_run(runs), price(runs)]
}

/// The number of missing pairs, so that a reader does not mistake them for successes.
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
        label: "planned pairs of scene and backend that were not run",
        detail: parts.join("; "),
        tone: if missing + broken_off > 0 { Tone::Bad } else { Tone::Good },
    }
}

/// The number of findings without an expectation. An expected one that is gone is not an error of a backend, and is
/// counted separately.
fn unexpected(runs: &[RunDir]) -> Headline {
    let rows = || runs.iter().flat_map(|run| &run.summary);
    let of = |status: Status| rows().filter(|row| row.status == status).count();
    let (worse, better) = (of(Status::Unexpected), of(Status::UnexpectedPass));
    let missing: usize = runs.iter().map(|run| run.not_run().len()).sum();
    let pairs = rows().count();
    let mut detail = format!("of {} of scene and backend", counted(length(pairs), "pair"));
    if better > 0 {
        detail += &format!("; {} better than expected: prune their expectations", thousands(length(better)));
    }
    Headline {
        number: thousands(length(worse)),
        label: "unexpected findings",
        detail,
        tone: match worse {
            0 if missing > 0 || pairs == 0 => Tone::Notable,
            0 => Tone::Good,
            _ => Tone::Bad,
        },
    }
}

/// The price of being right: the time of the cheapest faultless backend relative to the reference.
///
/// A faultless backend answers everything that it is asked, is never wrong and breaks no law. If there is no such
/// backend, only predicates count.
fn price(runs: &[RunDir]) -> Headline {
    const LABEL: &str = "the price of being right";
    let none = |detail: String| Headline { number: "—".to_owned(), label: LABEL, detail, tone: Tone::Muted };
    if runs.iter().flat_map(|run| &run.throughput).all(|row| row.backend != REFERENCE) {
        return none(format!("the reference {REFERENCE} was not timed"));
    }
    let times = Times::of(runs);
    let rule = "the cheapest backend that answers everything it was asked, is never wrong and breaks no law";
    if let Some(best) = faultless(runs, &times, Scope::Everything).first() {
        return found(best, LABEL, rule);
    }
    let nearest = nearest(runs, &times);
    match faultless(runs, &times, Scope::Predicates).first() {
        Some(best) => {
            let rule = format!("{rule}, on predicates alone; no backend does so on all tasks{nearest}");
            found(best, "the price of being right about signs", &rule)
        }
        None => none(format!("no backend answers everything it was asked, is never wrong and breaks no law{nearest}")),
    }
}

fn found(best: &Mark, label: &'static str, rule: &str) -> Headline {
    let told = |way: Way| {
        let pace = best.pace(way)?;
        Some(format!(
            "{} of {REFERENCE}'s time for a {} ({})",
            factor(pace.ratio),
            way.head(),
            counted(length(pace.families), "pair")
        ))
    };
    let times: Vec<String> = Way::ALL.into_iter().filter_map(told).collect();
    Headline {
        number: factor(best.paces[0].ratio),
        label,
        detail: format!("{} is {rule}: {}, of task and family", best.backend, times.join(", ")),
        tone: Tone::Plain,
    }
}

/// The backend without wrong answers and with the fewest broken laws, with its faults.
fn nearest(runs: &[RunDir], times: &Times) -> String {
    let mut never_wrong = marks(runs, times, |_| true);
    never_wrong.retain(|mark| mark.standing.answers.wrong + mark.standing.answers.undecided == 0);
    let share = |share: Share| share.value().unwrap_or(0.0);
    let best = never_wrong.iter().min_by(|a, b| {
        share(a.broken()).total_cmp(&share(b.broken())).then(share(a.not_done()[1]).total_cmp(&share(b.not_done()[1])))
    });
    best.map_or_else(String::new, |mark| {
        let of = standing(runs, mark.backend, |_| true).scenes;
        format!(
            "; {} is never wrong, breaks {} and leaves {} undone",
            mark.backend,
            counted(of.broken, "scene"),
            thousands(of.not_done)
        )
    })
}
