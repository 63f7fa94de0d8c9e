//! The section about decimals: the same answers, compared with the doubles and with the numbers that were written.

use std::collections::BTreeMap;

use predicament_records::format::percent;
use predicament_records::{DecimalsRow, RunDir};

use super::{rank, run_head, run_label};
use crate::groups::backends;
use crate::table::{Block, Cell, Section, Table};
use crate::{Error, Origin};

/// Sums of the counts of a row: answers, doubles, written, ties, ties found.
type Sums = [u64; 5];

/// The section, or `None` if no scene has a truth of decimals.
pub fn section(runs: &[RunDir]) -> Result<Option<Section>, Error> {
    let order = backends(runs);
    let mut table = Table::new("")
        .words(run_head(runs))
        .words(["suite", "task", "family", "backend"])
        .of(Origin::of("decimals.csv").keys(["suite", "task", "family", "backend"]))
        .numbers(["answers", "right about the doubles", "right about the decimals", "ties found", "other signs found"]);
    for (index, run) in runs.iter().enumerate() {
        let mut groups: BTreeMap<(String, String, String, usize), Sums> = BTreeMap::new();
        for row in run.rows::<DecimalsRow>()?.iter() {
            let key = (row.suite.clone(), row.task.clone(), row.family.clone(), rank(&order, &row.backend));
            let counts = [row.answers, row.doubles, row.written, row.ties, row.ties_found];
            groups.entry(key).or_default().iter_mut().zip(counts).for_each(|(sum, count)| *sum += count);
        }
        for ((suite, task, family, backend), [answers, doubles, written, ties, found]) in groups {
            let share = |part: u64, whole: u64| Cell::from(percent(part, whole));
            let signs = if ties == 0 { 0 } else { answers - ties };
            let cells = [
                suite.into(),
                task.into(),
                family.into(),
                order[backend].into(),
                Cell::count(answers),
                share(doubles, answers),
                share(written, answers),
                share(found, ties),
                share(written.saturating_sub(found), signs),
            ];
            table.push(run_label(runs, index).into_iter().chain(cells).collect());
        }
    }
    Ok((!table.is_empty()).then(|| Section {
        id: "decimals",
        title: "What was written",
        lead: "Scenes with `truth = \"decimals\"` are judged twice. Each backend gets the nearest doubles of the \
               decimals, and its promise is about the doubles. Its user may mean the decimals. A tie is a sign that is \
               zero by the decimals; the last columns separate ties and other signs, because an answer of zero for \
               everything would find all ties."
            .to_owned(),
        blocks: vec![Block::Table(table)],
    }))
}
