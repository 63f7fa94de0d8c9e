//! The section about times per query, as ratios to the reference in the same run.

use std::collections::BTreeSet;

use super::{run_head, run_label};
use crate::groups::{REFERENCE, Timing, backends, timings};
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Origin, RunDir};
use predicament_records::format::{factor, nanoseconds};

pub fn section(runs: &[RunDir]) -> Section {
    let timings: Vec<_> = runs.iter().map(timings).collect();
    let timed: BTreeSet<&str> = timings.iter().flat_map(|t| t.keys()).map(|[_, _, backend]| *backend).collect();
    let columns: Vec<&str> = backends(runs).into_iter().filter(|backend| timed.contains(backend)).collect();

    let mut table = Table::new("")
        .words(run_head(runs))
        .words(["task", "family"])
        .of(Origin::of("throughput.csv").keys(["task", "family"]).across("backend"))
        .numbers(columns.iter().copied());
    for (index, timings) in timings.iter().enumerate() {
        let groups: BTreeSet<[&str; 2]> = timings.keys().map(|[task, family, _]| [*task, *family]).collect();
        for [task, family] in groups {
            let reference = timings.get(&[task, family, REFERENCE]);
            let of_family = || columns.iter().map(|backend| timings.get(&[task, family, backend]));
            let scenes = of_family().flatten().map(|timing| timing.scenes).max().unwrap_or(0);
            let cells = of_family().map(|timing| match timing {
                None => Cell::from("—").tone(Tone::Muted),
                Some(timing) => cell(timing, reference, scenes),
            });
            let labels = run_label(runs, index).into_iter().chain([task.into(), family.into()]);
            table.push(labels.chain(cells).collect());
        }
    }

    let mut blocks = Vec::new();
    if table.is_empty() {
        blocks.push(Block::Note("Nothing was timed.".to_owned(), Tone::Notable));
    } else {
        blocks.push(Block::Table(table));
        let mut versions: BTreeSet<(&str, &str)> = BTreeSet::new();
        for timings in &timings {
            for ([_, _, backend], timing) in timings {
                versions.extend(timing.versions.iter().map(|version| (*backend, *version)));
            }
        }
        let versions: Vec<String> = versions.iter().map(|(backend, version)| format!("{backend} {version}")).collect();
        blocks.push(Block::Note(format!("Engine versions: {}.", versions.join(", ")), Tone::Muted));
    }
    Section {
        id: "throughput",
        title: "Throughput",
        lead: format!(
            "Nanoseconds per query: the median of the samples (of several scenes of a family the geometric mean of their \
             medians), then the smallest and largest sample, and the median as a multiple of {REFERENCE}'s in the same \
             run, where it was timed on as many scenes. Only verified answers are timed."
        ),
        blocks,
    }
}

/// The time of a backend on a family of so many scenes; as a multiple only where the same scenes were timed.
fn cell(timing: &Timing, reference: Option<&Timing>, scenes: usize) -> Cell {
    let spread = timing.spread;
    let mut detail = format!("{}–{}", nanoseconds(spread.min), nanoseconds(spread.max));
    if timing.scenes < scenes {
        detail += &format!(" · {} of {scenes} scenes", timing.scenes);
    }
    if let Some(reference) = reference.filter(|reference| reference.scenes == timing.scenes) {
        detail += &format!(" · {}", factor(spread.median / reference.spread.median));
    }
    Cell::from(nanoseconds(spread.median)).detail(detail)
}
