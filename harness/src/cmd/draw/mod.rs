//! `draw`: draws scenes, answers and findings, and pixel maps of predicates.

mod map;
mod scene;

use crate::exit;
use crate::tool::Tool;

/// Draw a scene, an answer or a finding; map where a predicate is wrong
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    Scene(scene::Args),
    Map(map::Args),
}

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    match args.command {
        Command::Scene(args) => scene::run(&args, tool),
        Command::Map(args) => map::run(args, tool),
    }
}
