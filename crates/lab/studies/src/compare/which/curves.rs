//! Backends that differ in one parameter.

use crate::folder::FolderError;
use predicament_predicates::PredicateKind;
use predicament_report::{Cell, Table};
use predicament_tasks::Kind;

use super::files::Files;
use crate::compare::standing::backends;
use crate::compare::words::{counted, percents};
use crate::compare::{Standing, inputs_of, ranking, table};

fn lacks(what: &str) -> FolderError {
    FolderError::Lacks { file: "curves/compare.csv", what: what.to_owned() }
}

/// The members of curves, over the inputs that all members answered.
pub(super) fn curves(files: &Files) -> Result<String, FolderError> {
    table::curves(&files.curves()?).ok_or_else(|| lacks("two backends that differ in one parameter"))
}

/// The stages of exact arithmetic: wrong answers of the predicates by the number of stages.
pub(super) fn stages(files: &Files) -> Result<String, FolderError> {
    let measures = files.curves()?;
    let is_predicate = |task: &str| PredicateKind::DETERMINANTS.iter().any(|kind| kind.name() == task);
    let inputs: Vec<_> = inputs_of(&measures)
        .into_iter()
        .map(|(input, _)| input)
        .filter(|[task, kind, _]| is_predicate(task) && *kind != Kind::General.name())
        .collect();
    let members: Vec<&str> =
        backends(&measures).into_iter().filter(|backend| backend.starts_with("exact:stages=")).collect();
    if members.is_empty() || inputs.is_empty() {
        return Err(lacks("`exact:stages=K` on nearly degenerate predicates"));
    }
    let mut table =
        Table::new("").words(["backend"]).numbers(inputs.iter().map(|[task, kind, _]| format!("{task}, {kind}")));
    for backend in members {
        let cells = inputs.iter().map(|input| {
            let answers = Standing::of(&measures, backend, |other| other == input).answers;
            Cell::from(counted(answers)).detail(percents(answers))
        });
        table.push(std::iter::once(Cell::code(backend)).chain(cells).collect());
    }
    Ok(format!("{}\n\nWrong answers out of all answers, with the interval of the share.", ranking::markdown(table)))
}
