//! The comparison as Markdown: one table of backends, then one for each task.

use std::fmt::Write as _;

use predicament_report::{Curve, Curves, curves};
use predicament_tasks::Kind;

use super::{Compared, Measure};
use crate::{Error, File};

/// What the measures of stages begin with.
const STAGE: &str = "stage: ";

/// The classes of answers that no backend promises.
pub(crate) const WRONG: [&str; 5] = ["sign_flip", "missed_zero", "overreach", "nan", "inconsistent"];

/// All tables.
pub(super) fn page(compared: &Compared) -> String {
    // A String takes everything.
    let mut page = String::from("# Which backend for what\n\n");
    page += "Each number is the value of a row of `compare.csv`, which has its interval and what it is of. Topology: scenes in a thousand that \
             violate a law. Signs: answers in a million that are wrong by the backend's own promise. Times: nanoseconds for each query, \
             primitive or triangle of a scene. Bits: of the widest arithmetic that settled an answer, 53 (24 in single precision) where floating point \
             settled all of them, else at most degree times the bits of differences and the growth of sums; `–` where that is not known: of \
             constructed points, and of libraries that do not say what they compute in.\n\n";
    page += "| backend | promise | proved | smallest feature, 2D, L | 3D, L | location, 99 %, L | missed by, 99 %, L | weight, 99 % | declined | topology | signs |\n";
    page += "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    for (backend, promise, proved) in &compared.promises {
        let of =
            |measure: &str, unit: &str| largest(compared, backend, |row| row.measure == measure && row.unit == unit);
        let feature = |dimension: &str| {
            largest(compared, backend, |row| row.measure == "smallest feature" && row.kind == dimension)
        };
        let _ = writeln!(
            page,
            "| {backend} | {promise} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            if *proved { "yes" } else { "no" },
            short(feature("2D")),
            short(feature("3D")),
            short(of("location: 99 %", "L")),
            short(of("missed by: 99 %", "L")),
            short(of("weight: 99 %", "of one")),
            mean(compared, backend, &["declined"], 100.0, " %"),
            mean(compared, backend, &["topology"], 1.0, ""),
            mean(compared, backend, &WRONG, 1.0, ""),
        );
    }
    page += "\nFeatures, locations and weights: the largest of all inputs. Declined, topology and signs: the mean over all inputs that are answered.\n";
    let mut tasks: Vec<&str> = compared.measures.iter().map(|row| row.task.as_str()).collect();
    tasks.dedup();
    for task in tasks.into_iter().filter(|task| *task != "resolution") {
        of_task(&mut page, compared, task);
    }
    sizes(&mut page, compared);
    errors_and_times(&mut page, compared);
    page
}

/// Backends whose names differ in a parameter alone: `exact:stages=2` and `exact:stages=3`, `epsilon:1e-10` and `epsilon:1e-12`.
fn curve_of(backend: &str) -> &str {
    backend.split('=').next().filter(|name| *name != backend).or(backend.split(':').next()).unwrap_or(backend)
}

/// The geometric mean of a backend's times, the mean of its scenes in a thousand that are wrong, and of answers in a million; none without times.
fn error_and_time(compared: &Compared, backend: &str) -> Option<[f64; 3]> {
    let of = |measure: &str| -> Vec<f64> {
        let own = compared.measures.iter().filter(|row| row.backend == backend && row.measure == measure);
        own.map(|row| row.value).collect()
    };
    let count = |values: &[f64]| predicament_records::approximately(values.len().max(1) as u64);
    let time = predicament_records::geometric_mean(of("time"))?;
    let scenes = of("wrong scenes");
    let answers = WRONG.iter().flat_map(|class| of(class)).sum::<f64>() / count(&scenes);
    Some([time, scenes.iter().sum::<f64>() / count(&scenes), answers])
}

/// Run time against error, as numbers.
fn errors_and_times(page: &mut String, compared: &Compared) {
    let rows: Vec<(&str, [f64; 3])> = compared
        .promises
        .iter()
        .filter_map(|(backend, ..)| Some((backend.as_str(), error_and_time(compared, backend)?)))
        .collect();
    if rows.is_empty() {
        return;
    }
    page.push_str(
        "\n## Run time against error\n\nMeans over the inputs that a backend answers; `error-time.svg` draws them, with one curve for backends that differ in a parameter.\n\n\
         | backend | ns, geometric mean | scenes in 1000 against the promise | signs |\n|---|---:|---:|---:|\n",
    );
    for (backend, [time, scenes, signs]) in rows {
        let _ =
            writeln!(page, "| {backend} | {} | {} | {} |", short(Some(time)), short(Some(scenes)), short(Some(signs)));
    }
}

/// A task: topology, signs, and time by kind of input.
fn of_task(page: &mut String, compared: &Compared, task: &str) {
    let rows: Vec<&Measure> = compared.measures.iter().filter(|row| row.task == task).collect();
    let kinds: Vec<&str> =
        Kind::ALL.into_iter().map(Kind::name).filter(|kind| rows.iter().any(|row| row.kind == *kind)).collect();
    let families = kinds.iter().map(|kind| rows.iter().find(|row| row.kind == *kind).map_or("", |row| &row.family));
    let _ = writeln!(page, "\n## {task}\n\n{}\n", families.collect::<Vec<_>>().join(", "));
    let _ = write!(page, "| backend |");
    for measure in ["topology", "signs", "declined", "bits", "time, ns", "memory, KiB"] {
        for kind in &kinds {
            let _ = write!(page, " {measure}, {kind} |");
        }
    }
    let _ = writeln!(page, "\n|---|{}", "---:|".repeat(6 * kinds.len()));
    for (backend, ..) in &compared.promises {
        let own: Vec<&Measure> = rows.iter().copied().filter(|row| row.backend == *backend).collect();
        let value = |kind: &str, measure: &str| {
            own.iter().find(|row| row.kind == kind && row.measure == measure).map(|row| row.value)
        };
        let _ = write!(page, "| {backend} |");
        for kind in &kinds {
            let _ = write!(page, " {} |", short(value(kind, "topology")));
        }
        for kind in &kinds {
            let signs: Vec<f64> = WRONG.iter().filter_map(|class| value(kind, class)).collect();
            let _ = write!(page, " {} |", short((!signs.is_empty()).then(|| signs.iter().sum())));
        }
        for kind in &kinds {
            let _ = write!(
                page,
                " {} |",
                value(kind, "declined").map_or("–".to_owned(), |x| format!("{:.0} %", 100.0 * x))
            );
        }
        for kind in &kinds {
            let _ = write!(page, " {} |", short(value(kind, "bits")));
        }
        for kind in &kinds {
            let _ = write!(page, " {} |", short(value(kind, "time")));
        }
        for kind in &kinds {
            let _ = write!(page, " {} |", short(value(kind, "memory").map(|bytes| bytes / 1024.0)));
        }
        page.push('\n');
    }
    stages(page, &rows);
    places(page, &rows);
    checks(page, &rows);
}

/// The shares of queries that each stage settled, largest first.
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

/// How far off contacts are.
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

/// The checks that scenes of a task fail.
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

/// The smallest features by backend.
fn sizes(page: &mut String, compared: &Compared) {
    let rows: Vec<&Measure> = compared.measures.iter().filter(|row| row.task == "resolution").collect();
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
    for (backend, ..) in &compared.promises {
        let _ = write!(page, " {backend} |");
    }
    let _ = writeln!(page, "\n|---|---|{}", "---:|".repeat(compared.promises.len()));
    for (dimension, feature) in features {
        let _ = write!(page, "| {dimension} | {feature} |");
        for (backend, ..) in &compared.promises {
            let of = |row: &&&Measure| row.kind == dimension && row.family == feature && row.backend == *backend;
            let _ = write!(page, " {} |", short(rows.iter().find(of).map(|row| row.value)));
        }
        page.push('\n');
    }
    page.push_str("\n0: it is told at the smallest size that is looked at, 10^-9 L.\n");
}

/// Run time against error: for each backend the geometric mean of its times and the mean share of scenes that it answers against its promise. Backends
/// that differ in a parameter alone are one curve; what is never wrong is drawn at a tenth of a scene in a thousand.
pub(super) fn error_against_time(compared: &Compared) -> Result<Vec<File>, Error> {
    let mut lines: Vec<Curve> = Vec::new();
    for (backend, ..) in &compared.promises {
        let Some([time, mean, _]) = error_and_time(compared, backend) else { continue };
        let name = curve_of(backend).to_owned();
        let point = (time, mean.max(0.1));
        match lines.iter_mut().find(|line| line.name == name) {
            Some(line) => line.points.push(point),
            None => lines.push(Curve::new(name, [point])),
        }
    }
    lines.iter_mut().for_each(|line| line.points.sort_by(|a, b| a.0.total_cmp(&b.0)));
    let (x, y) = ("ns a query, geometric mean".into(), "scenes in 1000 against the promise".into());
    let picture = curves(&Curves { x, y, curves: lines, ..Curves::default() }).map_err(Error::format)?;
    Ok(File::plot("error-time", picture))
}

fn largest(compared: &Compared, backend: &str, is_asked: impl Fn(&Measure) -> bool) -> Option<f64> {
    let of = compared.measures.iter().filter(|row| row.backend == backend && is_asked(row));
    of.map(|row| row.value).max_by(f64::total_cmp)
}

/// The mean over inputs of the sums of these measures.
fn mean(compared: &Compared, backend: &str, measures: &[&str], times: f64, unit: &str) -> String {
    let rows: Vec<&Measure> = compared
        .measures
        .iter()
        .filter(|row| row.backend == backend && measures.contains(&row.measure.as_str()))
        .collect();
    let mut inputs: Vec<(&str, &str)> = rows.iter().map(|row| (row.task.as_str(), row.kind.as_str())).collect();
    inputs.sort_unstable();
    inputs.dedup();
    if inputs.is_empty() {
        return "–".to_owned();
    }
    let sum: f64 = rows.iter().map(|row| row.value).sum();
    format!("{}{unit}", short(Some(times * sum / predicament_records::approximately(inputs.len() as u64))))
}

/// A number in three digits.
pub(crate) fn short(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(0.0) => "0".to_owned(),
        Some(x) if x.is_infinite() => "none".to_owned(),
        Some(x) if (0.01..100.0).contains(&x) => {
            format!("{x:.3}").trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        Some(x) if (100.0..1e7).contains(&x) => format!("{x:.0}"),
        Some(x) => format!("{x:.1e}"),
    }
}
