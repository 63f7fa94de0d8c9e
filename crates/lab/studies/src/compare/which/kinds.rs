//! Each backend on each input of a kind: its time ratio to the reference, and its errors.

use crate::folder::FolderError;
use predicament_report::{Cell, Table};
use predicament_tasks::Kind;

use super::files::Files;
use crate::compare::standing::{backends, time_ratio};
use crate::compare::words::{counted, percents, scenes};
use crate::compare::{InputKey, Measure, REFERENCE, Share, Standing, inputs_of, ranking};
use predicament_records::format::significant;

pub(super) fn general(files: &Files) -> Result<String, FolderError> {
    table(files, Kind::General)
}

pub(super) fn near(files: &Files) -> Result<String, FolderError> {
    table(files, Kind::Near)
}

pub(super) fn degenerate(files: &Files) -> Result<String, FolderError> {
    table(files, Kind::Degenerate)
}

fn table(files: &Files, kind: Kind) -> Result<String, FolderError> {
    let measures = files.measures()?;
    let backends = backends(&measures);
    let inputs = inputs_of(&measures).into_iter().filter(|([_, of, _], _)| *of == kind.name());
    let mut table = Table::new("").words(["input"]).numbers(backends.iter().copied());
    for (of, n) in inputs {
        let [task, _, family] = of;
        let name = format!("{task}, {family} ({})", scenes(n));
        let cells = backends.iter().map(|backend| Cell::from(cell(&measures, backend, &of)));
        table.push(std::iter::once(Cell::from(name)).chain(cells).collect());
    }
    if table.is_empty() {
        return Err(FolderError::Lacks { file: "compare.csv", what: format!("{} input", kind.name()) });
    }
    Ok(format!(
        "{}\n\nThe first number is the time of one scene divided by the time of {REFERENCE}; – if one of them was not timed. Then follow the failures among the backend's own answers and scenes: w wrong answers, t scenes with a broken law, \
         r scenes that are off by rounding only, n scenes that are not done. Intervals are Wilson's at 95 %.",
        ranking::markdown(table)
    ))
}

fn cell(measures: &[Measure], backend: &str, of: &InputKey<'_>) -> String {
    let standing = Standing::of(measures, backend, |other| other == of);
    let counts = standing.scenes;
    if counts.asked == counts.not_done {
        return "not done".to_owned();
    }
    let time = time_ratio(measures, backend, of).map_or("–".to_owned(), |ratio| significant(ratio, 3));
    let part = |letter: &str, share: Share, with_interval: bool| {
        let interval = if with_interval { format!(" ({})", percents(share)) } else { String::new() };
        (share.count > 0).then(|| format!("; {letter} {}{interval}", counted(share)))
    };
    let answered = counts.asked - counts.not_done;
    let parts = [
        part("w", standing.answers, true),
        part("t", standing.laws, true),
        part("r", Share { count: counts.rounded, of: answered }, false),
        part("n", Share { count: counts.not_done, of: counts.asked }, false),
    ];
    parts.into_iter().flatten().fold(time, |text, part| text + &part)
}
