//! `replay`: asks the query of one finding again, alone, and explains the answers.

use std::path::{Path, PathBuf};

use predicament_corpus::{Level, LoadedScene};
use predicament_formats::hexfloat;
use predicament_predicates::{Query, Vertex};
use predicament_records::{FindingRow, RunDir};
use predicament_tasks::Contestant;

use crate::exit::{self, Failure};
use crate::select::Selector;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament replay 3fa90c12ab77 --run out/run
  predicament replay 3fa9 --run out/run -b exact,naive,shewchuk     a prefix will do if it is unique";

/// Ask one finding's query again
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The finding's id, or a prefix of it, from findings.csv or the report
    pub id: String,

    /// The run that found it
    #[arg(long, value_name = "DIR")]
    pub run: PathBuf,

    /// Backends to ask besides the one that the finding is about; all if left out
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// Where fetched data lie; $PREDICAMENT_CACHE or the user's cache if left out
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let run = RunDir::open(&args.run).map_err(Failure::usage)?;
    let finding = find(&run, &args.id, &args.run)?;
    let loaded = load(&run, finding, args, tool)?;
    say!("finding   {} ({})", finding.finding_id, finding.class.name());
    say!("scene     {}/{} ({})", finding.suite, finding.scene, finding.scene_id);
    for (key, text) in [("source", &loaded.source), ("analysis", &loaded.analysis)] {
        if !text.is_empty() {
            say!("{key:<9} {text}");
        }
    }
    say!("backend   {}", finding.backend);
    say!("check     {}", finding.check);
    say!("got       {}", finding.got);
    if !finding.truth.is_empty() {
        say!("truth     {}", finding.truth);
    }
    if finding.query.is_empty() {
        say!("\nThis finding is about the whole scene; run it again with -f '{}'.", finding.scene);
        return Ok(exit::OK);
    }
    let mut names = vec![finding.backend.clone()];
    names.extend(tool.pick(&args.backends)?.iter().map(|backend| backend.name()));
    let backends = tool.pick(&names)?;
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    for query in finding.query.split(" | ") {
        say!("\n{query}");
        let query: Query =
            query.parse().map_err(|error| Failure::usage(format!("findings.csv was changed: {error}")))?;
        explain(tool, &loaded, &query, &backends)?;
    }
    Ok(exit::OK)
}

fn find<'a>(run: &'a RunDir, id: &str, folder: &Path) -> Result<&'a FindingRow, Failure> {
    let mut hits = run.findings.iter().filter(|row| row.finding_id.starts_with(id));
    match (hits.next(), hits.find(|row| !row.finding_id.eq(id))) {
        (None, _) => Err(Failure::nothing(format!(
            "{}: no finding is called `{id}`; the first column of findings.csv has the ids",
            folder.display()
        ))),
        (Some(hit), Some(other)) if hit.finding_id != other.finding_id => {
            Err(Failure::usage(format!("`{id}` begins {} and {}; give more digits", hit.finding_id, other.finding_id)))
        }
        (Some(hit), _) => Ok(hit),
    }
}

fn load(run: &RunDir, finding: &FindingRow, args: &Args, tool: &Tool) -> Result<LoadedScene, Failure> {
    let level: Level = run.plan.level.to_string().parse().map_err(Failure::usage)?;
    let suite = run.plan.paths.get(&finding.suite).unwrap_or(&finding.suite).clone();
    let selection = Selector { suites: vec![suite], filter: None, level, cache: args.cache.clone() }.select(tool)?;
    let Some(def) = selection.defs().into_iter().find(|def| def.name == finding.scene) else {
        return Err(Failure::nothing(format!("suite `{}` has no scene `{}` any more", finding.suite, finding.scene)));
    };
    let loaded = selection.load(def)?;
    if loaded.id != finding.scene_id {
        return Err(Failure::usage(format!(
            "scene {}/{} has changed since the run ({} then, {} now); run it again",
            finding.suite, finding.scene, finding.scene_id, loaded.id
        )));
    }
    Ok(loaded)
}

/// Asks one query of all backends.
fn explain(tool: &Tool, loaded: &LoadedScene, query: &Query, backends: &[&dyn Contestant]) -> Result<(), Failure> {
    let told = tool.task(loaded.task).explain_query(loaded, query, backends).map_err(Failure::usage)?;
    print_points(loaded, &told.vertices);
    for line in &told.truth {
        say!("  {:<24} {line}", "truth");
    }
    let heads = (!told.heads.is_empty()).then(|| ("backend".to_owned(), told.heads.clone()));
    let rows: Vec<(String, Vec<String>)> = heads.into_iter().chain(told.rows).collect();
    let width = |column: usize| {
        let cells = rows.iter().filter(|(_, cells)| cells.len() > 1).filter_map(|(_, cells)| cells.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    for (name, cells) in &rows {
        let cells: Vec<String> = cells.iter().enumerate().map(|(at, cell)| format!("{cell:<0$}", width(at))).collect();
        say!("{}", format!("  {name:<24} {}", cells.join("  ")).trim_end());
    }
    Ok(())
}

/// The coordinates of vertices, those of constructed ones by what defines them.
pub fn point_lines(loaded: &LoadedScene, ids: &[Vertex]) -> Vec<String> {
    let mut lines = Vec::new();
    for &id in ids {
        if let Some(construction) = loaded.scene.construction(id) {
            lines.push(format!("vertex {:>8}  {construction}", id.to_string()));
            let defining: Vec<Vertex> = construction.flats().flatten().copied().collect();
            lines.extend(point_lines(loaded, &defining));
            continue;
        }
        let point = loaded.scene.point(id);
        let decimal: Vec<String> = point.iter().map(|x| format!("{x:?}")).collect();
        let hex: Vec<String> = point.iter().map(|&x| hexfloat::format(x)).collect();
        lines.push(format!("vertex {:>8}  ({})  = ({})", id.to_string(), decimal.join(", "), hex.join(", ")));
    }
    lines
}

fn print_points(loaded: &LoadedScene, ids: &[Vertex]) {
    for line in point_lines(loaded, ids) {
        say!("  {line}");
    }
}
