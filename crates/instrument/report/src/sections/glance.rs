//! The section on which backend to use: each backend over everything that it was asked. README shows this table.

use crate::comparison::Share;
use crate::figures::{FILE, Mark, overall};
use crate::groups::{Pace, REFERENCE, Times, Way};
use crate::plot::{Point, Tradeoff, tradeoff};
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Error, Origin, RunDir};
use predicament_records::format::{factor, significant, thousands};

pub fn section(runs: &[RunDir], times: &Times) -> Section {
    let mut marks = overall(runs, times).marks;
    marks.sort_by(|a, b| rank(a).partial_cmp(&rank(b)).unwrap_or(std::cmp::Ordering::Equal));
    let mut blocks = vec![Block::table_or(table(&marks), "No scene was checked.")];
    if !marks.is_empty() {
        blocks.push(Block::Note(key(&marks), Tone::Muted));
    }
    Section { id: "glance", title: "Which backend to use", lead: LEAD.to_owned(), blocks }
}

/// The ranking in aligned columns, for a terminal: errors with their denominators, and the time of a single query.
pub fn ranking(runs: &[RunDir]) -> String {
    let times = Times::of(runs);
    let mut marks = overall(runs, &times).marks;
    marks.sort_by(|a, b| rank(a).partial_cmp(&rank(b)).unwrap_or(std::cmp::Ordering::Equal));
    let of = |share: Share| format!("{} of {}", thousands(share.count), thousands(share.of));
    let time = |mark: &Mark| mark.pace(Way::Single).map_or_else(String::new, |pace| factor(pace.ratio));
    let head = ["backend", "wrong answers", "broken scenes", "scenes not done"].map(str::to_owned);
    let mut rows = vec![(head, format!("single query / {REFERENCE}"))];
    rows.extend(marks.iter().map(|mark| {
        let [_, not_done] = mark.not_done();
        ([mark.backend.to_owned(), of(mark.wrong()), of(mark.broken()), of(not_done)], time(mark))
    }));
    let widths = [0, 1, 2, 3].map(|column: usize| rows.iter().map(|(row, _)| row[column].len()).max().unwrap_or(0));
    let line = |(row, time): &([String; 4], String)| {
        let [name, wrong, broken, not_done] = row;
        let [a, b, c, d] = widths;
        let text = format!("{name:<a$}  {wrong:>b$}  {broken:>c$}  {not_done:>d$}  {time:>20}");
        text.trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}

/// The table's figures as plots; `None` if nothing was timed.
pub fn drawn(runs: &[RunDir], times: &Times) -> Result<Option<Section>, Error> {
    let mut blocks = Vec::new();
    for (plot, file) in plots(&overall(runs, times).marks, &[]) {
        if let Some(picture) = tradeoff(&plot)? {
            let alt = format!("{} against {}", plot.y, plot.x);
            blocks.push(Block::Plot { picture, file: file.into(), alt: alt.into() });
        }
    }
    Ok((!blocks.is_empty()).then(|| Section {
        id: "tradeoff",
        title: "The price of being right",
        lead: "The error rate against time. Errors cover everything that a backend was asked. A line is Wilson's \
               interval at 95 %. Backends without errors are at the bottom, with the upper end of their interval. A \
               cross marks a broken law of a whole scene. A bar shows the share that was left undone."
            .to_owned(),
        blocks,
    }))
}

/// The key of the ranking: broken laws and wrong answers, then the share that is not done, then the time.
fn rank(mark: &Mark) -> [f64; 4] {
    let share = |share: Share| share.value().unwrap_or(0.0);
    let [answers, scenes] = mark.not_done();
    let is_wrong = if mark.standing.is_right() { 0.0 } else { 1.0 };
    let wrong = share(mark.wrong()).max(share(mark.broken()));
    [is_wrong, wrong, share(answers).max(share(scenes)), mark.paces.first().map_or(f64::INFINITY, |pace| pace.ratio)]
}

/// The two panels of errors against time: for single answers, and for whole scenes.
pub fn plots(marks: &[Mark], earlier: &[Mark]) -> [(Tradeoff, &'static str); 2] {
    // 0: answers, 1: scenes.
    let points = |way: Way, which: usize| {
        let errors = |mark: &Mark| [mark.wrong(), mark.broken()][which];
        let point = |mark: &Mark| {
            let pair = |share: Share| [share.count, share.of];
            let before = earlier.iter().find(|old| old.backend == mark.backend);
            Point {
                backend: mark.backend.to_owned(),
                time: mark.pace(way).map(|pace| pace.ratio),
                errors: pair(errors(mark)),
                not_done: pair(mark.not_done()[which]),
                is_marked: which == 0 && mark.standing.scenes.broken > 0,
                curve: None,
                before: before.and_then(|old| Some((old.pace(way)?.ratio, pair(errors(old))))),
            }
        };
        marks.iter().map(point).collect()
    };
    let panel = |title: &str, what: &str, (y, per): (&str, f64), points| Tradeoff {
        title: title.to_owned(),
        x: format!("time of a {what} over {REFERENCE}'s"),
        y: y.to_owned(),
        per,
        points,
    };
    let answers = panel("Answers", "single query", ("wrong answers per million", 1e6), points(Way::Single, 0));
    let scenes = panel("Whole scenes", "whole scene", ("broken scenes per thousand", 1e3), points(Way::Whole, 1));
    [(answers, "overall.svg"), (scenes, "overall-scenes.svg")]
}

fn table(marks: &[Mark]) -> Table {
    let ways: Vec<Way> =
        Way::ALL.into_iter().filter(|&way| marks.iter().any(|mark| mark.pace(way).is_some())).collect();
    let scenes = marks.iter().any(|mark| mark.standing.scenes.asked() > 0);
    let rounded = marks.iter().any(|mark| mark.standing.scenes.rounded > 0);
    let mut table = Table::new("")
        .basis(
            "right, undecided, wrong and not done: shares of all queries; broken and rounded: shares of the answered \
             scenes; left undone: share of all scenes; in parentheses: counts and Wilson's intervals at 95 %",
        )
        .words(["backend"])
        .of(Origin::of(FILE).keys(["backend"]).only("panel", "all"))
        .numbers(["answers", "right", "undecided", "wrong", "not done"]);
    if scenes {
        table = table.numbers(["scenes", "broken"]);
        table = table.numbers(rounded.then_some("rounded")).numbers(["left undone"]);
    }
    table = table.numbers(ways.iter().map(|way| format!("{} / {REFERENCE}", way.head())));
    for mark in marks {
        let (answers, of) = (&mark.standing.answers, mark.standing.answers.asked());
        let share = |count| Share { count, of };
        let mut row = vec![
            Cell::code(mark.backend),
            Cell::count(of),
            told(share(answers.right), "answer", Tone::Plain),
            told(share(answers.undecided), "answer", Tone::Legal),
            told(share(answers.wrong), "answer", Tone::Bad),
            told(share(answers.not_done), "answer", Tone::Notable),
        ];
        if scenes {
            let of = &mark.standing.scenes;
            let rounding = Share { count: of.rounded, of: of.done() };
            row.extend([Cell::count(of.asked()), told(mark.broken(), "scene that was done", Tone::Bad)]);
            row.extend(rounded.then(|| told(rounding, "scene that was done", Tone::Notable)));
            row.push(told(mark.not_done()[1], "scene", Tone::Notable));
        }
        row.extend(ways.iter().map(|&way| time(mark.pace(way))));
        table.push(row);
    }
    table
}

/// A share with its count, in this tone unless it is zero; a share of errors also has its interval.
fn told(share: Share, noun: &str, tone: Tone) -> Cell {
    if share.of == 0 {
        return Cell::from("—").tone(Tone::Muted);
    }
    let cell = Cell::from(share.text()).title(share.told(noun));
    let cell = cell.tone(if share.count == 0 { Tone::Muted } else { tone });
    let [low, high] = share.interval().map(|share| significant(100.0 * share, 3));
    match (share.count, tone) {
        (0, Tone::Bad) => cell.detail(format!("≤ {high} %")),
        (0, _) | (_, Tone::Plain) => cell,
        (count, Tone::Bad) => cell.detail(format!("{}; {low} to {high} %", thousands(count))),
        (count, _) => cell.detail(thousands(count)),
    }
}

/// A ratio with the number of families that it covers.
pub fn time(pace: Option<&Pace>) -> Cell {
    let Some(pace) = pace else { return Cell::from("—").tone(Tone::Muted) };
    let families = format!("{} of {} families", pace.families, pace.of);
    let [low, high] = pace.range.map(|ns| significant(ns / pace.reference, 2));
    let title = format!("over {families} that both were timed on; shortest to longest sample {low} to {high}");
    let detail = if pace.is_loop { format!("a loop; {families}") } else { families };
    Cell::from(factor(pace.ratio)).detail(detail).title(title)
}

const LEAD: &str = "Best first: never wrong, then least wrong, then least undecided or undone, then fastest. The \
                    figures of a backend cover everything that it was asked. They do not depend on the other \
                    backends of the run.";

/// The key to the columns and the plots.
fn key(marks: &[Mark]) -> String {
    let mut key = "Answers are judged query by query: right (including ties broken as promised), undecided (within a \
                   tolerance), wrong, or not done (declined, out of time, crashed). Scenes are judged as a whole: \
                   broken means that a law is violated, rounded that only the rounding of coordinates violates it."
        .to_owned();
    if marks.iter().any(|mark| !mark.paces.is_empty()) {
        key += &format!(
            " A time is a ratio to {REFERENCE}'s time in the same run: the geometric mean over the families of \
             scenes that both were timed on. Single queries, batches and whole scenes are never mixed. Batches of \
             {REFERENCE} use vector registers, so the ratio of a batch is the price of exactness."
        );
    }
    key
}
