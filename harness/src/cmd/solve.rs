//! `solve`: one scene under one backend, the answer as files for other programs.

use std::path::PathBuf;

use crate::exit::{self, Failure};
use crate::out::program;
use crate::select::Selector;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament solve tilings -f '/tiling$' -b exact --out out/tiling        GeoJSON of located points
  predicament solve mine.toml -f two-spheres -b sos --out out/contacts";

/// Solve one scene under one backend and write the answer
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,

    /// The backend
    #[arg(short = 'b', long = "backend", value_name = "BACKEND", default_value = "exact")]
    pub backend: String,

    /// A folder for the files; made if need be
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let backend = tool.backend(&args.backend).map_err(Failure::usage)?;
    let selection = args.selector.select(tool)?;
    let defs = selection.defs();
    let def = match defs.as_slice() {
        [def] => *def,
        [] => {
            let message = format!("no scene is selected; `{} corpus list --scenes` names them", program());
            return Err(Failure::nothing(message));
        }
        [first, second, ..] => {
            let message = format!("{}/{} and {}/{} are selected", first.suite, first.name, second.suite, second.name);
            return Err(Failure::usage(format!("{message}; choose one scene with -f")));
        }
    };
    let loaded = selection.load(def)?;
    let task = tool.task(loaded.task);
    std::fs::create_dir_all(&args.out).map_err(|error| Failure::usage(format!("{}: {error}", args.out.display())))?;
    let mut written = Ok(Vec::new());
    backend
        .answer_any(task.name(), &loaded.scene, loaded.content.as_ref(), &mut |answer| {
            written = task.write_answer(&loaded, answer, &args.out);
        })
        .map_err(|why| Failure::usage(format!("{}: {why}", backend.name())))?;
    for path in written.map_err(|error| Failure::usage(format!("{}: {error}", args.out.display())))? {
        say!("{}", path.display());
    }
    Ok(exit::OK)
}
