//! The figures of a scoreboard: scenes by grade, distances of rounding, times and memory.

use std::collections::BTreeMap;

use predicament_records::{Error, PhaseRow, RunDir, SummaryRow};
use predicament_tasks::replies::ReplyRow;
use predicament_tasks::{AnyTask, Class};

/// The result of a library on one scene: the worst that was found.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Grade {
    /// Nothing is wrong.
    Right,
    /// The answer is off by its rounding.
    Rounded,
    /// The library, or its engine, declined the scene.
    Declined,
    /// The library reported an error for valid input.
    Refused,
    /// The library gave an answer for invalid input.
    Accepted,
    /// A crash or a timeout.
    Failed,
    /// The answer is wrong.
    Broken,
}

impl Grade {
    /// All grades, in the order of columns.
    pub const ALL: [Grade; 7] =
        [Grade::Right, Grade::Rounded, Grade::Broken, Grade::Failed, Grade::Refused, Grade::Accepted, Grade::Declined];

    /// The name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Grade::Right => "right",
            Grade::Rounded => "rounded",
            Grade::Declined => "declined",
            Grade::Refused => "refused",
            Grade::Accepted => "accepted",
            Grade::Failed => "failed",
            Grade::Broken => "broken",
        }
    }

    /// The grade of a row.
    pub fn of(row: &SummaryRow) -> Grade {
        let count = |classes: &[Class]| classes.iter().map(|&class| row.count(class)).sum::<u64>();
        if count(&[Class::Panic, Class::Timeout]) > 0 {
            return Grade::Failed;
        }
        let refusals =
            [(Class::Declined, Grade::Declined), (Class::Refused, Grade::Refused), (Class::Accepted, Grade::Accepted)];
        if let Some((_, grade)) = refusals.into_iter().find(|&(class, _)| count(&[class]) > 0) {
            return grade;
        }
        let wrong = Class::ALL.into_iter().filter(|&class| !class.is_legal() && class != Class::Rounded);
        match (count(&wrong.collect::<Vec<_>>()), count(&[Class::Rounded])) {
            (1.., _) => Grade::Broken,
            (0, 1..) => Grade::Rounded,
            (0, 0) => Grade::Right,
        }
    }
}

/// A library on one suite.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Cell {
    /// The number of scenes of each grade.
    pub scenes: BTreeMap<Grade, usize>,
    /// The scene with the fewest parts of each grade: its run, its name and its size.
    pub smallest: BTreeMap<Grade, (usize, String, u64)>,
}

impl Cell {
    /// The number of scenes of a grade.
    pub fn count(&self, grade: Grade) -> usize {
        self.scenes.get(&grade).copied().unwrap_or(0)
    }

    /// The number of all scenes.
    pub fn total(&self) -> usize {
        self.scenes.values().sum()
    }
}

/// A library on a task.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Row {
    /// Its cells by suite.
    pub suites: BTreeMap<String, Cell>,
    /// The largest distance of each answer with coordinates, in units in the last place, ascending.
    pub ulps: Vec<f64>,
    /// The largest distance of all, as a part of the scene's extent.
    pub worst_over_l: f64,
    /// The nanoseconds per query of each family of scenes that a bench has timed: the median of its samples, by the
    /// program's own clock.
    pub nanoseconds: BTreeMap<String, f64>,
    /// The most memory of the program, in bytes.
    pub bytes: u64,
}

impl Row {
    /// The cells of all suites together.
    pub fn all(&self) -> Cell {
        let mut all = Cell::default();
        for cell in self.suites.values() {
            cell.scenes.iter().for_each(|(&grade, count)| *all.scenes.entry(grade).or_default() += count);
            for (&grade, found) in &cell.smallest {
                let least = all.smallest.entry(grade).or_insert_with(|| found.clone());
                if found.2 < least.2 {
                    *least = found.clone();
                }
            }
        }
        all
    }

    /// The geometric mean of the ratios of times to another library's, and the number of families that both have times
    /// of.
    pub fn ratio(&self, to: &Row) -> Option<(f64, usize)> {
        let logarithm = |(family, &time): (&String, &f64)| {
            let other = *to.nanoseconds.get(family)?;
            (time > 0.0 && other > 0.0).then(|| (time / other).ln())
        };
        let all: Vec<f64> = self.nanoseconds.iter().filter_map(logarithm).collect();
        let count = u32::try_from(all.len()).ok().filter(|&count| count > 0)?;
        Some(((all.iter().sum::<f64>() / f64::from(count)).exp(), all.len()))
    }

    /// The median of the distances in units in the last place.
    pub fn median_ulps(&self) -> Option<f64> {
        self.ulps.get(self.ulps.len() / 2).copied()
    }
}

/// The figures of all libraries on all tasks that are open to other programs. A library is listed for the tasks of
/// which it has not declined every scene.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Board {
    /// The libraries of each task.
    pub tasks: BTreeMap<String, BTreeMap<String, Row>>,
}

impl Board {
    /// The figures of these runs. If several runs have a scene of a library, the first run counts.
    ///
    /// # Errors
    /// If a table of a run cannot be read.
    pub fn of(runs: &[RunDir], tasks: &[&'static dyn AnyTask]) -> Result<Board, Error> {
        let is_open = |name: &str| tasks.iter().any(|task| task.name() == name && task.parts_of_replies().is_some());
        let mut board = Board::default();
        let mut first: BTreeMap<(String, String), usize> = BTreeMap::new();
        for (at, run) in runs.iter().enumerate() {
            for row in run.summary.iter().filter(|row| is_open(&row.task)) {
                let key = (row.scene_id.clone(), row.backend.clone());
                if *first.entry(key).or_insert(at) != at {
                    continue;
                }
                let library = board.tasks.entry(row.task.clone()).or_default().entry(row.backend.clone()).or_default();
                let cell = library.suites.entry(row.suite.clone()).or_default();
                let grade = Grade::of(row);
                *cell.scenes.entry(grade).or_default() += 1;
                let found = (at, row.scene.clone(), row.queries);
                let least = cell.smallest.entry(grade).or_insert_with(|| found.clone());
                if row.queries < least.2 {
                    *least = found;
                }
            }
            for row in run.rows::<ReplyRow>()?.iter() {
                let key = (row.scene_id.clone(), row.backend.clone());
                let Some(library) = board.tasks.get_mut(&row.task).and_then(|task| task.get_mut(&row.backend)) else {
                    continue;
                };
                if first.get(&key) == Some(&at) {
                    library.ulps.push(row.distance_ulps);
                    library.worst_over_l = library.worst_over_l.max(row.distance_over_l);
                }
            }
            board.add_times(run)?;
        }
        for task in board.tasks.values_mut() {
            // A library that declines a whole task does not offer it.
            task.retain(|_, row| row.all().count(Grade::Declined) < row.all().total());
        }
        board.tasks.retain(|_, task| !task.is_empty());
        for row in board.tasks.values_mut().flat_map(BTreeMap::values_mut) {
            row.ulps.sort_by(f64::total_cmp);
        }
        Ok(board)
    }
}

impl Board {
    /// Adds the times and the memory of a bench.
    fn add_times(&mut self, run: &RunDir) -> Result<(), Error> {
        let mut samples: BTreeMap<[String; 3], Vec<f64>> = BTreeMap::new();
        for row in run.throughput.iter() {
            let key = [row.task.clone(), row.backend.clone(), row.family.clone()];
            samples.entry(key).or_default().push(row.ns_per_query);
        }
        for ([task, backend, family], mut times) in samples {
            let Some(library) = self.tasks.get_mut(&task).and_then(|task| task.get_mut(&backend)) else { continue };
            times.sort_by(f64::total_cmp);
            library.nanoseconds.entry(family).or_insert(times[times.len() / 2]);
        }
        for row in run.rows::<PhaseRow>()?.iter() {
            let library = self.tasks.get_mut(&row.task).and_then(|task| task.get_mut(&row.backend));
            if let (Some(library), Some(bytes)) = (library, row.bytes) {
                library.bytes = library.bytes.max(bytes);
            }
        }
        Ok(())
    }
}
