//! The command line of the study, and its survey.

use predicament_tasks::{AnyTask, Contestant};

use super::{Row, apart, plots, table};
use crate::compare::{Input, asked};
use crate::steps::surveyed;
use crate::{Common, Error, File, Host, Study};

/// Scenes that grow tenfold.
#[derive(Clone, Debug, clap::Args)]
pub struct Scale {
    /// Backends
    #[arg(short = 'b', long = "backend", value_name = "BACKEND", default_value = "exact")]
    pub backends: Vec<String>,

    /// Tasks, several separated by commas; all that name such scenes if left out
    #[arg(short = 't', long = "task", value_name = "TASK", value_delimiter = ',')]
    pub tasks: Vec<String>,

    /// The smallest size
    #[arg(long, default_value_t = 10_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub min: u32,

    /// The largest size
    #[arg(long, default_value_t = 1_000_000, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub max: u32,

    /// The memory that an answer may take, in GiB, by what its task states
    #[arg(long, default_value_t = 8, value_name = "GIB", value_parser = clap::value_parser!(u32).range(1..))]
    pub memory: u32,

    /// Measure in this process and print the rows, as a new process does for its parent
    #[arg(long, hide = true)]
    pub alone: bool,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The bytes that a process takes for itself while it answers anything: stacks of threads, and pages of code.
const OWN: f64 = 4_194_304.0;

impl Study for Scale {
    const NAME: &'static str = "scale";
    const ASKS: &'static str = "Measure how time and memory grow with the scene, and check the memory that tasks state";
    const HELP: &'static str = "\
Each task names scenes of any size whose answers grow like the scenes. They are answered in sizes that grow tenfold, \
from --min to --max, by the method that is timed elsewhere, on --threads threads. Time is that of the session and the \
answer; memory is the peak of the process above its memory with the scene, where the system reports it (Linux). Each \
answer is measured in a process of its own, because a process reuses the memory of earlier answers. Scenes that by \
their task need more than --memory are refused. A process that crashes, or that the system kills when memory runs out, \
costs its row only.

The exit code is 100 if an answer took more memory than its task states.

Files in the folder: scale.csv (each scene), scale.md (the printed table), and plots of time and memory as SVG and PDF.

Examples:
  predicament study scale --out target/scale
  predicament study scale -t delaunay2d,hull3d --max 10000000 --memory 12 --threads 2";

    type Measured = Vec<Row>;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Vec<Row>, Error> {
        let scaled = host.tasks().iter().copied().filter(|task| task.scaled_on().is_some());
        let tasks = asked(scaled.collect(), &self.tasks, "scaled")?;
        let sizes: Vec<usize> = std::iter::successors(Some(self.min), |size| size.checked_mul(10))
            .take_while(|size| *size <= self.max)
            .map(|size| usize::try_from(size).unwrap_or(usize::MAX))
            .collect();
        let of_sizes = |(input, backend): (Input, _)| sizes.iter().map(move |&n| (input.sized(n), backend));
        let of_task = |task| backends.iter().filter_map(move |&backend| Some((input(task)?, backend)));
        let steps: Vec<(Input, &dyn Contestant)> = tasks.into_iter().flat_map(of_task).flat_map(of_sizes).collect();
        let name = |(input, _): &(Input, &dyn Contestant)| format!("{}, {}", input.task.name(), input.of.n);
        surveyed(host, "scenes", steps, name, |(input, backend)| apart::row(self, &input, backend, host).map(Some))
    }

    fn rows(&self, measured: &Vec<Row>) -> Result<Vec<File>, Error> {
        Ok(vec![File::csv("scale.csv", measured)?])
    }

    fn page(&self, measured: &Vec<Row>) -> String {
        table::page(measured)
    }

    fn plots(&self, measured: &Vec<Row>) -> Result<Vec<File>, Error> {
        plots::all(measured)
    }

    fn prints_rows(&self) -> bool {
        self.alone
    }

    fn holds(&self, measured: &Vec<Row>) -> bool {
        measured.iter().all(|row| row.bytes.is_nan() || row.stated.is_nan() || row.bytes <= row.stated + OWN)
    }
}

/// The scenes of a task that grow.
fn input(task: &'static dyn AnyTask) -> Option<Input> {
    task.scaled_on().map(|of| Input { task, of })
}
