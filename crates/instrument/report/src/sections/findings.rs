//! The section of findings: a few of each class, with their ids.

use std::collections::BTreeMap;

use super::{rank, run_head, run_label};
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Class, FindingRow, Origin, RunDir};
use predicament_records::format::{counted, length, significant, thousands};

/// The maximum number of findings of a class that are shown for each backend.
const FEW: usize = 3;

/// The section, or `None` if there are no findings.
pub fn section(runs: &[RunDir]) -> Option<Section> {
    let order = backends(runs);
    let mut blocks = Vec::new();
    for (index, run) in runs.iter().enumerate() {
        if let Some(example) = run.findings.iter().map(|finding| &*finding.finding_id).min() {
            let number = if runs.len() > 1 { format!(" of run {}", index + 1) } else { String::new() };
            blocks.push(Block::Note(format!("To repeat a finding{number}:"), Tone::Plain));
            blocks.push(Block::Command(format!("predicament replay {example} --run {}", run.path.display())));
        }
    }
    for class in Class::ALL {
        let table = few_of(runs, class, &order);
        if !table.is_empty() {
            blocks.push(Block::Table(table));
        }
    }
    (!blocks.is_empty()).then(|| Section {
        id: "findings",
        title: "Findings",
        lead: format!(
            "In a browser you can search and select all findings; some show their points, a picture, and the answer \
             of each backend. Tables show the first {FEW} findings of each class for each backend; findings.csv has \
             more. The degeneracy is log2 of |determinant| / permanent: lower values are nearer to a tie, and −∞ is \
             an exact tie. Distances are in units of L, the largest extent of the scene."
        ),
        blocks,
    })
}

fn few_of(runs: &[RunDir], class: Class, order: &[&str]) -> Table {
    let mut groups: BTreeMap<(usize, usize), Vec<&FindingRow>> = BTreeMap::new();
    for (index, run) in runs.iter().enumerate() {
        for finding in run.findings.iter().filter(|finding| finding.class == class) {
            groups.entry((index, rank(order, &finding.backend))).or_default().push(finding);
        }
    }
    let recorded: usize = groups.values().map(Vec::len).sum();
    let counted_in_all: u64 = runs.iter().flat_map(|run| &run.summary).map(|row| row.count(class)).sum();
    let caption =
        format!("{class}: {} recorded of {}", counted(length(recorded), "finding"), thousands(counted_in_all));

    let mut table = Table::new(caption)
        .words(run_head(runs))
        .of(Origin::of("findings.csv").keys(["finding"]))
        .words(["finding", "backend", "scene", "task", "check", "query", "got", "truth"])
        .numbers(["degeneracy", "distance / L"])
        .words(["stage"]);
    for ((index, _), mut findings) in groups {
        findings.sort_by_key(|f| [&f.suite, &f.scene, &f.scene_id, &f.task, &f.finding_id]);
        for f in findings.into_iter().take(FEW) {
            let cells = [
                Cell::code(&*f.finding_id),
                f.backend.as_str().into(),
                Cell::from(f.scene.as_str()).detail(&*f.suite),
                f.task.as_str().into(),
                f.check.as_str().into(),
                Cell::code(&*f.query),
                Cell::code(&*f.got),
                Cell::code(&*f.truth),
                degeneracy(f.log2_relative_det).into(),
                f.distance_over_l.map_or_else(String::new, |d| significant(d, 2)).into(),
                f.stage.as_str().into(),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    table
}

fn degeneracy(log2: Option<f64>) -> String {
    match log2 {
        None => String::new(),
        Some(f64::NEG_INFINITY) => "−∞".to_owned(),
        Some(log2) => format!("{log2:.1}").replace('-', "−"),
    }
}
