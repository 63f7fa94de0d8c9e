//! `bounds`: error bounds and constraints of the tolerance scheme, derived and beside the
//! published ones.

use clap::ValueEnum;

use crate::bounds;
use crate::exit::{self, Failure};

const EXAMPLES: &str = "\
Examples:
  predicament bounds                                the page docs/BOUNDS.md
  predicament bounds --format csv > bounds.csv      one row per bound, and per constraint and epsilon";

/// Derive every error bound and decide every tolerance constraint of the tolerance scheme
///
/// The quantities of sections 4 and 5 of "Robust Intersections under Floating
/// Point" run on numbers that carry their error bound; the results stand beside
/// the published figures. Constraints are decided in rational arithmetic.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Markdown, or one CSV table
    #[arg(long, value_enum, default_value_t = Format::Md)]
    pub format: Format,
}

/// What to print.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum Format {
    /// One table.
    Csv,
    /// A page.
    Md,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    match args.format {
        Format::Csv => say_text!("{}", bounds::csv().map_err(Failure::usage)?),
        Format::Md => say_text!("{}", bounds::page()),
    }
    Ok(exit::OK)
}
