//! The command line of the study, and its survey.

use std::time::Instant;

use predicament_tasks::{Compared, Contestant, Purpose, caught};

use super::{Row, plots, table};
use crate::compare::{Input, peak};
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

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// The bytes that a process takes for itself while it answers anything: stacks of threads, and pages of code.
const OWN: f64 = 16_777_216.0;

impl Study for Scale {
    const NAME: &'static str = "scale";
    const ASKS: &'static str = "Measure how time and memory grow with the scene, and check the memory that tasks state";
    const HELP: &'static str = "\
Each task names scenes of any size whose answers grow like the scenes. They are answered in sizes that grow tenfold, \
from --min to --max, by the method that is timed elsewhere, on --threads threads. Time is that of the session and the \
answer; memory is the peak of the process above its memory before, where the system reports it (Linux). A process reuses memory \
of earlier scenes: for the memory of one size, ask for that task and size alone. Scenes that by their task need more \
than --memory are not answered.

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
        let all: Vec<Input> =
            host.tasks().iter().filter_map(|&task| task.scaled_on().map(|of| Input { task, of })).collect();
        if let Some(unknown) = self.tasks.iter().find(|name| all.iter().all(|input| input.task.name() != name.as_str()))
        {
            let names: Vec<&str> = all.iter().map(|input| input.task.name()).collect();
            return Err(Error::unfit(format!(
                "task `{unknown}` has no such scenes; the tasks are {}",
                names.join(", ")
            )));
        }
        let is_asked =
            |input: &&Input| self.tasks.is_empty() || self.tasks.iter().any(|name| name == input.task.name());
        let inputs: Vec<&Input> = all.iter().filter(is_asked).collect();
        let sizes: Vec<usize> = std::iter::successors(Some(self.min), |size| size.checked_mul(10))
            .take_while(|size| *size <= self.max)
            .map(|size| usize::try_from(size).unwrap_or(usize::MAX))
            .collect();
        host.begin((inputs.len() * sizes.len() * backends.len()) as u64, "scenes");
        let mut rows = Vec::new();
        for input in inputs {
            host.turn_to(input.task.name());
            for backend in backends {
                for &size in &sizes {
                    rows.push(self.row(input, size, *backend)?);
                    host.watch().done(1)?;
                }
            }
        }
        Ok(rows)
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

    fn holds(&self, measured: &Vec<Row>) -> bool {
        measured.iter().all(|row| row.bytes.is_nan() || row.stated.is_nan() || row.bytes <= row.stated + OWN)
    }
}

impl Scale {
    fn row(&self, input: &Input, size: usize, backend: &dyn Contestant) -> Result<Row, Error> {
        let Input { task, of } = *input;
        let input = Input { task, of: Compared { n: size, ..of } };
        let loaded = input.scene(self.common.seed)?;
        let bytes = |bytes: Option<u64>| bytes.map_or(f64::NAN, predicament_records::approximately);
        let stated = task.memory_of(&loaded);
        let mut row = Row {
            task: task.name().to_owned(),
            family: of.family.to_owned(),
            backend: backend.name(),
            size: task.size_of(&loaded),
            outcome: "refused".to_owned(),
            seconds: f64::NAN,
            bytes: f64::NAN,
            stated: bytes(stated),
        };
        if stated.is_some_and(|stated| stated >> 30 >= u64::from(self.memory)) {
            return Ok(row);
        }
        let (scene, content) = (&loaded.scene, loaded.content.as_ref());
        let mut answered = None;
        let start = Instant::now();
        let most = peak(|| {
            answered = Some(caught(|| backend.answer_any(task.name(), scene, content, Purpose::Use, &mut |_| {})));
        });
        row.seconds = start.elapsed().as_secs_f64();
        row.bytes = bytes(most);
        row.outcome = match answered {
            Some(Ok(Ok(()))) => "answered",
            Some(Err(broken)) => broken.class.name(),
            _ => "declined",
        }
        .to_owned();
        if row.outcome != "answered" {
            (row.seconds, row.bytes) = (f64::NAN, f64::NAN);
        }
        Ok(row)
    }
}
