//! `data`: compares two runs, exports run folders as tables, and prints the schema.

mod diff;
mod export;
mod schema;

use crate::exit;
use crate::tool::Tool;

/// Runs as data: compare two, export tables, print the schema
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    Diff(diff::Args),
    Export(export::Args),
    Schema(schema::Args),
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    match &args.command {
        Command::Diff(args) => diff::run(args),
        Command::Export(args) => export::run(args, tool),
        Command::Schema(args) => schema::run(args, tool),
    }
}
