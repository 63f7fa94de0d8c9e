//! `predicament`: is my predicate right, when does it break, and what does
//! being right cost?
//!
//! The binary knows every crate and does little itself: one file per command
//! under `cmd/`, and the pieces that commands share beside them.

mod bounds;
mod cmd;
mod contact_tables;
mod exit;
mod expectations;
mod interrupt;
mod peers;
mod precision;
mod progress;
mod roster;
mod rows;
mod select;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use predicament_studies::markdown;

/// A differential test harness for geometric predicates.
///
/// Runs degenerate scenes through backends of three philosophies (exact
/// arithmetic, Simulation of Simplicity, tolerances) and several controls,
/// and reports disagreements, topology errors and throughput.
#[derive(Parser)]
#[command(name = "predicament", version, after_help = exit::HELP, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Run(cmd::run::Args),
    Bench(cmd::bench::Args),
    Report(cmd::report::Args),
    Gate(cmd::gate::Args),
    Replay(cmd::replay::Args),
    Map(cmd::map::Args),
    Selftest(cmd::selftest::Args),
    Bounds(cmd::bounds::Args),
    Corpus(cmd::corpus::Args),
    #[command(flatten)]
    Study(cmd::study::Args),
    Doctor(cmd::doctor::Args),
}

fn main() -> ExitCode {
    // A reader that goes away (`predicament … | head`) is no reason for a backtrace.
    let hook = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        let text = info.to_string();
        if text.contains("failed printing to stdout") {
            std::process::exit(0);
        }
        hook(info);
    }));
    exit::code(match Cli::parse().command {
        Command::Run(args) => cmd::run::run(args),
        Command::Bench(args) => cmd::bench::run(args),
        Command::Report(args) => cmd::report::run(&args),
        Command::Gate(args) => cmd::gate::run(&args),
        Command::Replay(args) => cmd::replay::run(&args),
        Command::Map(args) => cmd::map::run(args),
        Command::Selftest(args) => cmd::selftest::run(args),
        Command::Bounds(args) => cmd::bounds::run(&args),
        Command::Corpus(args) => cmd::corpus::run(args),
        Command::Study(args) => cmd::study::run(&args),
        Command::Doctor(args) => cmd::doctor::run(&args),
    })
}
