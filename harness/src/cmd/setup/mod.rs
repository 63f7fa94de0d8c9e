//! `setup`: the tool itself: its environment, its own test, how to cite it, shell completions, manual pages.

mod cite;
mod doctor;
mod selftest;
mod shell;

use crate::exit;
use crate::tool::Tool;

/// The tool itself: check the environment, test the checks, cite, completions, man pages
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    Doctor(doctor::Args),
    Selftest(selftest::Args),
    Cite(cite::Args),
    Completions(shell::Completions),
    Man(shell::Man),
}

/// Runs the command; `whole` is the command line of the tool.
pub fn run(args: Args, tool: &Tool, whole: clap::Command) -> exit::Outcome {
    match args.command {
        Command::Doctor(args) => doctor::run(&args, tool),
        Command::Selftest(args) => selftest::run(args, tool),
        Command::Cite(args) => cite::run(&args, tool),
        Command::Completions(args) => shell::completions(&args, whole),
        Command::Man(args) => shell::man(&args, whole),
    }
}
