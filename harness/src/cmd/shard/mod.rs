//! `shard`: one run on several machines: plans the parts and merges their folders.

mod merge;
mod plan;

use crate::exit;
use crate::tool::Tool;

/// Split a run over several machines: plan its parts, merge them
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    Plan(plan::Args),
    Merge(merge::Args),
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    match &args.command {
        Command::Plan(args) => plan::run(args, tool),
        Command::Merge(args) => merge::run(args, tool),
    }
}
