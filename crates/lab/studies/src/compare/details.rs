//! The long table: each backend on each input, with the denominator of every number.

use std::path::Path;

use predicament_records::format::thousands;
use predicament_report::{Cell, Origin, Table, Tone};

use super::Measure;
use super::measure::FEATURES;
use super::standing::{InputKey, REFERENCE, Share, Standing, key, left_out, point_ratio, time_ratio};
use super::words::{counted, millionths, percents, rate, scenes, share, short, times};

/// The explanation of the columns.
pub(super) const MEANING: &str = "Scenes are distinct; a family without randomness makes one. Wrong scenes and broken laws are counted among the scenes answered. Times are nanoseconds \
     per query, primitive or triangle of a scene: the median, with the least and the largest sample. Bits is the length of the widest arithmetic that settled an answer: 53 (24 \
     in single precision) if floating point settled all answers; else an upper bound, the degree times the bits of differences, plus the growth of sums. – means unknown: for \
     constructed points, and for libraries that do not say what they compute in. Constructed are the points of the timed scene: a perturbation adds crossings where inputs touch, and \
     time / point is the ratio to exact of the times for each point, so that a tie's cost stands apart from the number of points. \
     KiB is the memory that the process needed besides what earlier backends and scenes had freed, so it depends on them: a lower bound.";

/// The columns, with the measures of their numbers.
const MEASURES: [(&str, &str); 11] = [
    ("not done", "not done"),
    ("undecided", "undecided"),
    ("rounded", "rounded"),
    ("wrong scenes", "wrong scenes"),
    ("broken laws", "topology"),
    ("wrong answers in 10^6", "wrong answers"),
    ("bits", "bits"),
    ("location, 99 %, L", "location: 99 %"),
    ("ns", "time"),
    ("constructed", "constructed"),
    ("KiB", "memory"),
];

/// The table of all inputs of a task, or of all tasks, with all backends.
///
/// `path` is the file with the measures.
pub(super) fn table(measures: &[Measure], task: Option<&str>, path: Option<&Path>) -> Table {
    let mut table = Table::new(if path.is_some() { "Backends on scenes of each kind" } else { "" });
    if let Some(path) = path {
        let origin = Origin::at(path).keys(["task", "backend"]).key("input", "kind").under("input", "family");
        table = table.of(origin.named("measure", MEASURES));
    }
    let mut table = table.words(["task", "input", "backend"]).numbers([
        "scenes",
        "not done",
        "undecided",
        "rounded",
        "wrong scenes",
        "broken laws",
        "wrong answers in 10^6",
        "bits",
        "location, 99 %, L",
        "ns",
        &format!("time / {REFERENCE}"),
        "constructed",
        "time / point",
        "KiB",
    ]);
    let barely = left_out(measures);
    let is_shown = |row: &&Measure| row.task != FEATURES && task.is_none_or(|task| row.task == task);
    let mut seen: Vec<(InputKey<'_>, &str)> = Vec::new();
    for row in measures.iter().filter(is_shown) {
        let at = (key(row), row.backend.as_str());
        if !seen.contains(&at) {
            seen.push(at);
        }
    }
    for (input, backend) in seen {
        let [task, kind, family] = input;
        let own: Vec<&Measure> = measures.iter().filter(|row| row.backend == backend && key(row) == input).collect();
        let of = |measure: &str, unit: &str| {
            own.iter().find(|row| row.measure == measure && (unit.is_empty() || row.unit == unit)).copied()
        };
        let value = |measure: &str, unit: &str| short(of(measure, unit).map(|row| row.value));
        let standing = Standing::of(measures, backend, |other| *other == input);
        let counts = standing.scenes;
        let part = |count: u64| Cell::from(share(Share { count, of: counts.asked }));
        let answered = counts.asked - counts.not_done;
        let failed = |share: Share| {
            if share.of == 0 {
                return Cell::from("–");
            }
            let tone = if share.count > 0 { Tone::Bad } else { Tone::Muted };
            Cell::from(counted(share)).detail(percents(share)).tone(tone)
        };
        let tone = if standing.answers.count > 0 { Tone::Bad } else { Tone::Muted };
        let wrong = Cell::from(rate(standing.answers)).tone(tone);
        let time = of("time", "").map_or_else(
            || Cell::from("–"),
            |row| {
                let [low, high] = [row.low, row.high].map(|x| short(Some(x)));
                Cell::from(short(Some(row.value))).detail(format!("{low} to {high}"))
            },
        );
        let ratio =
            time_ratio(measures, backend, &input).map_or_else(|| Cell::from("–"), |ratio| Cell::from(times(ratio)));
        let points = of("constructed", "");
        let constructed = Cell::from(points.map_or_else(|| "–".to_owned(), |row| short(Some(row.value))));
        let each = point_ratio(measures, backend, &input);
        let each = Cell::from(each.map_or_else(|| "–".to_owned(), times));
        let is_barely = barely.iter().any(|(other, _)| *other == input);
        table.push(vec![
            Cell::from(task),
            Cell::from(kind).detail(family),
            Cell::from(backend),
            Cell::from(thousands(counts.asked)).title(scenes(counts.asked)),
            part(counts.not_done),
            part(counts.undecided),
            part(counts.rounded),
            failed(Share { count: counts.wrong, of: answered }),
            failed(standing.laws),
            if standing.answers.of == 0 { wrong } else { wrong.detail(millionths(standing.answers)) },
            Cell::from(value("bits", "")),
            Cell::from(value("location: 99 %", "L")),
            time,
            if is_barely { ratio.detail("barely depends") } else { ratio },
            constructed,
            each,
            Cell::from(short(of("memory", "").map(|row| row.value / 1024.0))),
        ]);
    }
    table
}
