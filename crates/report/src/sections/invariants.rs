//! Broken invariants: what fails in whole algorithms, under which backend, on how many scenes.
//!
//! The counts of findings tell little here, as one wrong sign can break one check a thousand times. Scenes are counted.

use std::collections::{BTreeMap, BTreeSet};

use super::rank;
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Class, Origin, RunDir};
use predicament_records::format::{length, thousands};

/// A scene, with the number of its queries first: the least is the smallest scene.
type Sized<'r> = (u64, &'r str, &'r str);

/// None where nothing was broken.
pub fn section(runs: &[RunDir]) -> Option<Section> {
    let order = backends(runs);
    let mut sizes: BTreeMap<&str, u64> = BTreeMap::new();
    // How many scenes each backend answered, by task.
    let mut answered: BTreeMap<(&str, usize), BTreeSet<&str>> = BTreeMap::new();
    for row in runs.iter().flat_map(|run| &run.summary) {
        sizes.insert(&row.scene_id, row.queries);
        if row.count(Class::Declined) < row.queries {
            answered.entry((&row.task, rank(&order, &row.backend))).or_default().insert(&row.scene_id);
        }
    }
    let mut broken: BTreeMap<&str, BTreeMap<&str, BTreeMap<usize, BTreeSet<Sized<'_>>>>> = BTreeMap::new();
    for finding in runs.iter().flat_map(|run| &run.findings).filter(|finding| finding.class == Class::Topology) {
        let queries = sizes.get(&*finding.scene_id).copied().unwrap_or(u64::MAX);
        let of_check = broken.entry(&finding.task).or_default().entry(&finding.check).or_default();
        let scenes = of_check.entry(rank(&order, &finding.backend)).or_default();
        scenes.insert((queries, &finding.scene_id, &finding.scene));
    }
    let blocks: Vec<Block> =
        broken.iter().map(|(task, checks)| Block::Table(of_task(task, checks, &order, &answered))).collect();
    (!blocks.is_empty()).then(|| Section {
        id: "invariants",
        title: "Broken invariants",
        lead:
            "Checks of whole answers that failed, and on how many scenes under each backend; the name is that of the \
               smallest of them. Below them, how many scenes the backend answered. A check that only failed after the \
               first recorded findings of a scene is not seen here."
                .to_owned(),
        blocks,
    })
}

fn of_task(
    task: &str,
    checks: &BTreeMap<&str, BTreeMap<usize, BTreeSet<Sized<'_>>>>,
    order: &[&str],
    answered: &BTreeMap<(&str, usize), BTreeSet<&str>>,
) -> Table {
    let of_task = |&backend: &usize| answered.get(&(task, backend)).map_or(0, |scenes| length(scenes.len()));
    let columns: Vec<usize> = (0..order.len()).filter(|backend| of_task(backend) > 0).collect();
    let mut table = Table::new(task)
        .words(["broken"])
        .of(Origin::of("findings.csv")
            .key("broken", "check")
            .across("backend")
            .only("class", "topology")
            .only("task", task))
        .words(columns.iter().map(|&backend| order[backend]));
    for (check, by_backend) in checks {
        let cell = |backend: &usize| match by_backend.get(backend) {
            None => Cell::from("").tone(Tone::Muted),
            Some(scenes) => {
                let smallest = scenes.first().map_or("", |(_, _, scene)| scene);
                Cell::from(thousands(length(scenes.len()))).detail(smallest).tone(Tone::Bad)
            }
        };
        table.push(std::iter::once(Cell::from(*check)).chain(columns.iter().map(cell)).collect());
    }
    let total = columns.iter().map(|backend| Cell::from(thousands(of_task(backend))).tone(Tone::Muted));
    let origin = Origin::of("summary.csv").only("task", task).across("backend");
    table.push_from(origin, std::iter::once(Cell::from("scenes answered").tone(Tone::Muted)).chain(total).collect());
    table
}
