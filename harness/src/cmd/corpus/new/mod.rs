//! `corpus new`: a commented suite to start from, made for the data that it names.

mod data;
mod draft;
mod overwrite;

use std::path::PathBuf;

use predicament_formats::{Columns, CorpusError, use_one_of};
use predicament_records::replace;
use predicament_tasks::AnyTask;

use crate::columns;
use crate::exit::{self, Failure};
use crate::out::program;
use crate::tool::Tool;
use data::Data;
use draft::{Draft, Draw};

const EXAMPLES: &str = "\
With --points the command reads the data, if the file is there. It writes what they need: the columns of the coordinates, \
`round = true` where decimals have digits that no double holds, and random queries about more than 1000 points. Without --task \
it chooses one: orient2d or orient3d for points, polygon-locate for polygons, crossings for lines, mesh-locate for closed \
meshes. The suite runs as it is.

Examples:
  predicament corpus new mine.toml                                 three points and an orient2d, with all that can be changed
  predicament corpus new mine.toml --points survey.csv             points of a file beside it
  predicament corpus new mine.toml --points towns.csv --columns lon,lat
  predicament corpus new mine.toml --task orient3d --points cloud.ply
  predicament corpus new land.toml --points land.geojson";

/// Write a commented suite to start from
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The TOML file to write
    pub file: PathBuf,

    /// The task: a predicate, or another task that suites can name; one that fits the data if left out, else orient2d
    #[arg(long, value_name = "TASK")]
    pub task: Option<String>,

    /// A file of points, or of whatever the task is about, as seen from the suite
    #[arg(long, value_name = "FILE")]
    pub points: Option<String>,

    /// The columns of x and y (and z) in a CSV file, by names in the header or numbers from 1
    #[arg(long, value_name = "COLUMNS", value_parser = columns::parse, requires = "points")]
    pub columns: Option<Columns>,

    /// Overwrite the file without a question
    #[arg(long)]
    pub force: bool,
}

/// The task where none is named and no data choose one.
const FIRST: &str = "orient2d";

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let file = &args.file;
    let shown = file.display().to_string();
    if file.extension().is_none_or(|extension| extension != "toml") {
        return Err(Failure::usage(format!("{shown}: a suite's name ends with .toml")));
    }
    let named = args.task.as_deref().map(|name| startable(tool, name)).transpose()?;
    overwrite::allowed(file, args.force)?;
    let data = args.points.as_ref().map(|points| Data::find(file, points, args.columns.clone())).transpose()?;
    let (text, told) = match &data {
        Some(data) if data.is_there() => fitting(args, tool, named, data)?,
        _ => {
            let task = named.map_or_else(|| startable(tool, FIRST), Ok)?;
            (Draft { tool, file, task, data: data.as_ref(), rounded: None, draw: Draw::Tuples }.text(), None)
        }
    };
    replace(file, text.as_bytes()).map_err(Failure::usage)?;
    if let Some(data) = data.iter().find(|data| !data.is_there()) {
        note!("{} is not there; the suite needs it to run", data.path);
    }
    if let Some(told) = told {
        say!("{told}");
    }
    say!("{shown}: written; next: {} run {shown} -b exact,sos,naive --answers", program());
    Ok(exit::OK)
}

/// The task with this name, if it has a suite to start from.
fn startable(tool: &Tool, name: &str) -> Result<&'static dyn AnyTask, Failure> {
    let can_start = |task: &&&'static dyn AnyTask| !task.template().is_empty();
    if let Some(task) = tool.tasks().iter().filter(can_start).find(|task| task.name() == name) {
        return Ok(*task);
    }
    let known: Vec<&str> = tool.tasks().iter().filter(can_start).map(|task| task.name()).collect();
    let message = format!("a suite cannot start from the task `{name}`; {}", use_one_of(name, &known));
    Err(Failure::usage(message))
}

/// The suite of the first fitting task that can read the data, and a line about the data. The suite was read once, with
/// its data.
fn fitting(
    args: &Args,
    tool: &Tool,
    named: Option<&'static dyn AnyTask>,
    data: &Data,
) -> Result<(String, Option<String>), Failure> {
    let tasks = match named {
        Some(task) => vec![task],
        None => data.tasks()?.iter().filter_map(|name| startable(tool, name).ok()).collect(),
    };
    let mut refused: Option<CorpusError> = None;
    for task in tasks {
        let draft = Draft { tool, file: &args.file, task, data: Some(data), rounded: Some(0), draw: Draw::Tuples };
        match draft.load() {
            Ok(loaded) => {
                let rounded = Some(loaded.notes.rounded).filter(|&count| count > 0);
                let draft = Draft { rounded, draw: Draw::of(&loaded), ..draft };
                return Ok((draft.text(), Some(draft.told(&loaded))));
            }
            Err(why) => refused = Some(why),
        }
    }
    let none =
        || CorpusError::usage(&data.path, "these data do not fit any task of this tool", "choose one with --task");
    Err(refused.map_or_else(none, |why| data.own(why, &args.file)).into())
}
