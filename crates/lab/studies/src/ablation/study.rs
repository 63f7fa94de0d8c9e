//! The command line of the study, its survey and its output.

use predicament_corpus::LoadedScene;
use predicament_tasks::{Compared, Contestant};

use super::row::whole_of;
use super::{FILE, Row, plots, survey, table};
use crate::compare::{Input, compared, inputs};
use crate::steps::surveyed;
use crate::{Common, Error, File, Host, Study};

/// The whole and variants that lack a device, in turns.
#[derive(Clone, Debug, clap::Args)]
pub struct Ablation {
    /// Variants, each of which is compared with the backend that has all devices
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        default_value = "exact,exact:without=plan,exact:without=static,exact:without=semi-static,exact:without=doubles,\
                         exact:without=integers,exact:without=batch,exact:without=near-search,\
                         exact:without=empty-cells,sos:without=leading,sos:per-mesh:without=set-aside"
    )]
    pub backends: Vec<String>,

    /// Tasks, several separated by commas; all if left out
    #[arg(short = 't', long = "task", value_name = "TASK", value_delimiter = ',')]
    pub tasks: Vec<String>,

    /// Samples of each time
    #[arg(long, default_value_t = 15, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub samples: u32,

    /// The size of a scene, at most, before it is enlarged for timing: queries, or the task's own measure
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub size: Option<u32>,

    /// Seed, threads and folder
    #[command(flatten)]
    pub common: Common,
}

/// More scenes: meshes of at least 4,096 triangles with a part in common, in which triangles are set aside.
const MORE: [(&str, Compared); 1] =
    [("mesh-intersect", Compared::degenerate("intersect-spheres", 800).with("placed = \"same\""))];

impl Study for Ablation {
    const NAME: &'static str = "ablation";
    const ASKS: &'static str = "Measure what each device of `exact` saves: its time without one device at a time";
    const HELP: &'static str = "\
A variant BACKEND:without=DEVICE lacks one device and gives the same answers. Devices of predicates are plan, static, \
semi-static, doubles, integers and batch, and of `sos` leading. Devices of algorithms are near-search, empty-cells and \
set-aside. On one scene of every kind of every task, the variants take turns with BACKEND:without=nothing, which \
has all devices: each sample begins with another variant. A ratio is the time of a variant over the time of the whole \
in the same sample; a ratio above 1 is what the device saves. Tasks that ask for signs are timed by single queries and \
by batches, all others by whole answers, on one thread, after the session was prepared.

`exact` is the backend itself. On tasks that ask for signs its ratio is 1 if the control is a true copy. On other tasks \
it is compiled into the algorithm, while the control answers through a pointer.

The exit code is 100 if a variant has other answers than the whole.

Files in the folder: ablation.csv (each variant on each scene), ablation.md (the printed tables), and a plot of the \
ratios as SVG and PDF.

Examples:
  predicament study ablation --out target/ablation
  predicament study ablation -t orient3d,hull3d --samples 31
  predicament study ablation -b exact:without=batch,naive -t orient2d      naive has other answers";

    type Measured = Vec<Row>;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Vec<Row>, Error> {
        let tasks = compared(host.tasks(), &self.tasks, "timed without a device")?;
        let mut names: Vec<String> = backends.iter().map(|backend| whole_of(&backend.name())).collect();
        names.sort_unstable();
        names.dedup();
        let wholes = names.iter().map(|name| host.backend(name)).collect::<Result<Vec<_>, _>>()?;
        let mut inputs = inputs(&tasks);
        for &task in &tasks {
            let more = MORE.iter().filter(|(of, _)| *of == task.name());
            inputs.extend(more.map(|&(_, of)| Input { task, of }));
        }
        let name = |input: &Input| input.task.name().to_owned();
        surveyed(host, "scenes", inputs, name, |input| {
            let (input, loaded) = self.scene(input)?;
            survey::rows(&input, &loaded, backends, &wholes, self.samples, host.watch())
        })
    }

    fn rows(&self, measured: &Vec<Row>) -> Result<Vec<File>, Error> {
        Ok(vec![File::csv(FILE, measured)?])
    }

    fn page(&self, measured: &Vec<Row>) -> String {
        table::page(measured)
    }

    fn plots(&self, measured: &Vec<Row>) -> Result<Vec<File>, Error> {
        plots::all(measured)
    }

    fn holds(&self, measured: &Vec<Row>) -> bool {
        measured.iter().all(|row| row.answers == "equal" || row.answers == "declined")
    }
}

impl Ablation {
    /// The scene of an input, of at most the size that is asked for.
    fn scene(&self, input: Input) -> Result<(Input, LoadedScene), Error> {
        let size = self.size.map_or(usize::MAX, |size| usize::try_from(size).unwrap_or(usize::MAX));
        let input = input.sized(input.of.n.min(size));
        Ok((input, input.timed(self.common.seed)?))
    }
}
