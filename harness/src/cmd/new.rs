//! `new`: a commented suite to start from.

use std::path::PathBuf;

use predicament_predicates::PredicateKind;
use predicament_records::replace;

use crate::exit::{self, Failure};
use crate::out::program;

const EXAMPLES: &str = "\
Examples:
  predicament new mine.toml                                 three points and an orient2d, with all that can be changed
  predicament new mine.toml --points survey.csv             points of a file beside it
  predicament new mine.toml --task insphere --points cloud.ply";

/// The suite that is written.
const TEMPLATE: &str = include_str!("../../templates/suite.toml");

/// Write a commented suite to start from
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The TOML file to write; an existing one is not touched
    pub file: PathBuf,

    /// The predicate that is asked
    #[arg(long, default_value = "orient2d", value_name = "TASK")]
    pub task: PredicateKind,

    /// A file of points, as seen from the suite
    #[arg(long, value_name = "FILE")]
    pub points: Option<String>,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    let file = &args.file;
    let shown = file.display().to_string();
    if file.extension().is_none_or(|extension| extension != "toml") {
        return Err(Failure::usage(format!("{shown}: a suite's name ends with .toml")));
    }
    if file.exists() {
        return Err(Failure::usage(format!("{shown}: the file is there; name another")));
    }
    let kind = args.task;
    let points = match &args.points {
        Some(points) => format!("{{ path = {} }}", toml::Value::String(points.clone())),
        None => written(kind),
    };
    let indices: Vec<String> = (0..kind.arity()).map(|index| index.to_string()).collect();
    let title = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let text = TEMPLATE
        .replace("{program}", &program())
        .replace("{file}", &shown)
        .replace("\"{title}\"", &toml::Value::String(title).to_string())
        .replace("{tasks}", &PredicateKind::ALL.map(PredicateKind::name).join(", "))
        .replace("{task}", kind.name())
        .replace("{points}", &points)
        .replace("{arity}", &kind.arity().to_string())
        .replace("{indices}", &format!("[[{}]]", indices.join(", ")));
    replace(file, text.as_bytes()).map_err(Failure::usage)?;
    say!("{shown}: written; next: {} run {shown} -b exact,sos,naive --answers", program());
    Ok(exit::OK)
}

/// Points that plain doubles get wrong, or nearly.
fn written(kind: PredicateKind) -> String {
    let points: &[&str] = match kind {
        PredicateKind::Compare => &["[0, 0]", "[\"0x1p-1074\", 0]"],
        PredicateKind::Orient2d => &["[0.5, \"0x1.0000000000001p-1\"]", "[12, 12]", "[24, 24]"],
        PredicateKind::Orient3d => &["[0, 0, 0]", "[1, 0, 0]", "[0, 1, 0]", "[0.25, 0.25, \"0x1p-60\"]"],
        PredicateKind::Incircle => &["[1, 0]", "[0, 1]", "[-1, 0]", "[0, \"-0x1.0000000000001p+0\"]"],
        PredicateKind::Insphere => {
            &["[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]", "[-1, 0, 0]", "[0, 0, \"-0x1.0000000000001p+0\"]"]
        }
    };
    format!("[\n    {},\n]", points.join(",\n    "))
}
