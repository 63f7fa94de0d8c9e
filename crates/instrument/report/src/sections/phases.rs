//! The section about the phases of algorithms: their times, and the growth of these with the size of a scene.

use std::collections::{BTreeMap, BTreeSet};

use super::{rank, run_head, run_label};
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Curve, Curves, Error, Origin, RunDir, curves};
use predicament_records::format::{nanoseconds, significant, thousands};
use predicament_records::{PhaseRow, Spread, approximately};

/// A phase of a scene on a number of threads, and its samples.
struct Timed<'r> {
    first: &'r PhaseRow,
    /// The index of the first sample's row.
    at: usize,
    spread: Spread,
}

/// The section, or `None` if no phase was timed.
pub fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("")
        .words(run_head(runs))
        .words(["task", "scene"])
        .of(Origin::of("phases.csv").keys(["task", "scene", "phase", "backend", "threads"]).under("scene", "suite"))
        .numbers(["size"])
        .words(["phase", "backend"])
        .numbers(["threads", "ns", "bytes"]);
    let mut plots: Vec<(String, Curves)> = Vec::new();
    for (index, run) in runs.iter().enumerate() {
        let rows = run.rows::<PhaseRow>()?;
        let timed = timed(&rows, &order);
        for Timed { first, spread, .. } in &timed {
            let none = || Cell::from("—").tone(Tone::Muted);
            let each = |bytes: u64| significant(approximately(bytes) / approximately(first.count), 3);
            let cells = [
                first.task.as_str().into(),
                Cell::from(first.scene.as_str()).detail(&*first.suite),
                Cell::from(thousands(first.size)),
                Cell::from(first.phase.as_str()).detail(format!("a {}", first.unit)),
                if first.backend.is_empty() { none() } else { first.backend.as_str().into() },
                Cell::count(first.threads),
                Cell::from(nanoseconds(spread.median)).detail(format!(
                    "{}–{}",
                    nanoseconds(spread.min),
                    nanoseconds(spread.max)
                )),
                first.bytes.map_or_else(none, |bytes| each(bytes).into()),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
        let label = |name: String| if runs.len() > 1 { format!("{}: {name}", index + 1) } else { name };
        for (of, phase, points) in growth(&timed) {
            let at = plots.iter().position(|(known, _)| *known == of).unwrap_or_else(|| {
                plots.push((of, Curves { x: "size of the scene".into(), y: "ns".into(), ..Curves::default() }));
                plots.len() - 1
            });
            plots[at].1.curves.push(Curve::new(label(phase), points));
        }
    }
    if table.is_empty() {
        return Ok(None);
    }
    let mut blocks = Vec::new();
    for (of, lines) in plots {
        let alt = format!("{of}: nanoseconds of each phase over the size of the scene");
        let file = format!("growth-{}.svg", of.replace([':', ' ', ',', '/'], "-").replace("--", "-"));
        let plot = |picture| Block::Plot { picture, file: file.into(), alt: alt.into() };
        blocks.extend(curves(&lines)?.map(plot));
    }
    blocks.push(Block::Table(table));
    Ok(Some(Section {
        id: "phases",
        title: "Phases",
        lead: "Time and memory of each phase of an algorithm, per unit that the phase counts: the median, smallest \
               and largest sample, and the memory of the phase's result. Phases without a backend do not call \
               predicates. Scenes of different sizes whose names differ only after the last dash form a series. Each \
               series has a plot for each backend, with times on one thread."
            .to_owned(),
        blocks,
    }))
}

/// The phases in the order of scenes, sizes and backends; within these, in the order of their first rows.
fn timed<'r>(rows: &'r [PhaseRow], order: &[&str]) -> Vec<Timed<'r>> {
    let mut samples: BTreeMap<_, Vec<(usize, &PhaseRow)>> = BTreeMap::new();
    for (at, row) in rows.iter().enumerate() {
        let key = ([&row.suite, &row.task, &row.scene, &row.scene_id, &row.backend, &row.phase], row.threads);
        samples.entry(key).or_default().push((at, row));
    }
    let spread = |rows: &[(usize, &PhaseRow)]| Spread::of(rows.iter().map(|(_, row)| row.ns_per_unit));
    let of_samples = |rows: Vec<(usize, &'r PhaseRow)>| {
        let (at, first) = rows[0];
        Some(Timed { first, at, spread: spread(&rows)? })
    };
    let mut timed: Vec<Timed<'_>> = samples.into_values().filter_map(of_samples).collect();
    timed.sort_by_key(|&Timed { first: row, at, .. }| {
        let backend = if row.backend.is_empty() { 0 } else { 1 + rank(order, &row.backend) };
        ((&row.suite, &row.task, series(row), row.size, &row.scene), backend, row.threads, at)
    });
    timed
}

/// The series of a scene: names of scenes that differ only in size differ only after the last dash.
fn series(row: &PhaseRow) -> &str {
    row.scene.rsplit_once('-').map_or(&row.scene, |(stem, _)| stem)
}

/// The minimum number of sizes for a plot of growth.
const FEWEST: usize = 3;

/// A line of a plot: the plot, the line's name, and its points.
type Line = (String, String, Vec<(f64, f64)>);

/// Times on one thread by size, for each series of at least three sizes with its backend: the phases and their points.
fn growth(timed: &[Timed<'_>]) -> Vec<Line> {
    let of = |row: &'_ PhaseRow| [row.suite.clone(), row.task.clone(), series(row).to_owned()];
    let mut sizes: BTreeMap<_, BTreeSet<u64>> = BTreeMap::new();
    for Timed { first, .. } in timed {
        sizes.entry(of(first)).or_default().insert(first.size);
    }
    sizes.retain(|_, sizes| sizes.len() >= FEWEST);
    let mut lines: Vec<Line> = Vec::new();
    for Timed { first, spread, .. } in timed {
        if first.threads > 1 || !sizes.contains_key(&of(first)) {
            continue;
        }
        let mut plot = format!("{} {}", first.task, series(first));
        if !first.backend.is_empty() {
            plot += &format!(", {}", first.backend);
        }
        let phase = format!("{}, a {}", first.phase, first.unit);
        let point = (approximately(first.size), spread.median);
        match lines.iter_mut().find(|(of, name, _)| *of == plot && *name == phase) {
            Some((_, _, points)) => points.push(point),
            None => lines.push((plot, phase, vec![point])),
        }
    }
    lines
}
