//! `cite`: BibTeX for the tool and for the sources of a run's scenes.

use std::path::PathBuf;

use predicament_records::RunDir;

use crate::citing::{bibtex, sources};
use crate::exit::{self, Failure};
use crate::planning::env;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Without --run, the entries below that of the tool are the papers that the project stands on. With --run, they are the \
sources that the run's suites name, each with its suites; scenes without a publication are listed in comments.

Examples:
  predicament setup cite > predicament.bib
  predicament setup cite --run out/run > sources.bib
  predicament cite                                  the same command by a shorter name";

/// Print BibTeX: the tool, and the papers that it stands on or the sources of a run's scenes
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Cite the sources of this run's scenes; repeat for several runs
    #[arg(long, value_name = "DIR")]
    pub run: Vec<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    say!("{}", bibtex::tool(env().commit.as_deref()));
    if args.run.is_empty() {
        say_text!("{}", bibtex::papers());
        return Ok(exit::OK);
    }
    let runs = RunDir::open_all(&args.run).map_err(Failure::usage)?;
    say_text!("{}", bibtex::of(&sources(&runs, tool)));
    Ok(exit::OK)
}
