//! The section on broken invariants of whole algorithms, by check and backend, in numbers of scenes. Checks that fail
//! only by rounding are listed separately.
//!
//! Numbers of findings mean little here, as one wrong sign can break one check a thousand times. So scenes are counted.

use std::collections::{BTreeMap, BTreeSet};

use super::rank;
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Class, FindingRow, Origin, RunDir};
use predicament_records::format::{length, thousands};

/// A scene, with the number of its queries first, so that the minimum is the smallest scene.
type Sized<'r> = (u64, &'r str, &'r str);

/// The scenes on which a check failed, by check and by the index of the backend.
type Checks<'r> = BTreeMap<&'r str, BTreeMap<usize, BTreeSet<Sized<'r>>>>;

/// The section, or `None` if nothing was broken.
pub fn section(runs: &[RunDir]) -> Option<Section> {
    let order = backends(runs);
    let mut sizes: BTreeMap<&str, u64> = BTreeMap::new();
    // The scenes that each backend answered, by task.
    let mut answered: BTreeMap<(&str, usize), BTreeSet<&str>> = BTreeMap::new();
    for row in runs.iter().flat_map(|run| &run.summary) {
        sizes.insert(&row.scene_id, row.queries);
        if row.count(Class::Declined) < row.queries {
            answered.entry((&row.task, rank(&order, &row.backend))).or_default().insert(&row.scene_id);
        }
    }
    let mut broken: BTreeMap<(&str, Class), Checks<'_>> = BTreeMap::new();
    let is_law = |finding: &&FindingRow| [Class::Topology, Class::Rounded].contains(&finding.class);
    for finding in runs.iter().flat_map(|run| &run.findings).filter(is_law) {
        let queries = sizes.get(&*finding.scene_id).copied().unwrap_or(u64::MAX);
        let of_check = broken.entry((&finding.task, finding.class)).or_default().entry(&finding.check).or_default();
        let scenes = of_check.entry(rank(&order, &finding.backend)).or_default();
        scenes.insert((queries, &finding.scene_id, &finding.scene));
    }
    let table = |(of, checks)| Block::Table(of_task(of, checks, &order, &answered));
    let blocks: Vec<Block> = broken.iter().map(table).collect();
    (!blocks.is_empty()).then(|| Section {
        id: "invariants",
        title: "Broken invariants",
        lead: "Failed checks of whole answers: the number of scenes by backend, and the name of the smallest such \
             scene. The last row has the number of scenes that the backend answered. Laws that only the rounding of \
             coordinates violates have separate tables. A check is missing here if it failed only after the first \
             recorded findings of a scene."
            .to_owned(),
        blocks,
    })
}

fn of_task(
    &(task, class): &(&str, Class),
    checks: &Checks<'_>,
    order: &[&str],
    answered: &BTreeMap<(&str, usize), BTreeSet<&str>>,
) -> Table {
    let of_task = |&backend: &usize| answered.get(&(task, backend)).map_or(0, |scenes| length(scenes.len()));
    let columns: Vec<usize> = (0..order.len()).filter(|backend| of_task(backend) > 0).collect();
    let (title, failed, tone) = match class {
        Class::Rounded => (format!("{task}, by rounding alone"), "rounded", Tone::Notable),
        _ => (task.to_owned(), "broken", Tone::Bad),
    };
    let mut table = Table::new(title)
        .words([failed])
        .of(Origin::of("findings.csv")
            .key(failed, "check")
            .across("backend")
            .only("class", class.name())
            .only("task", task))
        .words(columns.iter().map(|&backend| order[backend]));
    for (check, by_backend) in checks {
        let cell = |backend: &usize| match by_backend.get(backend) {
            None => Cell::from("").tone(Tone::Muted),
            Some(scenes) => {
                let smallest = scenes.first().map_or("", |(_, _, scene)| scene);
                Cell::from(thousands(length(scenes.len()))).detail(smallest).tone(tone)
            }
        };
        table.push(std::iter::once(Cell::from(*check)).chain(columns.iter().map(cell)).collect());
    }
    let total = columns.iter().map(|backend| Cell::from(thousands(of_task(backend))).tone(Tone::Muted));
    let origin = Origin::of("summary.csv").only("task", task).across("backend");
    table.push_from(origin, std::iter::once(Cell::from("scenes answered").tone(Tone::Muted)).chain(total).collect());
    table
}
