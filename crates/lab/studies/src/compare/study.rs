//! The command line of the comparison, its survey and its rows.

use std::path::{Path, PathBuf};

use predicament_predicates::{PredicateKind, ZeroMeaning};
use predicament_tasks::Contestant;
use serde::{Deserialize, Serialize};

use super::measure::{About, FEATURES as FEATURES_TASK, Measure};
use super::{Conditioned, Input, compared, conditioning, inputs, survey, table, tradeoff};
use crate::contacts::contacts;
use crate::laws::Format;
use crate::resolution::{self, FEATURES};
use crate::{Error, File, Host, Precision, Study};

/// Backends of all philosophies on the same scenes.
#[derive(Clone, Debug, clap::Args)]
pub struct Compare {
    /// Backends
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        default_value = "tolerance,tolerance:f32,sos,sos:per-mesh,exact,exact:rational,naive,naive:nalgebra,epsilon:1e-10,shewchuk"
    )]
    pub backends: Vec<String>,

    /// Tasks, several separated by commas; all if left out
    #[arg(short = 't', long = "task", value_name = "TASK", value_delimiter = ',')]
    pub tasks: Vec<String>,

    /// Scenes of each kind for each task
    #[arg(long, default_value_t = 20, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub scenes: u32,

    /// Samples of each time; not timed if 0
    #[arg(long, default_value_t = 7, value_name = "N")]
    pub samples: u32,

    /// Positions of each feature at each size; sizes of features are left out if 0
    #[arg(long, default_value_t = 40, value_name = "N")]
    pub trials: u32,

    /// Queries of each predicate for each noise on degenerate scenes; error against conditioning is left out if 0
    #[arg(long, default_value_t = 400, value_name = "N")]
    pub queries: usize,

    /// The seed of the first scene; later scenes use the next seeds
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,

    /// Tables, or one CSV row for each number
    #[arg(long, value_enum, default_value_t = Format::Md)]
    pub format: Format,
}

/// All measures, and the promises of the backends.
#[derive(Clone, PartialEq, Debug)]
pub struct Compared {
    /// The measures in the order of inputs and backends; sizes of features come last.
    pub measures: Vec<Measure>,
    /// The errors by degeneracy of queries.
    pub conditioning: Vec<Conditioned>,
    /// The promise of each backend.
    pub promises: Vec<Promise>,
}

/// A backend's promise about the sign of a determinant: a row of `promises.csv`.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Promise {
    /// The backend's name, with its parameters.
    pub backend: String,
    /// The promise in a few words.
    pub promise: String,
    /// True if the promise is proved.
    pub proved: bool,
}

impl Study for Compare {
    const NAME: &'static str = "compare";
    const ASKS: &'static str = "Compare the philosophies on the same scenes: promises, errors, topology, time, memory";
    const HELP: &'static str = "\
Each task has --scenes scenes of each kind: general position, nearly degenerate, degenerate. Their seeds are \
consecutive. A family without randomness makes one scene, which counts once. Every backend answers all scenes, and is \
judged as by `run`. Contacts are compared with the contacts of the simplices in rationals. Times are of one scene of \
each kind, eight times as large, on one thread, with the backends in turns. Memory is the additional memory of the \
process while a backend prepares and answers that scene, if the system reports it (Linux). It is a lower bound: memory \
that earlier backends and scenes freed is used again. For large scenes, `study scale` measures each answer in a process \
of its own.

A ratio of times is a geometric mean over the inputs that the backend and `exact` both answered; the number of these \
inputs is shown. It leaves out inputs whose time barely depends on predicates: those where `exact` takes less than \
1.1 times its time if it computes each answer twice. Errors are over the backend's own scenes and answers, so no \
other backend changes a number.

Columns of compare.csv:
  task, kind, family     the input: task, general, near or degenerate, and the family of the scenes
  backend                with its parameters
  measure, unit          the measure and its unit: shares of scenes queried (right, undecided, rounded, not done, \
                         declined), per 1000 scenes answered (wrong scenes, topology and its checks), per 10^6 answers \
                         (wrong answers and each class), shares of queries (stages), times, bytes, bits, and errors of \
                         contacts
  value, low, high       the number and its interval: Wilson's at 95 % for shares, the smallest and the largest sample \
                         for times
  of                     the base of the number: scenes, answers, samples

Files in the folder: compare.csv, promises.csv (what each backend promises, and whether that is proved), compare.md \
(the printed tables), conditioning.csv and plots of it (wrong answers by degeneracy of queries, with each backend's \
band), error-time plots (errors against time). Each plot is also written as PDF.

Exit codes: 0 if no backend with a proved promise has given an answer against it, 100 otherwise.

Examples:
  predicament study compare --out target/compare
  predicament study compare -b tolerance,sos,exact -t contacts2d,contacts3d --scenes 200 --out target/contacts
  predicament study compare -b exact,epsilon:1e-16,epsilon:1e-12,epsilon:1e-8,tolerance,tolerance:f32 --out target/curves
  predicament study compare --samples 0 --trials 0 --out target/errors        errors only: the same bytes on every machine";

    type Measured = Compared;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn out(&self) -> Option<&Path> {
        Some(&self.out)
    }

    fn prints_rows(&self) -> bool {
        self.format == Format::Csv
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Compared, Error> {
        let inputs = self.inputs(host)?;
        let scenes = inputs.len() * self.scenes as usize * backends.len();
        host.begin(scenes as u64, "answers");
        let mut measures = Vec::new();
        for input in inputs {
            host.turn_to(input.task.name());
            measures.extend(survey::measures(&input, backends, [self.scenes, self.samples], self.seed, host)?);
        }
        if self.trials > 0 && self.tasks.is_empty() {
            host.begin((backends.len() * FEATURES.len()) as u64, "features");
            for &backend in backends {
                host.turn_to(&backend.name());
                measures.extend(self.features(backend, host)?);
            }
        }
        let mut conditioned = Vec::new();
        if self.queries > 0 && self.tasks.is_empty() {
            host.begin(conditioning::steps(backends.len()) as u64, "scenes");
            conditioned = conditioning::conditioning(backends, self.queries, self.seed, host.watch())?;
        }
        let promises = backends.iter().map(|backend| promise(*backend)).collect();
        Ok(Compared { measures, conditioning: conditioned, promises })
    }

    fn rows(&self, measured: &Compared) -> Result<Vec<File>, Error> {
        let mut files =
            vec![File::csv("compare.csv", &measured.measures)?, File::csv("promises.csv", &measured.promises)?];
        if !measured.conditioning.is_empty() {
            files.push(File::csv("conditioning.csv", &measured.conditioning)?);
        }
        Ok(files)
    }

    fn plots(&self, measured: &Compared) -> Result<Vec<File>, Error> {
        let mut files = conditioning::plots(&measured.conditioning)?;
        files.extend(tradeoff::plots(&measured.measures)?);
        Ok(files)
    }

    fn page(&self, measured: &Compared) -> String {
        table::page(measured) + &conditioning::page(&measured.conditioning)
    }

    fn holds(&self, measured: &Compared) -> bool {
        let proved = |backend: &str| measured.promises.iter().any(|of| of.backend == backend && of.proved);
        let is_broken = |row: &Measure| super::table::WRONG.contains(&row.measure.as_str()) && row.value > 0.0;
        !measured.measures.iter().any(|row| is_broken(row) && proved(&row.backend))
    }
}

impl Compare {
    fn inputs(&self, host: &dyn Host) -> Result<Vec<Input>, Error> {
        Ok(inputs(&compared(host.tasks(), &self.tasks, "compared")?))
    }

    /// The smallest size of each feature from which on a backend distinguishes it.
    fn features(&self, backend: &dyn Contestant, host: &dyn Host) -> Result<Vec<Measure>, Error> {
        let name = backend.name();
        let mut all = Vec::new();
        for feature in FEATURES {
            let dimension = format!("{}D", feature.dimension.count());
            let about = About { task: FEATURES_TASK, kind: &dimension, family: feature.name, backend: &name };
            let ask: &resolution::Ask<'_> = &|scene, a, b| contacts(backend, scene, [a, b]);
            let length = resolution::length(&name, feature.dimension);
            let precision = Precision::of_backend(&name);
            // A backend that declines has no sizes.
            if let Ok(survey) = resolution::survey(feature, ask, length, precision, self.trials, self.seed) {
                let smallest = survey.shares.first().map_or(0.0, |(size, _)| *size);
                let safe = survey.safe().unwrap_or(f64::INFINITY);
                let lost = survey.lost().unwrap_or(0.0);
                // Sizes below the smallest are not tested.
                let value = if safe <= smallest { 0.0 } else { safe };
                all.push(about.measure("smallest feature", "L", value, [lost, safe], self.trials.into()));
            }
            host.watch().done(1)?;
        }
        Ok(all)
    }
}

/// The promise of a backend.
fn promise(backend: &dyn Contestant) -> Promise {
    let contract = backend.contract(PredicateKind::Orient2d);
    let words = match contract.zero {
        ZeroMeaning::Exact => "the sign; zero is zero",
        ZeroMeaning::Never => "the sign of a perturbed scene; never zero",
        ZeroMeaning::Band => "a sign is right; zero is within a band",
    };
    Promise { backend: backend.name(), promise: words.to_owned(), proved: contract.proved }
}
