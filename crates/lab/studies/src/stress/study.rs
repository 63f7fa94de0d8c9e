//! The command line of the stress study, its survey and its rows.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use predicament_corpus::LoadedScene;
use predicament_tasks::{AnyTask, Contestant, Knob};

use super::breaks::{At, break_point};
use super::limits::{Limit, limits};
use super::scenes::Position;
use super::{BreakPoint, Violations, laws, plots, suites, table};
use crate::compare::{Group, Measure, compared, measures_of, sweep};
use crate::laws::Format;
use crate::{Error, File, Host, Study};

/// One knob at a time, until backends break.
#[derive(Clone, Debug, clap::Args)]
pub struct Stress {
    /// Backends
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        default_value = "tolerance,sos,sos:per-mesh,exact,naive,naive:nalgebra,epsilon:1e-10,shewchuk"
    )]
    pub backends: Vec<String>,

    /// Tasks, several separated by commas; all if left out
    #[arg(short = 't', long = "task", value_name = "TASK", value_delimiter = ',')]
    pub tasks: Vec<String>,

    /// Knobs, several separated by commas; all if left out
    #[arg(short = 'k', long = "knob", value_parser = knob(), value_name = "KNOB", value_delimiter = ',')]
    pub knobs: Vec<Knob>,

    /// Scenes at each position of a knob
    #[arg(long, default_value_t = 3, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub scenes: u32,

    /// Samples of the time at each position, of the first scene; not timed if 0
    #[arg(long, default_value_t = 3, value_name = "N")]
    pub samples: u32,

    /// Tuples for each metamorphic law and predicate; none if 0
    #[arg(long, default_value_t = 400, value_name = "N")]
    pub tuples: u32,

    /// The seed of the first scene; later scenes use the next seeds
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,

    /// A folder for the scenes of each position, as a suite that `run` takes; made if missing
    #[arg(long, value_name = "DIR")]
    pub suites: Option<PathBuf>,

    /// Tables, or one CSV row for each number
    #[arg(long, value_enum, default_value_t = Format::Md)]
    pub format: Format,
}

/// Reads the name of a knob.
fn knob() -> impl TypedValueParser<Value = Knob> {
    let value = |knob: Knob| PossibleValue::new(knob.name()).help(knob.about());
    let named = |name: String| Knob::ALL.into_iter().find(|knob| knob.name() == name).ok_or("no such knob");
    PossibleValuesParser::new(Knob::ALL.map(value)).try_map(named)
}

/// All measures, break points, and violations of laws.
#[derive(Clone, PartialEq, Debug)]
pub struct Stressed {
    /// The tasks of the study.
    pub tasks: Vec<&'static dyn AnyTask>,
    /// The measures by task, knob and position; `kind` is the knob and `family` its position.
    pub measures: Vec<Measure>,
    /// The break points for each task, knob, direction and backend.
    pub breaks: Vec<BreakPoint>,
    /// The limits for each task and knob that does not fit it, or not to the end.
    pub limits: Vec<Limit>,
    /// The violations by backend, predicate and law.
    pub violations: Vec<Violations>,
    /// The backends by name, and true if their promise is proved.
    pub backends: Vec<(String, bool)>,
}

impl Study for Stress {
    const NAME: &'static str = "stress";
    const ASKS: &'static str =
        "Turn one knob at a time until backends break: noise, translation, scale, aspect, precision, rotation";
    const HELP: &'static str = "\
The study makes a scene for each task, general or degenerate as the knob needs it, and moves its points by the knob, \
as far as the scene stays valid for the task (a rounded mesh crosses itself). Tasks and positions that do not fit are \
listed with the reason. The truth is computed for each scene. Some knobs round the scene: translation by 2^k leaves \
53 - k bits of the extent, so that general points become degenerate. Other knobs do not: `shift` first cuts scenes to \
24 bits and then moves them exactly. A backend holds at a position if it answers every scene there as it promises. \
Its break point is between the last position where it holds and the first where it does not.

Metamorphic laws need no truth. Signs stay the same if points are scaled by a power of two, moved by integers or \
renamed; they are opposite if points are reflected; under an integer matrix they are multiplied by the sign of its \
determinant; and incircle is orient3d of the lifted points.

Times are of the first scene of each position, on one thread, with the backends in turns: the median of --samples, \
with the smallest and the largest as an interval.

Files in the folder: stress.csv (a row for each number, with its interval; `kind` is the knob, `family` its \
position), breaks.csv (the break point of each backend, with the scenes at that position, and whether the knob rounds \
the scene), limits.csv (knobs that do not fit a task), stress-laws.csv, stress.md (the printed tables), plots for \
each knob as SVG and PDF: wrong scenes, and the time; for backends that differ in one parameter (such as \
-b 'engine:NAME:key=*') wrong scenes over time, and in stress.md whether a value can be the default. With --suites it also writes a suite for each position of each \
knob, with its points; with it `predicament run` keeps a break point as a regression test.

Exit codes: 100 if a backend with a proved promise gives a wrong answer (sign_flip, missed_zero, overreach, nan, \
inconsistent) or violates a law, 0 otherwise. Failed checks of whole scenes do not break a promise, because signs \
need not be consistent if zeros are a band; they are in the tables.

Examples:
  predicament study stress --out target/stress
  predicament study stress -k noise,translation -t orient2d,orient3d --scenes 50 --out target/noise
  predicament study stress -k size --samples 9 --out target/growth            times that are worth quoting
  predicament study stress --samples 0 --out target/breaks                    no times: the same bytes on every machine
  predicament study stress -b exact,epsilon:1e-15,epsilon:1e-10 -t orient2d -k noise --out target/values
  predicament study stress -k scale -t incircle --suites target/scale --out target/stress
  predicament run target/scale/scale_-250.toml -b naive,exact           the scenes of one position";

    type Measured = Stressed;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn out(&self) -> Option<&Path> {
        Some(&self.out)
    }

    fn prints_rows(&self) -> bool {
        self.format == Format::Csv
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Stressed, Error> {
        let (tasks, knobs) = (compared(host.tasks(), &self.tasks, "stressed")?, self.knobs());
        let positions = self.positions(&tasks);
        host.begin((positions.len() * self.scenes as usize * backends.len()) as u64, "answers");
        let (mut measures, mut places) = (Vec::new(), Vec::new());
        for position in &positions {
            host.turn_to(&format!("{}, {}", position.task, position.knob.name()));
            let of = self.at(position, backends, host)?;
            places.extend(of.iter().map(|_| (position.knob, position.at)));
            measures.extend(of);
        }
        let mut breaks = Vec::new();
        for task in tasks.iter().map(|task| task.name()) {
            for &knob in &knobs {
                let ways: &[&str] = if knob == Knob::Scale { &["down", "up"] } else { &["up"] };
                for (way, backend) in ways.iter().flat_map(|way| backends.iter().map(move |backend| (way, backend))) {
                    let name = backend.name();
                    let own = measures.iter().zip(&places).filter(|(row, _)| row.task == task && row.backend == name);
                    let rows: Vec<At<'_>> = own.map(|(row, &(knob, position))| At { knob, position, row }).collect();
                    breaks.push(break_point(task, knob, way, &name, &rows));
                }
            }
        }
        let limits = limits(&tasks, &knobs);
        let mut violations = Vec::new();
        if self.tuples > 0 {
            host.begin(backends.len() as u64, "backends");
            for backend in backends {
                violations.extend(laws::violations(*backend, self.tuples, self.seed)?);
                host.watch().done(1)?;
            }
        }
        let proved = |backend: &&dyn Contestant| {
            (backend.name(), backend.contract(predicament_predicates::PredicateKind::Orient2d).proved)
        };
        Ok(Stressed { tasks, measures, breaks, limits, violations, backends: backends.iter().map(proved).collect() })
    }

    fn rows(&self, measured: &Stressed) -> Result<Vec<File>, Error> {
        let mut files = vec![File::csv("stress.csv", &measured.measures)?, File::csv("breaks.csv", &measured.breaks)?];
        if !measured.limits.is_empty() {
            files.push(File::csv("limits.csv", &measured.limits)?);
        }
        files.push(File::csv("stress-laws.csv", &measured.violations)?);
        Ok(files)
    }

    fn page(&self, measured: &Stressed) -> String {
        table::page(measured)
    }

    fn plots(&self, measured: &Stressed) -> Result<Vec<File>, Error> {
        let mut files = plots::all(measured)?;
        files.extend(sweep::plot("stress-values", &measured.measures)?);
        Ok(files)
    }

    fn suites(&self, measured: &Stressed) -> Result<Vec<File>, Error> {
        let Some(folder) = &self.suites else { return Ok(Vec::new()) };
        suites::all(folder, &self.positions(&measured.tasks), self.seed, self.scenes)
    }

    fn holds(&self, measured: &Stressed) -> bool {
        let proved = |backend: &str| measured.backends.iter().any(|(name, proved)| name == backend && *proved);
        let is_broken = |row: &Measure| crate::compare::WRONG.contains(&row.measure.as_str()) && row.value > 0.0;
        !measured.measures.iter().any(|row| is_broken(row) && proved(&row.backend))
            && !measured.violations.iter().any(|row| row.violations > 0 && proved(&row.backend))
    }
}

impl Stress {
    fn knobs(&self) -> Vec<Knob> {
        Knob::ALL.into_iter().filter(|knob| self.knobs.is_empty() || self.knobs.contains(knob)).collect()
    }

    /// All positions of knobs at which these tasks have scenes.
    fn positions(&self, tasks: &[&'static dyn AnyTask]) -> Vec<Position> {
        let knobs = self.knobs();
        tasks.iter().flat_map(|task| knobs.iter().flat_map(|&knob| Position::all(*task, knob))).collect()
    }

    /// The measures of all backends for a position of a knob.
    fn at(&self, position: &Position, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Vec<Measure>, Error> {
        let seeds = (0..self.scenes).map(|at| self.seed + u64::from(at));
        let mut scenes: Vec<LoadedScene> = seeds.map(|seed| position.scene(seed)).collect::<Result<_, Error>>()?;
        // A deterministic family makes one scene.
        let mut known = BTreeSet::new();
        scenes.retain(|scene| known.insert(scene.id.clone()));
        let group = Group { task: position.input.task, kind: position.knob.name(), family: &position.at.to_string() };
        let timed = if self.samples > 0 { scenes.first() } else { None };
        measures_of(&group, &scenes, timed, backends, self.samples, host.watch())
    }
}
