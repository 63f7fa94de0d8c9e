//! The command line of the stress study, its survey and its rows.

use std::path::{Path, PathBuf};

use predicament_corpus::{LoadedScene, Random};
use predicament_tasks::Contestant;

use super::breaks::{At, break_point};
use super::moved::moved;
use super::{BreakPoint, Knob, Violations, laws, plots, table};
use crate::compare::{Group, INPUTS, Input, Kind, Measure, measures_of};
use crate::laws::Format;
use crate::{Error, File, Host, Study};

/// The tasks whose scenes stay scenes where their points move.
const TASKS: [&str; 10] = [
    "orient2d",
    "orient3d",
    "incircle",
    "insphere",
    "contacts2d",
    "contacts3d",
    "crossings",
    "delaunay2d",
    "hull3d",
    "mesh-intersect",
];

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

    /// Tasks, several with commas; all if left out
    #[arg(short = 't', long = "task", value_name = "TASK", value_delimiter = ',')]
    pub tasks: Vec<String>,

    /// Knobs, several with commas; all if left out
    #[arg(short = 'k', long = "knob", value_enum, value_name = "KNOB", value_delimiter = ',')]
    pub knobs: Vec<Knob>,

    /// Scenes at each position of a knob
    #[arg(long, default_value_t = 3, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub scenes: u32,

    /// Samples of the time at each position; none if 0
    #[arg(long, default_value_t = 0, value_name = "N")]
    pub samples: u32,

    /// Tuples for each metamorphic law and predicate; none if 0
    #[arg(long, default_value_t = 400, value_name = "N")]
    pub tuples: u32,

    /// The seed of the first scene; the next ones follow
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,

    /// Tables, or one CSV row for each number
    #[arg(long, value_enum, default_value_t = Format::Md)]
    pub format: Format,
}

/// All measures, break points, and violations of laws.
#[derive(Clone, PartialEq, Debug)]
pub struct Stressed {
    /// By task, knob and position; `kind` is the knob and `family` its position.
    pub measures: Vec<Measure>,
    /// For each task, knob, way and backend.
    pub breaks: Vec<BreakPoint>,
    /// By backend, predicate and law.
    pub violations: Vec<Violations>,
    /// The backends by name, and whether their promise is proved.
    pub backends: Vec<(String, bool)>,
}

impl Study for Stress {
    const NAME: &'static str = "stress";
    const ASKS: &'static str =
        "Turn one knob at a time until backends break: noise, translation, scale, aspect, precision, rotation";
    const HELP: &'static str = "\
A scene is made for each task, general or degenerate as the knob needs it, and its points are moved as the knob says.
What is true is found anew for each scene. A backend holds where it answers every scene of a position as it promises; its
break point is between the last position where it does and the first where it does not.

Metamorphic laws need no truth: signs are the same where points are scaled by a power of two, moved by integers or named
otherwise, opposite where they are reflected, times the determinant's sign under an integer matrix; and incircle is
orient3d of lifted points.

Written to the folder: stress.csv (a row for each number, with its interval; `kind` is the knob, `family` its position),
breaks.csv, stress-laws.csv, stress.md (the tables that are printed), a plot for each knob.

Exit codes: 0 if no backend with a proved promise breaks or violates a law, 100 otherwise.

Examples:
  predicament stress --out target/stress
  predicament stress -k noise,translation -t orient2d,orient3d --scenes 50 --out target/noise
  predicament stress -k size --samples 7 --out target/growth            time along a knob";

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
        let (tasks, knobs) = (self.tasks()?, self.knobs());
        let positions: usize = knobs.iter().map(|knob| knob.positions().len()).sum();
        host.begin((tasks.len() * positions * self.scenes as usize * backends.len()) as u64, "answers");
        let (mut measures, mut places) = (Vec::new(), Vec::new());
        for &task in &tasks {
            for &knob in &knobs {
                host.turn_to(&format!("{task}, {}", knob.name()));
                for &position in knob.positions().iter().filter(|&&position| knob.is_for(task, position)) {
                    let of = self.at(task, knob, position, backends, host)?;
                    places.extend(of.iter().map(|_| (knob, position)));
                    measures.extend(of);
                }
            }
        }
        let mut breaks = Vec::new();
        for &task in &tasks {
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
        Ok(Stressed { measures, breaks, violations, backends: backends.iter().map(proved).collect() })
    }

    fn rows(&self, measured: &Stressed) -> Result<Vec<File>, Error> {
        Ok(vec![
            File::csv("stress.csv", &measured.measures)?,
            File::csv("breaks.csv", &measured.breaks)?,
            File::csv("stress-laws.csv", &measured.violations)?,
        ])
    }

    fn page(&self, measured: &Stressed) -> String {
        table::page(measured)
    }

    fn plots(&self, measured: &Stressed) -> Result<Vec<File>, Error> {
        plots::all(measured)
    }

    fn holds(&self, measured: &Stressed) -> bool {
        let proved = |backend: &str| measured.backends.iter().any(|(name, proved)| name == backend && *proved);
        let is_broken = |row: &Measure| crate::compare::WRONG.contains(&row.measure.as_str()) && row.value > 0.0;
        !measured.measures.iter().any(|row| is_broken(row) && proved(&row.backend))
            && !measured.violations.iter().any(|row| row.violations > 0 && proved(&row.backend))
    }
}

impl Stress {
    fn tasks(&self) -> Result<Vec<&'static str>, Error> {
        if let Some(unknown) = self.tasks.iter().find(|task| !TASKS.contains(&task.as_str())) {
            return Err(Error::unfit(format!("no task `{unknown}` is stressed; there are {}", TASKS.join(", "))));
        }
        let is_asked = |task: &&str| self.tasks.is_empty() || self.tasks.iter().any(|asked| asked == task);
        Ok(TASKS.into_iter().filter(is_asked).collect())
    }

    fn knobs(&self) -> Vec<Knob> {
        Knob::ALL.into_iter().filter(|knob| self.knobs.is_empty() || self.knobs.contains(knob)).collect()
    }

    /// The measures of all backends where a knob is at a position.
    fn at(
        &self,
        task: &'static str,
        knob: Knob,
        position: i32,
        backends: &[&dyn Contestant],
        host: &dyn Host,
    ) -> Result<Vec<Measure>, Error> {
        let kind = if knob.is_of_degenerate() { Kind::Degenerate } else { Kind::General };
        let input = INPUTS.iter().find(|input| input.task == task && input.kind == kind);
        let Some(input) = input else { return Ok(Vec::new()) };
        let times = if knob == Knob::Size { usize::try_from(position).unwrap_or(1) } else { 1 };
        let small = Input { n: (input.n / 4).max(12) * times, ..*input };
        let scene = |at: u32| -> Result<LoadedScene, Error> {
            let seed = self.seed + u64::from(at);
            let loaded = small.scene(seed)?;
            let mut random = Random::new(knob.name(), task, seed);
            let coordinates = knob.turned(position, loaded.scene.dimension(), loaded.scene.coordinates(), &mut random);
            moved(loaded, coordinates)
        };
        let scenes: Vec<LoadedScene> = (0..self.scenes).map(scene).collect::<Result<_, Error>>()?;
        let group = Group { task, kind: knob.name(), family: &position.to_string() };
        let timed = if self.samples > 0 { scenes.first() } else { None };
        measures_of(&group, &scenes, timed, backends, self.samples, host.watch())
    }
}
