//! The comparison of runs with earlier ones: new, missing and changed results, and longer times.

use std::collections::BTreeMap;

use super::glance;
use super::rank;
use crate::figures::overall;
use crate::groups::{Key, Times, backends, timings};
use crate::plot::tradeoff;
use crate::table::{Block, Cell, Section, Table, Tone};
use crate::{Class, Error, Origin, RunDir, SummaryRow};
use predicament_records::Severity;
use predicament_records::format::{factor, length, significant, thousands};

/// The maximum number of changed pairs that are listed.
const MANY: usize = 200;
/// The two-sided 95 % quantile of the normal distribution.
const Z: f64 = 1.959_963_984_540_054;

/// The section on the differences from earlier runs: pairs of scene and backend by their classes, and times by task and
/// backend.
///
/// # Errors
/// If the plot can't be drawn.
pub fn against(runs: &[RunDir], earlier: &[RunDir]) -> Result<Section, Error> {
    let [now, before] = [runs, earlier].map(pairs);
    let changed: Vec<Change> = now
        .iter()
        .filter_map(|(key, row)| {
            let old = before.get(key)?;
            (classes(old) != classes(row) || old.status != row.status).then_some((*key, *old, *row))
        })
        .collect();
    let only = |these: &Pairs, those: &Pairs| these.keys().filter(|key| !those.contains_key(*key)).count();
    let (added, removed) = (only(&now, &before), only(&before, &now));
    let unchanged = now.len() - added - changed.len();
    let mut counts = Table::new("Pairs of scene and backend").numbers(["unchanged", "changed", "added", "removed"]);
    counts.push(vec![
        Cell::count(length(unchanged)),
        Cell::count(length(changed.len())).tone(if changed.is_empty() { Tone::Muted } else { Tone::Notable }),
        Cell::count(length(added)),
        Cell::count(length(removed)),
    ]);
    let mut blocks = vec![Block::Table(counts)];
    let order = backends(runs);
    for table in [changes(changed, &order), times(runs, earlier, &order)] {
        if !table.is_empty() {
            blocks.push(Block::Table(table));
        }
    }
    let (now, before) = (Times::of(runs), Times::of(earlier));
    let plots = glance::plots(&overall(runs, &now).marks, &overall(earlier, &before).marks);
    for ((plot, _), file) in plots.into_iter().zip(["against.svg", "against-scenes.svg"]) {
        if plot.points.iter().any(|point| point.before.is_some())
            && let Some(picture) = tradeoff(&plot)?
        {
            let alt = format!("{} against {}: rings are the earlier run", plot.y, plot.x);
            blocks.push(Block::Plot { picture, file: file.into(), alt: alt.into() });
        }
    }
    Ok(Section {
        id: "against",
        title: "Changes since the earlier run",
        lead: "A pair of scene and backend is changed if its status or the count of any class differs. A scene whose \
               contents changed is listed as removed and added. A change is worse or better by the worst severity \
               whose counts differ. A ratio of times is the geometric mean over the families that were timed in both \
               runs; its 95 % interval comes from the spread between families. If the interval excludes 1, times \
               differ by more than that spread. Rings in the plot are the earlier run."
            .to_owned(),
        blocks,
    })
}

type Pair<'r> = [&'r str; 5];
type Pairs<'r> = BTreeMap<Pair<'r>, &'r SummaryRow>;
type Change<'r> = (Pair<'r>, &'r SummaryRow, &'r SummaryRow);

/// Rows by suite, scene, content, task and backend.
fn pairs(runs: &[RunDir]) -> Pairs<'_> {
    let rows = runs.iter().flat_map(|run| &run.summary);
    rows.map(|row| ([&*row.suite, &*row.scene, &*row.scene_id, &*row.task, &*row.backend], row)).collect()
}

fn classes(row: &SummaryRow) -> Vec<u64> {
    Class::ALL.into_iter().map(|class| row.count(class)).collect()
}

/// Compares a result with an earlier one, by the number of findings of the worst severity in which they differ.
fn verdict(old: &SummaryRow, new: &SummaryRow) -> std::cmp::Ordering {
    let count = |row: &SummaryRow, severity: Severity| {
        Class::ALL.into_iter().filter(|class| class.severity() == severity).map(|class| row.count(class)).sum::<u64>()
    };
    let mut worst = Severity::ALL.into_iter().rev().filter(|severity| *severity != Severity::Right);
    let differing = worst.find(|&severity| count(old, severity) != count(new, severity));
    differing.map_or(std::cmp::Ordering::Equal, |severity| count(new, severity).cmp(&count(old, severity)))
}

/// The table of changes: first worse results, then neutral ones, then better ones.
fn changes(mut changed: Vec<Change<'_>>, order: &[&str]) -> Table {
    changed.sort_by_key(|(key, old, new)| (verdict(old, new).reverse(), *key, rank(order, key[4])));
    let mut caption = "Changed".to_owned();
    if changed.len() > MANY {
        caption += &format!(": the first {MANY} of {}", thousands(length(changed.len())));
    }
    let mut table = Table::new(caption)
        .words(["suite", "scene", "task", "backend", "before"])
        .of(Origin::of("summary.csv").keys(["suite", "scene", "task", "backend"]))
        .words(["now", "verdict"]);
    for ([suite, scene, _, task, backend], old, new) in changed.into_iter().take(MANY) {
        let differing: Vec<Class> =
            Class::ALL.into_iter().filter(|&class| old.count(class) != new.count(class)).collect();
        let tell = |row: &SummaryRow| {
            let counts = differing.iter().map(|&class| format!("{class} {}", thousands(row.count(class))));
            Cell::from(counts.collect::<Vec<_>>().join(", ")).detail(row.status.name())
        };
        let (tone, verdict) = match verdict(old, new) {
            std::cmp::Ordering::Greater => (Tone::Bad, "worse"),
            std::cmp::Ordering::Less => (Tone::Good, "better"),
            std::cmp::Ordering::Equal => (Tone::Plain, ""),
        };
        table.push(vec![
            suite.into(),
            scene.into(),
            task.into(),
            Cell::code(backend),
            tell(old).tone(Tone::Muted),
            tell(new).tone(tone),
            Cell::from(verdict).tone(tone),
        ]);
    }
    table
}

/// The table of times relative to earlier runs, by task and backend.
fn times(runs: &[RunDir], earlier: &[RunDir], order: &[&str]) -> Table {
    let [now, before] = [runs, earlier].map(medians);
    let mut ratios: BTreeMap<_, Vec<f64>> = BTreeMap::new();
    for (key, ns) in &now {
        if let Some(old) = before.get(key) {
            let (task, _, backend, way) = key;
            ratios.entry((*task, rank(order, backend), *way)).or_default().push((ns / old).ln());
        }
    }
    let mut table = Table::new("Times relative to the earlier run")
        .words(["task", "backend", "asked"])
        .of(Origin::of("throughput.csv").keys(["task", "backend"]))
        .numbers(["families", "ratio", "from", "to"]);
    for ((task, backend, way), logs) in ratios {
        let (mean, half) = mean_and_half(&logs);
        let interval = half.map(|half| [mean - half, mean + half].map(f64::exp));
        let tone = match interval {
            Some([low, _]) if low > 1.0 => Tone::Notable,
            Some([_, high]) if high < 1.0 => Tone::Good,
            _ => Tone::Plain,
        };
        let end = |at: usize| interval.map_or_else(Cell::default, |ends| Cell::from(significant(ends[at], 3)));
        table.push(vec![
            task.into(),
            Cell::code(order.get(backend).copied().unwrap_or_default()),
            way.name().into(),
            thousands(length(logs.len())).into(),
            Cell::from(factor(mean.exp())).tone(tone),
            end(0),
            end(1),
        ]);
    }
    table
}

/// Nanoseconds per query by task, family, backend and interface; with several runs, from the first run that timed it.
fn medians(runs: &[RunDir]) -> BTreeMap<Key<'_>, f64> {
    let mut all = BTreeMap::new();
    for (key, timing) in runs.iter().flat_map(timings) {
        all.entry(key).or_insert(timing.spread.median);
    }
    all
}

/// The mean of some numbers, and half of the width of its interval, which is `None` for fewer than three numbers.
fn mean_and_half(values: &[f64]) -> (f64, Option<f64>) {
    #[allow(clippy::cast_precision_loss)] // a few hundred
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
    (mean, (values.len() >= 3).then(|| Z * (squares / (count - 1.0) / count).sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interval_takes_three() {
        assert_eq!(mean_and_half(&[1.0, 3.0]), (2.0, None));
        let (mean, half) = mean_and_half(&[1.0, 2.0, 3.0]);
        // The standard deviation is 1, divided by the root of three.
        assert_eq!(mean, 2.0);
        assert!((half.unwrap() - 1.96 / 3_f64.sqrt()).abs() < 1e-4);
    }
}
