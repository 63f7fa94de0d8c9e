//! `solve`: solves one scene under one backend and writes the answer as files for other programs.

use std::path::PathBuf;

use predicament_tasks::Purpose;

use crate::exit::{self, Failure};
use crate::one_scene::OneScene;
use crate::told::cure;
use crate::tool::Tool;

const EXAMPLES: &str = "\
The input is a scene of a suite, selected with -f, or a task on your own files: `solve TASK FILE…` makes a scene of \
that task with the names of the files in it. Set other keys of the scene with --set; docs/FORMAT.md describes them.

The output files have formats that other programs read. They hold doubles. If an answer has vertices, `vertices.json` \
has each vertex exactly, with the points from which it was constructed.

Examples:
  predicament solve tilings -f '/tiling$' -b exact --out out/tiling        GeoJSON of located points
  predicament solve mine.toml -f two-spheres -b sos --out out/contacts
  predicament solve crossings roads.geojson -b exact --out out/roads
  predicament solve contacts3d a.off b.ply -b tolerance --out out/contacts
  predicament solve mesh-locate part.stl probes.csv --set quick_stride=0 --out out/inside      regions of points
  predicament solve mesh-intersect part.stl tool.off -b sos:per-mesh --out out/cut      union, intersection, differences
  predicament solve mesh-intersect part.stl part.stl -b sos:per-mesh --set 'moved=[1, 0, 0]' --out out/step
  predicament solve orient2d survey.csv --set queries=all --round --out out/signs
  predicament solve delaunay2d towns.csv --columns lon,lat --out out/net";

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

    /// A folder for the files; it is created if it does not exist
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let backend = tool.backend(&args.backend).map_err(Failure::usage)?;
    let loaded = args.scene.load(tool)?;
    let task = tool.task(loaded.task);
    std::fs::create_dir_all(&args.out).map_err(Failure::io(&args.out))?;
    let mut written = Ok(Vec::new());
    backend
        .answer_any(task.name(), &loaded.scene, loaded.content.as_ref(), Purpose::Files, &mut |answer| {
            written = task.write_answer(&loaded, answer, &args.out);
        })
        .map_err(|why| Failure::usage(format!("{}: {why}{}", backend.name(), cure(&why))))?;
    for path in written.map_err(Failure::io(&args.out))? {
        say!("{}", path.display());
    }
    Ok(exit::OK)
}
