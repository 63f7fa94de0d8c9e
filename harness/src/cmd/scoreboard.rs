//! `scoreboard`: libraries side by side on whole tasks.

use std::path::PathBuf;

use predicament_records::{RunDir, make_folder, replace};

use crate::exit::{self, Failure};
use crate::places::apart;
use crate::progress;
use crate::scoreboard::{Board, csv, html, index, page, shown};
use crate::tool::Tool;

const EXAMPLES: &str = "\
The rows are the backends of the runs: engines that answer whole tasks, and this project's own. docs/ENGINES.md lists the \
tasks that are open to other programs.

Examples:
  predicament run delaunay hulls -b engine:scipy-qhull,engine:spade,exact --out run
  predicament bench --judged run --out bench -b engine:scipy-qhull,engine:spade,exact
  predicament scoreboard run bench --out scoreboard          with times and memory
  predicament scoreboard run-1 run-2 --out scoreboard      engines that were run apart";

/// Compare libraries on whole tasks: scenes right, rounded, broken, times, memory
///
/// Writes index.html and README.md, a page for each task in HTML and Markdown, scoreboard.csv, and the smallest scene
/// behind each kind of finding as a suite and a picture.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Folders written by `run` and `bench`; if several have the same pair of scene and backend, the first counts
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,

    /// The folder for the pages; files of an earlier scoreboard are replaced
    #[arg(long, value_name = "DIR", default_value = "predicament-scoreboard")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let _working = progress::working("making the scoreboard");
    apart(&[("--out", &args.out)], &[], &args.runs.iter().map(|run| &**run).collect::<Vec<_>>())?;
    let runs = RunDir::open_all(&args.runs).map_err(Failure::usage)?;
    for warning in runs.iter().flat_map(|run| &run.warnings) {
        note!("{warning}");
    }
    let board = Board::of(&runs, tool.tasks()).map_err(Failure::usage)?;
    if board.tasks.is_empty() {
        return Err(Failure::nothing("the runs have no scene of a task that is open to other programs"));
    }
    make_folder(&args.out.join("scenes")).map_err(Failure::usage)?;
    let write = |name: &str, text: &str| replace(&args.out.join(name), text.as_bytes()).map_err(Failure::usage);
    for task in board.tasks.keys() {
        let shown = shown(&board, task, &runs, tool, &args.out)?;
        write(&format!("{task}.md"), &page(&board, task, &shown))?;
        write(&format!("{task}.html"), &html::page(&board, task, &shown)?)?;
    }
    write("scoreboard.csv", &csv(&board))?;
    write("README.md", &index(&board))?;
    write("index.html", &html::index(&board)?)?;
    say!("{}", args.out.join("README.md").display());
    Ok(exit::OK)
}
