//! The command line of the study of decimals, its survey and its output.

use predicament_families::{Figure, MOST_DIGITS, Place, Typed};
use predicament_tasks::{AnyTask, Contestant};

use super::survey::Kind;
use super::{Answered, FILE, Timed, plots, table};
use crate::{Common, Error, File, Host, Study};

/// Answers about decimals, by digits, distance from the origin and figure.
#[derive(Clone, Debug, clap::Args)]
pub struct Decimals {
    /// Backends, besides the grid of each number of digits
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        default_value = "exact,sos,tolerance,epsilon:1e-20,epsilon:1e-18,epsilon:1e-16,epsilon:1e-14,epsilon:1e-12,\
                         epsilon:1e-10,epsilon:1e-8,epsilon:1e-6,epsilon:1e-4,epsilon:1e-2,epsilon:1"
    )]
    pub backends: Vec<String>,

    /// Numbers of digits behind the point, from 0 to 12
    #[arg(
        long,
        value_delimiter = ',',
        default_value = "0,1,2,3,4,6,8,10,12",
        value_name = "DIGITS",
        value_parser = clap::value_parser!(u32).range(..=i64::from(MOST_DIGITS))
    )]
    pub digits: Vec<u32>,

    /// Queries of each kind
    #[arg(long, default_value_t = 500, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub queries: u32,

    /// Timed samples of each kind; 0 for no times
    #[arg(long, default_value_t = 3, value_name = "N")]
    pub samples: u32,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The answers and times of all backends.
#[derive(Clone, Debug)]
pub struct Measured {
    /// The answers.
    pub answered: Vec<Answered>,
    /// The times, of figures in general position only.
    pub timed: Vec<Timed>,
}

impl Study for Decimals {
    const NAME: &'static str = "decimals";
    const ASKS: &'static str = "Measure which backends are right about decimals as they were written";
    const HELP: &'static str = "\
Points are decimals with a number of digits behind the point: exactly on a line, plane, circle or sphere, or one step \
beside it. Backends get the nearest doubles. Their answers are compared with the exact signs of the decimals and of \
the doubles. `grid of the digits` is the backend grid:STEP whose step is the last digit.

Places: metres near the origin, degrees, survey coordinates far from the origin, and millimetres from fractions of an \
inch. Figures: in general position, rectangles and boxes turned by an angle of rational sine, and grids.

Files in the folder: decimals.csv (answers), decimals-time.csv (times), decimals.md (the printed tables), and plots of \
the share of right answers by digits as SVG and PDF, one for each place.

Examples:
  predicament study decimals --out target/decimals
  predicament study decimals --digits 0,1,2,3 -b exact,epsilon:1e-9 --queries 10000 --samples 0";

    type Measured = Measured;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Measured, Error> {
        let names = Typed::KINDS.iter().map(|kind| kind.name());
        let of_name = |name: &str| host.tasks().iter().copied().find(|task| task.name() == name);
        let tasks: Vec<&'static dyn AnyTask> = names.filter_map(of_name).collect();
        let total = tasks.len() * Figure::ALL.len() * Place::ALL.len() * self.digits.len();
        host.begin(total as u64, "kinds of queries");
        let mut measured = Measured { answered: Vec::new(), timed: Vec::new() };
        for place in Place::ALL.iter().map(|place| place.name()) {
            for &digits in &self.digits {
                let grid = host.backend(&format!("grid:1e-{digits}"))?;
                let all: Vec<&dyn Contestant> = backends.iter().copied().chain([grid.as_ref()]).collect();
                for &task in &tasks {
                    for &figure in Figure::ALL {
                        let samples = if figure == Figure::General { self.samples } else { 0 };
                        let kind = Kind { task, figure: figure.name(), place, digits };
                        let (rows, times) = kind.survey(&all, [self.queries, samples], self.common.seed, host)?;
                        measured.answered.extend(rows);
                        measured.timed.extend(times);
                        host.watch().done(1)?;
                    }
                }
            }
        }
        Ok(measured)
    }

    fn rows(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        let mut files = vec![File::csv(FILE, &measured.answered)?];
        if !measured.timed.is_empty() {
            files.push(File::csv("decimals-time.csv", &measured.timed)?);
        }
        Ok(files)
    }

    fn page(&self, measured: &Measured) -> String {
        table::page(measured)
    }

    fn plots(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        plots::all(&measured.answered)
    }

    /// The promise of the exact backend is about doubles, and holds here too; a grid promises nothing.
    fn holds(&self, measured: &Measured) -> bool {
        measured.answered.iter().filter(|row| row.backend == "exact").all(|row| row.doubles == row.answers)
    }
}
