//! The command line of the study of laws, its survey and its rows.

use std::panic::{PanicHookInfo, set_hook, take_hook};

use clap::ValueEnum;
use predicament_tasks::Contestant;
use serde::Serialize;

use super::{Row, Survey, survey, table};
use crate::{Common, Error, File, Host, Study};

/// The default backends: those whose promise is proved.
const DEFAULT: &str = "exact,sos,sos:edelsbrunner-mucke,tolerance";

/// The laws of predicates, checked on tuples full of ties.
#[derive(Clone, Debug, clap::Args)]
pub struct Laws {
    /// Backends, by commas or repeated
    #[arg(short = 'b', long = "backend", value_name = "BACKEND", default_value = DEFAULT)]
    pub backends: Vec<String>,

    /// Random tuples of each backend, rounded up to whole scenes
    #[arg(long, default_value_t = 1_000_000, value_name = "N")]
    pub tuples: u64,

    /// A table of violations with the first of each, or one CSV row for each backend and law
    #[arg(long, value_enum, default_value_t = Format::Md)]
    pub format: Format,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The printed format.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Format {
    /// CSV: backend, law, predicates, tuples, violations, panics, first.
    Csv,
    /// Tables as Markdown, aligned.
    Md,
}

/// A backend and the counts of each law.
#[derive(Clone, PartialEq, Debug)]
pub struct Surveyed {
    /// The backend's name.
    pub backend: String,
    /// One row for each law and its predicates.
    pub rows: Vec<Row>,
}

impl Study for Laws {
    const NAME: &'static str = "laws";
    const ASKS: &'static str =
        "Check backends against the laws of predicates: antisymmetry, transitivity, Grassmann-Plücker relations";
    const HELP: &'static str = "\
The scenes have about a dozen vertices. Every tuple of whole small grids with one point twice is tested; --tuples are \
drawn from random scenes (small grids, integers, lines, circles and spheres, far from the origin, mixed exponents). docs/LAWS.md lists the laws; only `equals-exact` needs a judge.

A cell of the table is the number of violations. If a backend answers fewer tuples than others, the number of tuples \
follows after a slash. A dash means declined or not promised. `2p` means two panics.

Exit code 100 if a backend breaks a law, or panics.

Examples:
  predicament study laws
  predicament study laws -b sos,sos:edelsbrunner-mucke --tuples 10000000
  predicament study laws -b naive,shewchuk,fault:sos-colliding-lift --seed 2
  predicament study laws --format csv > laws.csv";

    type Measured = Vec<Surveyed>;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Vec<Surveyed>, Error> {
        let plan = Survey { tuples: self.tuples, seed: self.common.seed };
        host.begin(plan.total() * backends.len() as u64, "tuples");
        let _muted = Muted::new();
        let one = |backend: &&dyn Contestant| {
            let name = backend.name();
            host.turn_to(&name);
            Ok(Surveyed { rows: survey(*backend, plan, host.watch())?, backend: name })
        };
        backends.iter().map(one).collect()
    }

    fn rows(&self, measured: &Vec<Surveyed>) -> Result<Vec<File>, Error> {
        let records = measured.iter().flat_map(|one| one.rows.iter().map(|row| Record::of(&one.backend, row)));
        Ok(vec![File::csv("laws.csv", records)?])
    }

    fn page(&self, measured: &Vec<Surveyed>) -> String {
        table::page(self, measured)
    }

    fn holds(&self, measured: &Vec<Surveyed>) -> bool {
        measured.iter().flat_map(|one| &one.rows).all(Row::holds)
    }

    fn prints_rows(&self) -> bool {
        self.format == Format::Csv
    }
}

#[derive(Serialize)]
struct Record<'a> {
    backend: &'a str,
    law: &'a str,
    predicates: &'a str,
    tuples: u64,
    violations: u64,
    panics: u64,
    first: String,
}

impl Record<'_> {
    fn of<'a>(backend: &'a str, row: &'a Row) -> Record<'a> {
        Record {
            backend,
            law: row.law.name(),
            predicates: &row.subject,
            tuples: row.tuples,
            violations: row.violations,
            panics: row.panics,
            first: row.first.as_ref().map(ToString::to_string).unwrap_or_default(),
        }
    }
}

/// Suppresses the message of each panic, until it is dropped.
///
/// Panics are counted and the first is reported; a million panics need no million backtraces.
struct Muted(Option<Hook>);

type Hook = Box<dyn Fn(&PanicHookInfo<'_>) + Sync + Send>;

impl Muted {
    fn new() -> Muted {
        let before = take_hook();
        set_hook(Box::new(|_| {}));
        Muted(Some(before))
    }
}

impl Drop for Muted {
    fn drop(&mut self) {
        // A thread that panics cannot change the hook.
        if let Some(before) = self.0.take().filter(|_| !std::thread::panicking()) {
            set_hook(before);
        }
    }
}
