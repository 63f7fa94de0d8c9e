//! The figures that pages, plots, headlines and `figures.csv` show: errors and times, backend by backend.
//!
//! The scope of a figure is defined in [`comparison`](crate::comparison).

use crate::comparison::{Share, Standing, standing};
use crate::groups::{Pace, REFERENCE, Times, Way, backends};
use crate::{Error, RunDir};
use predicament_records::{Lined, is_predicate};

/// The results of all backends on one task, or on all tasks.
#[derive(Clone, PartialEq, Debug)]
pub struct Panel<'r> {
    /// The task; `None` if the panel is about all tasks.
    pub task: Option<&'r str>,
    /// True if the answers are judged as a whole: then scenes are counted instead of single answers.
    pub is_whole: bool,
    pub marks: Vec<Mark<'r>>,
}

/// One backend: its errors over everything that it was asked, and its times relative to the reference.
#[derive(Clone, PartialEq, Debug)]
pub struct Mark<'r> {
    pub backend: &'r str,
    /// The errors over everything that the backend was asked.
    pub standing: Standing,
    /// The times relative to the reference, one for each interface with a common family.
    pub paces: Vec<Pace>,
}

impl Mark<'_> {
    /// The time relative to the reference by this interface, if both were timed.
    pub fn pace(&self, way: Way) -> Option<&Pace> {
        self.paces.iter().find(|pace| pace.way == way)
    }

    /// The share of wrong answers.
    pub fn wrong(&self) -> Share {
        Share { count: self.standing.answers.wrong, of: self.standing.answers.asked() }
    }

    /// The share of broken scenes among those that were answered.
    pub fn broken(&self) -> Share {
        Share { count: self.standing.scenes.broken, of: self.standing.scenes.done() }
    }

    /// The share of undecided queries, and of scenes that were not done.
    pub fn not_done(&self) -> [Share; 2] {
        let (answers, scenes) = (&self.standing.answers, &self.standing.scenes);
        [
            Share { count: answers.not_done + answers.undecided, of: answers.asked() },
            Share { count: scenes.not_done, of: scenes.asked() },
        ]
    }
}

/// The backends on the tasks for which `keep` is true, in the order of the plans, without backends that were neither
/// asked nor timed.
pub fn marks<'r>(runs: &'r [RunDir], times: &Times<'r>, keep: impl Fn(&str) -> bool) -> Vec<Mark<'r>> {
    let mark = |backend: &'r str| Mark {
        backend,
        standing: standing(runs, backend, |row| keep(&row.task)),
        paces: Way::ALL.into_iter().filter_map(|way| times.pace(backend, REFERENCE, way, &keep)).collect(),
    };
    let is_known =
        |mark: &Mark| mark.standing.answers.asked() + mark.standing.scenes.asked() > 0 || !mark.paces.is_empty();
    backends(runs).into_iter().map(mark).filter(is_known).collect()
}

/// The panel of all tasks: the figures about a backend over everything.
pub fn overall<'r>(runs: &'r [RunDir], times: &Times<'r>) -> Panel<'r> {
    Panel { task: None, is_whole: false, marks: marks(runs, times, |_| true) }
}

/// A panel for each task that was timed.
pub fn panels<'r>(runs: &'r [RunDir], times: &Times<'r>) -> Vec<Panel<'r>> {
    let whole = crate::comparison::judged_whole(runs);
    let panel = |task: &'r str| Panel {
        task: Some(task),
        is_whole: whole.contains(task),
        marks: marks(runs, times, |of| of == task),
    };
    times.tasks().into_iter().map(panel).collect()
}

/// The faultless backends: they answer everything they were asked, without a wrong answer or a broken law. The cheapest
/// comes first; a backend without a time has no price.
pub fn faultless<'r>(runs: &'r [RunDir], times: &Times<'r>, scope: Scope) -> Vec<Mark<'r>> {
    let mut right: Vec<Mark> = marks(runs, times, |task| scope.has(task));
    right.retain(|mark| mark.standing.is_right() && mark.standing.is_complete() && !mark.paces.is_empty());
    right.sort_by(|a, b| a.paces[0].way.cmp(&b.paces[0].way).then(a.paces[0].ratio.total_cmp(&b.paces[0].ratio)));
    right
}

/// The scope of a headline.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Scope {
    /// All tasks.
    Everything,
    /// The tasks that ask only for the signs of one predicate.
    Predicates,
}

impl Scope {
    fn has(self, task: &str) -> bool {
        self == Scope::Everything || is_predicate(task)
    }
}

/// The name of the file with all figures.
pub const FILE: &str = "figures.csv";

const COLUMNS: [&str; 20] = [
    "panel",
    "backend",
    "queries",
    "right",
    "undecided",
    "wrong",
    "not_done",
    "scenes",
    "scenes_held",
    "scenes_rounded",
    "scenes_broken",
    "scenes_not_done",
    "interface",
    "families",
    "reference",
    "reference_families",
    "ratio",
    "ns_per_query",
    "ns_per_query_min",
    "ns_per_query_max",
];

/// The text of `figures.csv`: the panels of all tasks, and before them, as panel `all`, each backend over everything.
///
/// A row is a backend on a panel, with one `interface`. If the backend was not timed with the reference, `interface`
/// and the columns after it are empty. The counts are equal on each row of a backend on a panel: queries with their
/// four shares, and scenes with theirs. `ratio` is the time relative to the reference's, over the `families` that both
/// were timed on, of `reference_families`.
///
/// # Errors
/// If writing to memory fails, which does not happen.
pub fn csv(runs: &[RunDir]) -> Result<String, Error> {
    let fail = |error: csv::Error| Error::new(FILE.as_ref(), error.to_string());
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS).map_err(fail)?;
    let times = Times::of(runs);
    for panel in std::iter::once(overall(runs, &times)).chain(panels(runs, &times)) {
        for mark in &panel.marks {
            let Standing { answers, scenes, .. } = mark.standing;
            let counts = [answers.asked(), answers.right, answers.undecided, answers.wrong, answers.not_done];
            let of_scenes = [scenes.asked(), scenes.held, scenes.rounded, scenes.broken, scenes.not_done];
            let head = [panel.task.unwrap_or("all").to_owned(), mark.backend.to_owned()];
            let head: Vec<String> =
                head.into_iter().chain(counts.iter().chain(&of_scenes).map(u64::to_string)).collect();
            let timed = mark.paces.iter().map(|pace| {
                let way = if pace.is_loop { "loop" } else { pace.way.name() };
                let counts = [way.to_owned(), pace.families.to_string(), REFERENCE.to_owned(), pace.of.to_string()];
                let ns = if panel.task.is_some() { vec![pace.ns, pace.range[0], pace.range[1]] } else { vec![] };
                let numbers = std::iter::once(pace.ratio).chain(ns).map(|x| x.to_string());
                counts.into_iter().chain(numbers).collect::<Vec<_>>()
            });
            let timed: Vec<Vec<String>> = if mark.paces.is_empty() { vec![Vec::new()] } else { timed.collect() };
            for timed in timed {
                let mut record = [head.clone(), timed].concat();
                record.resize(COLUMNS.len(), String::new());
                writer.write_record(record).map_err(fail)?;
            }
        }
    }
    let bytes = writer.into_inner().map_err(|error| Error::new(FILE.as_ref(), error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| Error::new(FILE.as_ref(), error.to_string()))
}

/// The rows of the file with their lines.
pub fn lined(runs: &[RunDir]) -> Result<Lined, Error> {
    let fail = |error: csv::Error| Error::new(FILE.as_ref(), error.to_string());
    let text = csv(runs)?;
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let columns = reader.headers().map_err(fail)?.iter().map(str::to_owned).collect();
    // No field has a line end, so each row is one line, after the header.
    let rows =
        (2..).zip(reader.records()).map(|(line, record)| Ok((line, record?.iter().map(str::to_owned).collect())));
    Ok(Lined { columns, rows: rows.collect::<Result<_, _>>().map_err(fail)? })
}
