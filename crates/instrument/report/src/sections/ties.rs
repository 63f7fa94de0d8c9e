//! The section on ties that a perturbation broke: their number, the depth of the deciding term, and the cost.

use std::collections::BTreeMap;

use super::glance::time;
use super::rank;
use crate::groups::{Times, backends};
use crate::plot::{Bars, histogram};
use crate::rungs::rung;
use crate::table::{Block, Cell, Section, Table};
use crate::{Error, Origin, RunDir};
use predicament_records::approximately;
use predicament_records::format::percent;

/// The backend that tie breaking is compared with.
const UNPERTURBED: &str = "exact";

/// The ranges of positions of deciding terms: up to each of these, and beyond.
const PLACES: [u64; 7] = [1, 2, 3, 4, 8, 16, u64::MAX];
const PLACE_NAMES: [&str; 7] = ["1", "2", "3", "4", "5 to 8", "9 to 16", "17 on"];
/// The degrees of deciding monomials, for constructed vertices.
const DEGREES: [&str; 4] = ["degree 1", "degree 2", "degree 3", "degree 4 or more"];

/// The ties of one task on one backend.
#[derive(Clone, Default)]
struct Ties {
    queries: u64,
    broken: u64,
    /// The numbers of queries by the position of the deciding term.
    places: [u64; PLACES.len()],
    /// The numbers of queries by the degree of the deciding monomial.
    degrees: [u64; DEGREES.len()],
    deepest: u64,
}

impl Ties {
    fn add_stage(&mut self, stage: &str, settled: u64) {
        if let Some(at) = DEGREES.iter().position(|degree| *degree == stage) {
            self.degrees[at] += settled;
        } else if let ("term", Some(term)) = rung(stage) {
            let at = PLACES.iter().position(|&last| term <= last).unwrap_or(PLACES.len() - 1);
            self.places[at] += settled;
            self.deepest = self.deepest.max(term);
        }
    }

    fn is_empty(&self) -> bool {
        self.broken == 0 && self.places.iter().chain(&self.degrees).all(|&settled| settled == 0)
    }
}

/// The section, or `None` if no tie was broken.
pub fn section(runs: &[RunDir], times: &Times) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("Ties, and time relative to exact on the same families")
        .words(["task", "backend"])
        .of(Origin::of("summary.csv").keys(["task", "backend"]))
        .numbers(["queries", "ties", "share"])
        .of(Origin::of("stages.csv").keys(["task", "backend"]))
        .numbers(["deepest term"])
        .of(Origin::of("throughput.csv").keys(["task", "backend"]))
        .numbers([format!("time / {UNPERTURBED}")]);
    let mut depths = Table::new("The deciding term, over all queries of algorithms and laws")
        .words(["task", "backend"])
        .of(Origin::of("stages.csv").keys(["task", "backend"]))
        .numbers(PLACE_NAMES.map(|place| format!("term {place}")))
        .numbers(DEGREES);
    let mut pictured: BTreeMap<usize, [u64; PLACES.len()]> = BTreeMap::new();
    // Over all folders: one may contain the answers and another the stages that settled them.
    let mut groups: BTreeMap<(&str, usize), Ties> = BTreeMap::new();
    for run in runs {
        for row in &run.summary {
            let ties = groups.entry((&row.task, rank(&order, &row.backend))).or_default();
            ties.queries += row.queries;
            ties.broken += row.tie_broken;
        }
        for row in &run.stages {
            groups.entry((&row.task, rank(&order, &row.backend))).or_default().add_stage(&row.stage, row.settled);
        }
    }
    groups.retain(|_, ties| !ties.is_empty());
    for ((task, backend), ties) in groups {
        let name = order[backend];
        let deepest = if ties.deepest == 0 { Cell::default() } else { Cell::count(ties.deepest) };
        let cells = [task.into(), name.into(), Cell::count(ties.queries), Cell::count(ties.broken)].into_iter();
        let cost = time(times.pace_on(name, UNPERTURBED, task).as_ref());
        table.push(cells.chain([percent(ties.broken, ties.queries).into(), deepest, cost]).collect());
        if ties.places.iter().chain(&ties.degrees).all(|&settled| settled == 0) {
            continue;
        }
        let counts = ties.places.iter().chain(&ties.degrees).map(|&settled| Cell::count(settled));
        depths.push([task.into(), name.into()].into_iter().chain(counts).collect());
        let all = pictured.entry(backend).or_default();
        all.iter_mut().zip(ties.places).for_each(|(all, settled)| *all += settled);
    }
    if table.is_empty() {
        return Ok(None);
    }
    let series = pictured.into_iter().map(|(backend, places)| {
        (order.get(backend).copied().unwrap_or_default().to_owned(), places.map(approximately).to_vec())
    });
    let bars = Bars {
        x: "position of the deciding term".to_owned(),
        y: "questions".to_owned(),
        places: PLACE_NAMES.map(str::to_owned).to_vec(),
        series: series.collect(),
    };
    let mut blocks = vec![Block::Table(table)];
    if let Some(picture) = histogram(&bars)? {
        let alt = "Number of queries that the first, second, … term of the perturbation decided, over all tasks";
        blocks.push(Block::Plot { picture, file: "ties.svg".into(), alt: alt.into() });
    }
    blocks.push(Block::Table(depths));
    Ok(Some(Section {
        id: "ties",
        title: "Ties",
        lead: "If the exact answer is zero, a symbolic perturbation evaluates its terms, largest first, until a term \
             is not zero. The time relative to exact is the geometric mean of the ratios in one run, over the \
             families of the task that both were timed on."
            .to_owned(),
        blocks,
    }))
}
