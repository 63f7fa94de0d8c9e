//! The first table of the comparison: one row per backend, with its own denominators.

use predicament_report::{Block, Cell, Section, Table, Tone, section_markdown};

use super::standing::{BARELY, REFERENCE, Share, Standing, left_out, standings};
use super::words::{counted, input, listed, millionths, pairs, percents, rate, share, times};
use super::{Measure, Promise};

/// The explanation of the columns.
pub(super) const MEANING: &str = "Each scene that a backend was given is in one class: right, undecided (a zero within a band), rounded (a check failed only \
     because output coordinates are rounded), wrong (a wrong answer or a broken law) or not done (declined, broken off, out of time). Broken laws are counted among the \
     scenes answered, in tasks with laws. Wrong answers are counted per million answers to single queries. Intervals are Wilson's at 95 %.";

/// The rule for ratios of times, and the inputs that they leave out.
pub(super) fn rule(measures: &[Measure]) -> String {
    let mut text = format!(
        "Times: the geometric mean of the ratios to {REFERENCE} over the inputs that both the backend and {REFERENCE} answered, with the number of these inputs."
    );
    let out: Vec<String> =
        left_out(measures).iter().map(|(of, ratio)| format!("{} ({})", input(of), times(*ratio))).collect();
    text += &match &out[..] {
        [] => String::new(),
        out => format!(
            " Inputs whose time barely depends on predicates are left out: if {REFERENCE} computes each answer twice, it takes less than {BARELY} times as long. Left out: {}.",
            listed(out)
        ),
    };
    text
}

/// The backends, ranked.
///
/// The order is by the share of their scenes that are neither wrong nor left undone, the largest first, then by time.
fn ranked(measures: &[Measure]) -> Vec<Standing<'_>> {
    let mut all = standings(measures);
    let place = |of: &Standing<'_>| {
        let failed = Share { count: of.scenes.wrong + of.scenes.not_done, of: of.scenes.asked };
        [failed.value().unwrap_or(2.0), of.time.map_or(f64::INFINITY, |time| time.value)]
    };
    all.sort_by(|a, b| {
        let pairs = place(a).into_iter().zip(place(b));
        pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    });
    all
}

/// The table.
pub(super) fn table(measures: &[Measure], promises: &[Promise]) -> Table {
    let mut table = Table::new("").words(["backend", "promise"]).numbers([
        "scenes",
        "right",
        "undecided",
        "rounded",
        "wrong",
        "not done",
        "broken laws",
        "wrong answers in 10^6",
        "undecided answers",
        &format!("time / {REFERENCE}"),
    ]);
    for of in ranked(measures) {
        let promise = promises.iter().find(|promise| promise.backend == of.backend);
        let proved = promise.map_or("", |promise| if promise.proved { "proved" } else { "not proved" });
        let scenes = of.scenes;
        let part = |count: u64| Share { count, of: scenes.asked };
        let bad = |is_bad: bool| if is_bad { Tone::Bad } else { Tone::Plain };
        let law = if of.laws.of == 0 {
            Cell::from("–")
        } else {
            Cell::from(counted(of.laws)).detail(percents(of.laws)).tone(bad(of.laws.count > 0))
        };
        let answers = if of.answers.of == 0 {
            Cell::from("–")
        } else {
            Cell::from(rate(of.answers))
                .detail(format!("{}: {}", counted(of.answers), millionths(of.answers)))
                .tone(bad(of.answers.count > 0))
        };
        table.push(vec![
            Cell::code(of.backend),
            Cell::from(promise.map_or("", |promise| &promise.promise)).detail(proved),
            Cell::count(scenes.asked).detail(format!("{} of {} inputs", of.inputs[0], of.inputs[1])),
            Cell::from(share(part(scenes.right))),
            Cell::from(share(part(scenes.undecided))),
            Cell::from(share(part(scenes.rounded))),
            Cell::from(share(part(scenes.wrong))).detail(percents(part(scenes.wrong))).tone(bad(scenes.wrong > 0)),
            Cell::from(share(part(scenes.not_done))),
            law,
            answers,
            Cell::from(share(of.in_band)),
            of.time.map_or_else(
                || Cell::from("–"),
                |time| {
                    Cell::from(times(time.value)).detail(format!(
                        "{}, {} to {}",
                        pairs(&time),
                        times(time.range[0]),
                        times(time.range[1])
                    ))
                },
            ),
        ]);
    }
    table
}

/// The table in five columns: promise, wrong answers, broken laws and time of each backend.
pub(super) fn short(measures: &[Measure], promises: &[Promise]) -> Table {
    let mut table = Table::new("").words(["backend", "promise of a sign"]).numbers([
        "wrong answers",
        "scenes with a broken law",
        &format!("time / {REFERENCE}"),
    ]);
    for of in ranked(measures) {
        let promise = promises.iter().find(|promise| promise.backend == of.backend);
        table.push(vec![
            Cell::code(of.backend),
            Cell::from(promise.map_or("", |promise| &promise.promise)),
            Cell::from(counted(of.answers)),
            Cell::from(counted(of.laws)),
            of.time.map_or_else(|| Cell::from("–"), |time| Cell::from(times(time.value)).detail(pairs(&time))),
        ]);
    }
    table
}

/// A table as Markdown, without a heading.
pub(super) fn markdown(table: Table) -> String {
    let section = Section { id: "compare", title: "", lead: String::new(), blocks: vec![Block::Table(table)] };
    section_markdown(&section).expect("the template is part of the program").trim().to_owned()
}
