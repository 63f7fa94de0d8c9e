//! `merge`: combines the parts of a run into the run that one machine would have made.

use std::path::PathBuf;

use predicament_records::{Env, Outcome, RunDir, Status, merge};

use crate::exit::{self, Failure};
use crate::planning::tables_with;
use crate::progress;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Every part must be present once and complete, and all must come from the same selection and the same build of the \
tool. If a part is missing or does not fit, merge names it and writes nothing. The tables are byte-identical to those \
of the whole run. The exit code is 100 or 101 if something is not as expected, as for `run`.

Examples:
  predicament run --shard 1/2 --out out/1
  predicament run --shard 2/2 --out out/2            on another machine
  predicament shard merge out/1 out/2 --out out/whole
  predicament gate out/whole";

/// Merge the parts of a run
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The folders of all parts, in any order
    #[arg(required = true, value_name = "DIR")]
    pub parts: Vec<PathBuf>,

    /// A new folder for the merged run
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let _working = progress::working("merging");
    let first = args.parts.first().map(exit::open).transpose()?;
    let tables = first.map_or_else(Vec::new, |run| tables_with(tool, run.plan.answers));
    let run = merge(&args.parts, &args.out, &tables, env).map_err(|why| Failure {
        message: why.error.to_string(),
        code: if why.is_incomplete { exit::INCOMPLETE } else { exit::USAGE },
    })?;
    let count = |status: Status| run.summary.iter().filter(|row| row.status == status).count();
    let (unexpected, passes) = (count(Status::Unexpected), count(Status::UnexpectedPass));
    say!(
        "{}: {} part{}, {} scenes, {} rows, {unexpected} unexpected, {passes} unexpected pass; {}",
        args.out.display(),
        args.parts.len(),
        if args.parts.len() == 1 { "" } else { "s" },
        run.plan.scenes.len(),
        run.summary.len(),
        Outcome::Complete.describe()
    );
    Ok(if unexpected > 0 {
        exit::UNEXPECTED
    } else if passes > 0 {
        exit::UNEXPECTED_PASS
    } else {
        exit::OK
    })
}

/// The environment of the first part, with the machines of all parts.
fn env(runs: &[RunDir]) -> Env {
    let part = |run: &RunDir| {
        let node = run.env.node.as_deref().unwrap_or("a machine without a name");
        format!("{} on {node}", run.plan.shard)
    };
    let mut sorted: Vec<&RunDir> = runs.iter().collect();
    sorted.sort_by_key(|run| run.plan.shard);
    let mut env = sorted.first().map_or_else(Env::default, |run| run.env.clone());
    env.parts = sorted.into_iter().map(part).collect();
    env.command_line = crate::host::words().iter().map(|word| word.to_string_lossy().into_owned()).collect();
    env
}
