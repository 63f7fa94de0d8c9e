//! The section about times per query, as ratios to the reference in the same run.

use std::collections::BTreeSet;

use super::{run_head, run_label};
use crate::groups::{REFERENCE, Timing, backends, timings};
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Origin, RunDir};
use predicament_records::format::{factor, nanoseconds};

/// The section, or `None` if nothing was timed.
pub fn section(runs: &[RunDir]) -> Option<Section> {
    let timings: Vec<_> = runs.iter().map(timings).collect();
    let timed: BTreeSet<&str> = timings.iter().flat_map(|t| t.keys()).map(|(_, _, backend, _)| *backend).collect();
    let columns: Vec<&str> = backends(runs).into_iter().filter(|backend| timed.contains(backend)).collect();

    let mut table = Table::new("")
        .basis(format!("ns per query: median (smallest to largest sample, multiple of {REFERENCE}'s)"))
        .words(run_head(runs))
        .words(["task", "family", "asked"])
        .of(Origin::of("throughput.csv").keys(["task", "family"]).across("backend"))
        .numbers(columns.iter().copied());
    for (index, timings) in timings.iter().enumerate() {
        let groups: BTreeSet<_> = timings.keys().map(|(task, family, _, way)| (*task, *family, *way)).collect();
        for (task, family, way) in groups {
            let reference = timings.get(&(task, family, REFERENCE, way));
            let of_family = || columns.iter().map(|&backend| timings.get(&(task, family, backend, way)));
            let scenes = of_family().flatten().map(|timing| timing.scenes).max().unwrap_or(0);
            let cells = of_family().map(|timing| match timing {
                None => Cell::from("—").tone(Tone::Muted),
                Some(timing) => cell(timing, reference, scenes),
            });
            let labels = run_label(runs, index).into_iter().chain([task.into(), family.into(), way.name().into()]);
            table.push(labels.chain(cells).collect());
        }
    }

    if table.is_empty() {
        return None;
    }
    let mut versions: BTreeSet<(&str, &str)> = BTreeSet::new();
    for timings in &timings {
        for ((_, _, backend, _), timing) in timings {
            versions.extend(timing.versions.iter().map(|version| (*backend, *version)));
        }
    }
    let versions: Vec<String> = versions.iter().map(|(backend, version)| format!("{backend} {version}")).collect();
    let versions = Block::Note(format!("Engine versions: {}.", versions.join(", ")), Tone::Muted);
    Some(Section {
        id: "throughput",
        title: "Throughput",
        lead: format!(
            "Nanoseconds per query: the median of the samples, then the smallest and largest sample. A family with \
             several scenes shows the geometric mean of their medians. The median is also given as a multiple of \
             {REFERENCE}'s in the same run, if both were timed on equally many scenes. Only verified answers are \
             timed. \"asked\" is the interface: single queries, batches (\"loop\" if the backend does not have its \
             own batches), or the answer to a whole scene."
        ),
        blocks: vec![Block::Table(table), versions],
    })
}

/// The time of a backend on a family with this number of scenes; as a ratio only if the same scenes were timed.
fn cell(timing: &Timing, reference: Option<&Timing>, scenes: usize) -> Cell {
    let spread = timing.spread;
    let mut detail = format!("{}–{}", nanoseconds(spread.min), nanoseconds(spread.max));
    if timing.scenes < scenes {
        detail += &format!(" · {} of {scenes} scenes", timing.scenes);
    }
    if timing.is_loop {
        detail += " · loop";
    }
    if let Some(reference) = reference.filter(|reference| reference.scenes == timing.scenes) {
        detail += &format!(" · {}", factor(spread.median / reference.spread.median));
    }
    Cell::from(nanoseconds(spread.median)).detail(detail)
}
