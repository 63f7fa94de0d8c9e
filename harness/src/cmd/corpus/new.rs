//! `new`: a commented suite to start from.

use std::path::PathBuf;

use predicament_formats::use_one_of;
use predicament_records::replace;

use crate::exit::{self, Failure};
use crate::out::program;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament corpus new mine.toml                                 three points and an orient2d, with all that can be changed
  predicament corpus new mine.toml --points survey.csv             points of a file beside it
  predicament corpus new mine.toml --task insphere --points cloud.ply
  predicament corpus new land.toml --task polygon-locate --points land.geojson";

/// The suite that is written.
const TEMPLATE: &str = include_str!("../../../templates/suite.toml");

/// Write a commented suite to start from
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The TOML file to write; an existing one is not touched
    pub file: PathBuf,

    /// The task: a predicate, or another one of those that suites can name
    #[arg(long, default_value = "orient2d", value_name = "TASK")]
    pub task: String,

    /// A file of points, or of whatever the task is about, as seen from the suite
    #[arg(long, value_name = "FILE")]
    pub points: Option<String>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let file = &args.file;
    let shown = file.display().to_string();
    if file.extension().is_none_or(|extension| extension != "toml") {
        return Err(Failure::usage(format!("{shown}: a suite's name ends with .toml")));
    }
    if file.exists() {
        return Err(Failure::usage(format!("{shown}: the file is there; name another")));
    }
    let tasks = tool.tasks();
    let task = tasks.iter().find(|task| task.name() == args.task).map(|task| task.template());
    let Some(template) = task.filter(|template| !template.is_empty()) else {
        let known = tasks.iter().filter(|task| !task.template().is_empty()).map(|task| task.name());
        let known: Vec<&str> = known.collect();
        let message = format!(
            "no task that a suite can start from is called `{}`; {}",
            args.task,
            use_one_of(&args.task, &known)
        );
        return Err(Failure::usage(message));
    };
    let title = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let names: Vec<&str> = tasks.iter().map(|task| task.name()).collect();
    let text = TEMPLATE
        .replace("{scene}", &scene(&template, args.points.as_deref()))
        .replace("{program}", &program())
        .replace("{file}", &shown)
        .replace("{tasks}", &names.join(", "))
        .replace("{task}", &args.task)
        .replace("\"{title}\"", &toml::Value::String(title).to_string());
    replace(file, text.as_bytes()).map_err(Failure::usage)?;
    say!("{shown}: written; next: {} run {shown} -b exact,sos,naive --answers", program());
    Ok(exit::OK)
}

/// The scene of a template, with data that are written out or in a file.
fn scene(template: &str, file: Option<&str>) -> String {
    let (kept, dropped) = if file.is_some() { ("@file ", "@written ") } else { ("@written ", "@file ") };
    let data = file.map_or_else(String::new, |file| toml::Value::String(file.to_owned()).to_string());
    let lines = template.lines().filter(|line| !line.starts_with(dropped));
    lines.map(|line| line.strip_prefix(kept).unwrap_or(line).replace("{data}", &data) + "\n").collect()
}
