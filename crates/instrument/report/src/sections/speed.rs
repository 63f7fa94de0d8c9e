//! The section about speed and error, task by task: a plot each, and the numbers.

use crate::figures::{FILE, Mark, Panel, panels};
use crate::groups::{REFERENCE, Times, Way};
use crate::plot::{Point, Tradeoff, tradeoff};
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Error, Origin, RunDir};
use predicament_records::format::{factor, nanoseconds, per_million, significant};

/// The section, or `None` if nothing was timed.
pub fn section(runs: &[RunDir], times: &Times) -> Result<Option<Section>, Error> {
    let panels = panels(runs, times);
    if panels.is_empty() {
        return Ok(None);
    }
    let mut blocks = Vec::new();
    for panel in &panels {
        let plot = plot(panel);
        if let Some(picture) = tradeoff(&plot)? {
            let file = format!("speed-{}.svg", panel.task.unwrap_or("all"));
            let alt = format!("{}: {} against {}", plot.title, plot.y, plot.x);
            blocks.push(Block::Plot { picture, file: file.into(), alt: alt.into() });
        }
    }
    blocks.push(Block::Table(table(&panels)));
    Ok(Some(Section {
        id: "speed",
        title: "Speed against error",
        lead: format!(
            "A panel for each timed task: the time relative to {REFERENCE}, and the rate of wrong answers, or of \
             broken scenes if answers are judged as a whole. Errors cover everything that the backend was asked. \
             Times cover the families that the backend and {REFERENCE} were both timed on. A line is Wilson's \
             interval at 95 % of the error rate; backends without errors are on the shelf at the bottom. A cross \
             marks a broken law of a whole scene. A bar shows the share that was left undone. figures.csv, beside \
             this page, has the same figures in full."
        ),
        blocks,
    }))
}

/// The interface of a panel: the one by which most of its backends were timed.
fn way(panel: &Panel) -> Way {
    let timed = |way: Way| panel.marks.iter().filter(|mark| mark.pace(way).is_some()).count();
    // On a tie, the order of this list decides.
    let ways = [Way::Batch, Way::Whole, Way::Single];
    ways.into_iter().max_by_key(|&way| timed(way)).unwrap_or(Way::Single)
}

fn plot(panel: &Panel) -> Tradeoff {
    let way = way(panel);
    let point = |mark: &Mark| {
        let errors = if panel.is_whole { mark.broken() } else { mark.wrong() };
        let not_done = mark.not_done()[usize::from(panel.is_whole)];
        Point {
            backend: mark.backend.to_owned(),
            time: mark.pace(way).map(|pace| pace.ratio),
            errors: [errors.count, errors.of],
            not_done: [not_done.count, not_done.of],
            is_marked: !panel.is_whole && mark.standing.scenes.broken > 0,
            curve: None,
            before: None,
        }
    };
    let families = panel.marks.iter().filter_map(|mark| mark.pace(way)).map(|pace| pace.of).max().unwrap_or(0);
    Tradeoff {
        title: format!("{}, {}", panel.task.unwrap_or("all"), families_of(families)),
        x: format!("time of a {} over {REFERENCE}'s", way.head()),
        y: if panel.is_whole { "broken scenes per thousand" } else { "wrong answers per million" }.to_owned(),
        per: if panel.is_whole { 1e3 } else { 1e6 },
        points: panel.marks.iter().map(point).collect(),
    }
}

fn families_of(count: usize) -> String {
    if count == 1 { "1 family".to_owned() } else { format!("{count} families") }
}

fn table(panels: &[Panel]) -> Table {
    let mut table = Table::new("The marks of the plots")
        .basis(format!(
            "errors over everything that was asked; times are geometric means over the families that the backend and {REFERENCE} \
             were both timed on"
        ))
        .words(["task", "backend", "asked"])
        .of(Origin::of(FILE).key("task", "panel").keys(["backend"]).key("asked", "interface"))
        .numbers(["answers", "wrong per million", "scenes", "broken", "families", "ns per query"])
        .numbers([format!("{REFERENCE} on the same"), "ratio".to_owned()]);
    for panel in panels {
        for mark in &panel.marks {
            let rate = per_million(mark.standing.answers.wrong, mark.standing.answers.asked());
            let tone = |count: u64| if count == 0 { Tone::Muted } else { Tone::Bad };
            let scenes = &mark.standing.scenes;
            let counts = [
                Cell::count(mark.standing.answers.asked()),
                Cell::from(rate.map_or_else(String::new, |rate| significant(rate, 3)))
                    .tone(tone(mark.standing.answers.wrong)),
                Cell::count(scenes.asked()),
                Cell::count(scenes.broken).tone(tone(scenes.broken)),
            ];
            let head = |asked: &str| [panel.task.unwrap_or_default().into(), mark.backend.into(), asked.into()];
            if mark.paces.is_empty() {
                let none = || Cell::from("—").tone(Tone::Muted);
                table
                    .push(head("").into_iter().chain(counts.clone()).chain([none(), none(), none(), none()]).collect());
            }
            for pace in &mark.paces {
                let times = [
                    Cell::from(format!("{} of {}", pace.families, pace.of)),
                    nanoseconds(pace.ns).into(),
                    nanoseconds(pace.reference).into(),
                    factor(pace.ratio).into(),
                ];
                let asked = if pace.is_loop { "loop" } else { pace.way.name() };
                table.push(head(asked).into_iter().chain(counts.clone()).chain(times).collect());
            }
        }
    }
    table
}
