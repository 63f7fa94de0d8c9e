//! `solve`: solves one scene under one backend and writes the answer as files for other programs.

use std::path::PathBuf;

use predicament_corpus::LoadedScene;
use predicament_tasks::output::{Choice, Error, Written};
use predicament_tasks::{Budget, Purpose, Watch};

use crate::exit::{self, Failure};
use crate::one_scene::OneScene;
use crate::told::cure;
use crate::tool::Tool;
use crate::{interrupt, memory, progress};

const EXAMPLES: &str = "\
The input is a scene of a suite, selected with -f, or a task on your own files: `solve TASK FILE…` makes a scene of \
that task with the names of the files in it. Set other keys of the scene with --set; docs/FORMAT.md describes them.

The output files have formats that other programs read. They hold doubles. If an answer has constructed vertices, \
`vertices.json` has each of them exactly, with the points from which it was constructed.

Without --format and --only every file is written, except for three kinds. `vertices.json` of an answer without \
constructed vertices is written with `--only vertices` or `--format json`. A picture of more than 10,000 parts is drawn \
with `--format svg`. STL (in ASCII) and WKT are written with `--format stl` and `--format wkt`. An error about a format \
or a part names those that the answer has.

Examples:
  predicament solve tilings -f '/tiling$' -b exact --out out/tiling        GeoJSON of located points
  predicament solve mine.toml -f two-spheres -b sos --out out/contacts
  predicament solve delaunay2d survey.csv --format geojson --out out/triangles
  predicament solve crossings roads.geojson -b exact --out out/roads
  predicament solve contacts3d a.off b.ply -b tolerance --out out/contacts
  predicament solve mesh-locate part.stl probes.csv --set quick_stride=0 --out out/inside      regions of points
  predicament solve mesh-intersect part.stl tool.off -b sos:per-mesh --out out/cut      union, intersection, differences
  predicament solve mesh-intersect a.off b.off -b sos:per-mesh --only union --format stl --out out
  predicament solve mesh-intersect part.stl part.stl -b sos:per-mesh --set 'moved=[1, 0, 0]' --out out/step
  predicament solve orient2d survey.csv --set queries=all --round --out out/signs
  predicament solve delaunay2d towns.csv --columns lon,lat --out out/net
  predicament solve hull2d towns.csv --set truth=decimals --out out/hull      judged by what was written, too";

/// Solve one scene, or a task on your own files, under one backend, and write the answer
#[derive(clap::Args)]
#[command(
    after_help = EXAMPLES,
    override_usage = "predicament solve [OPTIONS] --out <DIR> SUITE -f RE\n       \
                      predicament solve [OPTIONS] --out <DIR> TASK FILE..."
)]
pub struct Args {
    #[command(flatten)]
    pub scene: OneScene,

    /// The backend
    #[arg(short = 'b', long = "backend", value_name = "BACKEND", default_value = "exact")]
    pub backend: String,

    /// Only files of these formats, by file extension: several with commas, such as geojson,svg
    #[arg(long = "format", value_name = "FORMAT", value_delimiter = ',')]
    pub formats: Vec<String>,

    /// Only these parts of the answer, by file name without extension: several with commas, such as union,part-0
    #[arg(long = "only", value_name = "PART", value_delimiter = ',')]
    pub parts: Vec<String>,

    /// The memory that the answer may take, in GiB [default: what the system has left]
    #[arg(long, value_name = "GIB", allow_hyphen_values = true, value_parser = memory::limit)]
    pub memory: Option<f64>,

    /// A folder for the files; it is created if it does not exist
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    interrupt::leave_at_once();
    let working = progress::working("reading the scene");
    let backend = tool.backend(&args.backend).map_err(Failure::usage)?;
    let loaded = args.scene.load(tool)?;
    let task = tool.task(loaded.task);
    if let Some(needed) = task.memory_of(&loaded) {
        memory::check(needed, args.memory).map_err(|why| about(args, &loaded, &backend.name(), why))?;
    }
    working.now(format!("solving {} with {}", task.name(), backend.name()));
    let choice = Choice { formats: args.formats.clone(), parts: args.parts.clone() };
    let mut written = Ok(Written::default());
    let solved = predicament_tasks::caught(|| {
        backend.answer_any(task.name(), &loaded.scene, loaded.content.as_ref(), Purpose::Files, &mut |answer| {
            working.now(format!("writing files into {}", args.out.display()));
            written = task.write_answer(&loaded, answer, &args.out, &choice);
        })
    });
    drop(working);
    if loaded.written.is_some() {
        let quiet = |_: u64| {};
        let watch = Watch::new(interrupt::flag(), None, &quiet);
        let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
        let case = task.case(&loaded, &watch).map_err(stopped)?;
        let outcome =
            predicament_oracle::run(case.as_ref(), backend.as_ref(), Budget::QUICK, &watch).map_err(stopped)?;
        outcome.agreement.iter().for_each(|agreement| note!("{}: {agreement}", args.scene.named(&loaded)));
    }
    match solved {
        Ok(Ok(())) => {}
        Ok(Err(why)) => return Err(about(args, &loaded, &backend.name(), format!("{why}{}", cure(&why)))),
        Err(broken) => return Err(about(args, &loaded, &backend.name(), broken)),
    }
    let Written { files, notes } = written.map_err(|error| not_written(args, &loaded, &backend.name(), error))?;
    for note in notes {
        note!("{}: {note}", args.scene.named(&loaded));
    }
    for path in files {
        say!("{}", path.display());
    }
    Ok(exit::OK)
}

/// A failure of a backend on a scene, with the files that the scene is made of.
fn about(args: &Args, loaded: &LoadedScene, backend: &str, why: impl std::fmt::Display) -> Failure {
    Failure::usage(format!("{}: {backend}: {why}", args.scene.named(loaded)))
}

/// The file system's errors are about the output, a file that cannot hold the answer is about the scene.
fn not_written(args: &Args, loaded: &LoadedScene, backend: &str, error: Error) -> Failure {
    match error {
        Error::System(error) => Failure::usage(error),
        Error::Unknown { what, .. } | Error::NoFile { what, .. } => {
            let option = if what == "format" { "--format" } else { "--only" };
            Failure::usage(format!("{option}: {error}"))
        }
        error => about(
            args,
            loaded,
            backend,
            format!("{error}; choose other files with --format or --only, or correct the input"),
        ),
    }
}
