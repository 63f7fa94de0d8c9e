//! The comparison as Markdown: the ranking, then the details of each task.

use std::fmt::Write as _;

use predicament_report::{Cell, Table};

use super::measure::FEATURES;
use super::words::{short, times};
use super::{Compared, Measure, Promise, REFERENCE, details, ranking, sweep, tradeoffs, words};

/// The prefix of the measures of stages.
const STAGE: &str = "stage: ";

/// The classes of answers that no backend promises.
pub(crate) const WRONG: [&str; 5] = ["sign_flip", "missed_zero", "overreach", "nan", "inconsistent"];

/// The page with all tables.
pub(super) fn page(compared: &Compared) -> String {
    let measures = &compared.measures;
    let mut page = format!(
        "# Which backend for what\n\n{}\n\n{}\n\n{}\n",
        ranking::markdown(ranking::table(measures, &compared.promises)),
        ranking::MEANING,
        ranking::rule(measures)
    );
    if let Some(curves) = curves(measures) {
        page += "\n## One parameter turned\n\nThe figures cover the inputs that all backends of a curve and the reference answered.\n\n";
        page += &format!("{curves}\n");
    }
    page += &sweep::page(measures);
    let mut tasks: Vec<&str> = measures.iter().map(|row| row.task.as_str()).collect();
    tasks.dedup();
    for task in tasks.into_iter().filter(|task| *task != FEATURES) {
        let rows: Vec<&Measure> = measures.iter().filter(|row| row.task == task).collect();
        let table = ranking::markdown(details::table(measures, Some(task), None));
        // Writing to a String cannot fail.
        let _ = write!(page, "\n## {task}\n\n{table}\n");
        stages(&mut page, &rows);
        places(&mut page, &rows);
        checks(&mut page, &rows);
    }
    page += &format!("\n{}\n", details::MEANING);
    sizes(&mut page, compared);
    page
}

/// The table of backends that differ in one parameter, over the inputs that all of them answered; `None` if no two do.
pub(super) fn curves(measures: &[Measure]) -> Option<String> {
    let all = tradeoffs(measures);
    let on_curves: Vec<_> = all.iter().filter(|of| of.knob.is_some() && of.time.is_some()).collect();
    if on_curves.is_empty() {
        return None;
    }
    let mut table = Table::new("").words(["backend"]).numbers([
        &format!("time / {REFERENCE}"),
        "inputs",
        "wrong answers in 10^6",
        "broken laws",
        "not done",
    ]);
    for of in on_curves {
        let time = of.time.map_or("–".to_owned(), |time| times(time.value));
        let inputs = of.time.map_or("–".to_owned(), |time| words::pairs(&time));
        table.push(vec![
            Cell::code(of.backend),
            Cell::from(time),
            Cell::from(inputs),
            Cell::from(words::rate(of.answers)).detail(words::millionths(of.answers)),
            Cell::from(words::counted(of.scenes)).detail(words::percents(of.scenes)),
            Cell::from(words::counted(of.not_done)),
        ]);
    }
    Some(ranking::markdown(table))
}

/// Writes the shares of queries that each stage settled, largest first.
fn stages(page: &mut String, rows: &[&Measure]) {
    let mut inputs: Vec<(&str, &str)> = Vec::new();
    for row in rows.iter().filter(|row| row.measure.starts_with(STAGE)) {
        if !inputs.contains(&(&row.kind, &row.backend)) {
            inputs.push((&row.kind, &row.backend));
        }
    }
    if inputs.is_empty() {
        return;
    }
    page.push_str("\n| input | backend | stages |\n|---|---|---|\n");
    for (kind, backend) in inputs {
        let is_own = |row: &&&Measure| row.kind == kind && row.backend == backend && row.measure.starts_with(STAGE);
        let mut own: Vec<&Measure> = rows.iter().filter(is_own).copied().collect();
        own.sort_by(|a, b| b.value.total_cmp(&a.value));
        let cell = |row: &&Measure| format!("{} {} %", &row.measure[STAGE.len()..], short(Some(100.0 * row.value)));
        let _ = writeln!(page, "| {kind} | {backend} | {} |", own.iter().map(cell).collect::<Vec<_>>().join(", "));
    }
}

/// Writes the location errors of contacts.
fn places(page: &mut String, rows: &[&Measure]) {
    let is_place = |row: &&&Measure| row.measure == "location: median" && row.unit == "L";
    if !rows.iter().any(|row| is_place(&row)) {
        return;
    }
    page.push_str(
        "\n| input | backend | registered apart | location, L: median | 99 % | max | in scene units: 99 % | missed by, L: median | 99 % | weight: median | 99 % |\n\
         |---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    for of in rows.iter().filter(is_place) {
        let value = |measure: &str, unit: &str| {
            let own = |row: &&&Measure| row.kind == of.kind && row.backend == of.backend;
            let found = rows.iter().filter(own).find(|row| row.measure == measure && row.unit == unit);
            short(found.map(|row| row.value))
        };
        let cells = [
            value("registered apart", "share of contacts"),
            short(Some(of.value)),
            value("location: 99 %", "L"),
            value("location: max", "L"),
            value("location: 99 %", "scene units"),
            value("missed by: median", "L"),
            value("missed by: 99 %", "L"),
            value("weight: median", "of one"),
            value("weight: 99 %", "of one"),
        ];
        let _ = writeln!(page, "| {} | {} | {} |", of.kind, of.backend, cells.join(" | "));
    }
}

/// Writes the checks that scenes of a task fail.
fn checks(page: &mut String, rows: &[&Measure]) {
    let broken: Vec<&&Measure> = rows.iter().filter(|row| row.measure.starts_with("topology: ")).collect();
    if broken.is_empty() {
        return;
    }
    page.push_str("\n| check | input | backend | scenes in 1000 | 95 % |\n|---|---|---|---:|---|\n");
    for row in broken {
        let check = row.measure.trim_start_matches("topology: ");
        let _ = writeln!(
            page,
            "| {check} | {} | {} | {} | {} to {} |",
            row.kind,
            row.backend,
            short(Some(row.value)),
            short(Some(row.low)),
            short(Some(row.high))
        );
    }
}

/// Writes the smallest features by backend.
fn sizes(page: &mut String, compared: &Compared) {
    let rows: Vec<&Measure> = compared.measures.iter().filter(|row| row.task == FEATURES).collect();
    if rows.is_empty() {
        return;
    }
    let mut features: Vec<(&str, &str)> = Vec::new();
    for row in &rows {
        if !features.contains(&(&row.kind, &row.family)) {
            features.push((&row.kind, &row.family));
        }
    }
    page.push_str("\n## Smallest features, in L\n\n| | feature |");
    for of in &compared.promises {
        let _ = write!(page, " {} |", of.backend);
    }
    let _ = writeln!(page, "\n|---|---|{}", "---:|".repeat(compared.promises.len()));
    for (dimension, feature) in features {
        let _ = write!(page, "| {dimension} | {feature} |");
        for Promise { backend, .. } in &compared.promises {
            let of = |row: &&&Measure| row.kind == dimension && row.family == feature && row.backend == *backend;
            let _ = write!(page, " {} |", short(rows.iter().find(of).map(|row| row.value)));
        }
        page.push('\n');
    }
    page.push_str("\n0: the backend distinguishes the feature even at the smallest size tried, 10^-9 L.\n");
}
