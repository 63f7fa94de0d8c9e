//! Wrong answers by degeneracy of queries, and the bit length of answers.

use crate::folder::FolderError;
use predicament_predicates::PredicateKind;
use predicament_report::{Cell, Table};
use predicament_tasks::Kind;

use super::files::Files;
use crate::compare::conditioning::{BIN, ZERO};
use crate::compare::words::{counted, listed, percents};
use crate::compare::{Conditioned, REFERENCE, Share, ranking};

/// The bins in which backends are wrong, and the backends that are never wrong.
pub(super) fn wrong(files: &Files) -> Result<String, FolderError> {
    let rows = files.conditioning()?;
    let (mut tasks, mut backends): (Vec<&str>, Vec<&str>) = Default::default();
    for row in &rows {
        if !tasks.contains(&row.task.as_str()) {
            tasks.push(&row.task);
        }
        if !backends.contains(&row.backend.as_str()) {
            backends.push(&row.backend);
        }
    }
    let of = |backend: &str, is: &dyn Fn(&&Conditioned) -> bool| -> Share {
        let own = rows.iter().filter(|row| row.backend == backend).filter(is);
        own.fold(Share::default(), |sum, row| Share { count: sum.count + row.wrong, of: sum.of + row.answers })
    };
    let (never, wrong): (Vec<&str>, Vec<&str>) = backends.iter().partition(|backend| of(backend, &|_| true).count == 0);
    let mut page = String::new();
    if !wrong.is_empty() {
        let mut table = Table::new("").words(["predicate"]).numbers(wrong.iter().copied());
        for task in tasks {
            let cells = wrong.iter().map(|backend| Cell::from(cell(&rows, task, backend)));
            table.push(std::iter::once(Cell::from(task)).chain(cells).collect());
        }
        page += &ranking::markdown(table);
        page += "\n\nEach cell has the largest |det| / permanent at which an answer is wrong, the wrong answers in the worst bin of four binary digits, and the wrong answers for exact zeros. Each share has its interval.\n\n";
    }
    if !never.is_empty() {
        let of = |backend: &&str| {
            let share = of(backend, &|_| true);
            format!("`{backend}` ({}, {})", counted(share), percents(share))
        };
        page += &format!("Never wrong: {}.", listed(&never.iter().map(of).collect::<Vec<_>>()));
    }
    Ok(page)
}

fn cell(rows: &[Conditioned], task: &str, backend: &str) -> String {
    let own = || rows.iter().filter(|row| row.task == task && row.backend == backend);
    let share = |row: &Conditioned| Share { count: row.wrong, of: row.answers };
    let wrong = own().filter(|row| row.log2_relative_det > ZERO && row.wrong > 0);
    let upper = wrong.clone().map(|row| row.log2_relative_det + BIN).max();
    let worst = wrong.max_by(|a, b| a.share.total_cmp(&b.share));
    let zeros = own().find(|row| row.log2_relative_det == ZERO).map(share);
    let mut text = match (upper, worst.map(share)) {
        (Some(upper), Some(worst)) => format!("up to 2^{upper}; {} ({})", counted(worst), percents(worst)),
        _ => "nowhere".to_owned(),
    };
    if let Some(zeros) = zeros {
        text += &format!("; zeros {} ({})", counted(zeros), percents(zeros));
    }
    text
}

/// The bits of the widest arithmetic that settled an answer of the reference, for the predicates.
pub(super) fn bits(files: &Files) -> Result<String, FolderError> {
    let measures = files.measures()?;
    let mut table = Table::new("").words(["predicate"]).numbers(Kind::ALL.map(Kind::name));
    for task in PredicateKind::DETERMINANTS.map(PredicateKind::name) {
        let cells = Kind::ALL.map(|kind| {
            let is = |row: &&crate::compare::Measure| {
                [&*row.task, &row.kind, &row.backend, &row.measure] == [task, kind.name(), REFERENCE, "bits"]
            };
            Some(Cell::from(format!("{:.0}", measures.iter().find(is)?.value)))
        });
        let cells: Option<Vec<Cell>> = cells.into_iter().collect();
        let cells = cells.ok_or_else(|| FolderError::Lacks {
            file: "compare.csv",
            what: format!("bits of {REFERENCE} on {task}"),
        })?;
        table.push(std::iter::once(Cell::from(task)).chain(cells).collect());
    }
    Ok(ranking::markdown(table))
}
