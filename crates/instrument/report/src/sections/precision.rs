//! The section about precision: the bits of each scene, and the arithmetic chosen for each exact predicate.

use std::collections::{BTreeMap, BTreeSet};

use super::{run_head, run_label, some_of};
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Origin, PrecisionRow, RunDir};

/// The maximum number of families that are listed in a line.
const FEW: usize = 4;

/// The scenes of a suite with the same chosen arithmetic.
struct Group<'r> {
    scenes: u64,
    bits: [i32; 2],
    lowest: [i32; 2],
    families: BTreeSet<&'r str>,
}

/// The section, or `None` if no arithmetic was recorded.
pub fn section(runs: &[RunDir]) -> Option<Section> {
    let predicates = PrecisionRow::predicates();
    let mut table = Table::new("")
        .words(run_head(runs))
        .words(["suite", "families"])
        .of(Origin::of("precision.csv").keys(std::iter::once("suite").chain(predicates)))
        .numbers(["scenes", "bits", "lowest bit"])
        .words(predicates);
    for (index, run) in runs.iter().enumerate() {
        let mut groups: Vec<_> = groups(run).into_iter().collect();
        // Within a suite the plane comes before space, then scenes with fewer bits first.
        groups.sort_by_key(|((suite, choices), group)| (*suite, !choices[1].is_empty(), group.bits, *choices));
        for ((suite, choices), group) in groups {
            let cells = [
                suite.into(),
                some_of(group.families.iter().copied().collect::<Vec<_>>().into_iter(), FEW).into(),
                Cell::count(group.scenes),
                range(group.bits).into(),
                range(group.lowest).into(),
            ];
            let choices = choices.map(|name| match name {
                "" => Cell::from("—").tone(Tone::Muted),
                name => name.into(),
            });
            table.push(run_label(runs, index).into_iter().chain(cells).chain(choices).collect());
        }
    }
    (!table.is_empty()).then(|| Section {
        id: "precision",
        title: "Precision plans",
        lead: "Before the first query, the exact backend determines the range of a scene's coordinates. Each \
               coordinate is a multiple of 2 to the power of the lowest bit; \"bits\" is the length of the largest \
               difference in these units. For each predicate of the scene, the backend then chooses the cheapest \
               arithmetic that makes no error. Scenes of a suite with the same choice share a line."
            .to_owned(),
        blocks: vec![Block::Table(table)],
    })
}

/// The scenes of a run by suite and by the arithmetic chosen for the four predicates.
fn groups(run: &RunDir) -> BTreeMap<(&str, [&str; 4]), Group<'_>> {
    let families = run.plan.scenes.iter().map(|s| ([&*s.suite, &*s.scene, &*s.scene_id], &*s.family));
    let families: BTreeMap<[&str; 3], &str> = families.collect();
    let mut groups: BTreeMap<(&str, [&str; 4]), Group> = BTreeMap::new();
    for row in &run.precision {
        let group = groups.entry((&row.suite, row.choices())).or_insert_with(|| Group {
            scenes: 0,
            bits: [row.bits; 2],
            lowest: [row.lowest; 2],
            families: BTreeSet::new(),
        });
        group.scenes += 1;
        group.bits = widened(group.bits, row.bits);
        group.lowest = widened(group.lowest, row.lowest);
        group.families.extend(families.get(&[&*row.suite, &*row.scene, &*row.scene_id]));
    }
    groups
}

fn widened([least, most]: [i32; 2], with: i32) -> [i32; 2] {
    [least.min(with), most.max(with)]
}

/// A range of numbers in words: `7`, `−52`, `7 to 61`.
fn range([least, most]: [i32; 2]) -> String {
    let text = if least == most { least.to_string() } else { format!("{least} to {most}") };
    text.replace('-', "−")
}
