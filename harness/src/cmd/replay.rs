//! `replay`: asks the query of one finding again, alone, and explains the answers.

use std::path::{Path, PathBuf};
use std::time::Duration;

use predicament_corpus::{Level, LoadedScene};
use predicament_formats::{hex, hexfloat};
use predicament_predicates::{Class, Query, Sign, Vertex};
use predicament_records::{FindingRow, Plan, RunDir};
use predicament_tasks::{Contestant, Explanation};
use sha2::{Digest, Sha256};

use crate::exit::{self, Failure};
use crate::interrupt;
use crate::out::one_line;
use crate::programs::{Picked, Programs, Recorded};
use crate::select::{Selector, suite_of};
use crate::tool::Tool;
use crate::worker::Worker;

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

    #[command(flatten)]
    pub programs: Programs,

    /// Where fetched data lie; $PREDICAMENT_CACHE or the user's cache if left out
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,

    /// Seconds after which a scene that is run again as a whole is ended
    #[arg(long, value_name = "SECONDS", value_parser = super::run::seconds, default_value = "600")]
    pub timeout: Duration,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let run = RunDir::open(&args.run).map_err(Failure::usage)?;
    let finding = find(&run, &args.id, &args.run)?;
    let loaded = load(&run, finding, args.cache.as_deref(), tool)?;
    say!("finding   {} ({})", finding.finding_id, finding.class.name());
    say!("scene     {}/{} ({})", finding.suite, finding.scene, finding.scene_id);
    for (key, text) in [("source", &loaded.source), ("analysis", &loaded.analysis)] {
        if !text.is_empty() {
            say!("{key:<9} {text}");
        }
    }
    say!("backend   {}", finding.backend);
    say!("check     {}", one_line(&finding.check));
    say!("got       {}", one_line(&finding.got));
    if !finding.truth.is_empty() {
        say!("truth     {}", one_line(&finding.truth));
    }
    if finding.query.is_empty() {
        return whole(&run, finding, args, tool);
    }
    let Picked { mut backends, .. } = of_finding(args, tool, &run, finding)?;
    if args.backends.is_empty() {
        backends.extend(tool.pick(&[])?.into_iter().filter(|backend| backend.name() != finding.backend));
    }
    let backends: Vec<&dyn Contestant> = backends.iter().map(AsRef::as_ref).collect();
    for query in finding.query.split(" | ") {
        say!("\n{query}");
        let query: Query =
            query.parse().map_err(|error| Failure::usage(format!("findings.csv was changed: {error}")))?;
        explain(tool, &loaded, &query, &backends)?;
    }
    Ok(exit::OK)
}

/// The backend that a finding is about, and those that the command line names.
fn of_finding(args: &Args, tool: &Tool, run: &RunDir, finding: &FindingRow) -> Result<Picked, Failure> {
    let file = args.run.join("plan.json");
    let recorded = Recorded { file: &file, folder: Some(&args.run), engines: &run.plan.engines };
    let (programs, named) = args.programs.clone().and_named(&args.backends)?;
    let names: Vec<String> = std::iter::once(finding.backend.clone()).chain(named).collect();
    programs.pick(tool, &names, recorded)
}

/// A finding about a whole scene: the scene is run again, in a process of its own, as it may loop or crash.
fn whole(run: &RunDir, finding: &FindingRow, args: &Args, tool: &Tool) -> exit::Outcome {
    let scene = run.plan.scenes.iter().find(|scene| scene.scene_id == finding.scene_id && scene.suite == finding.suite);
    let scene = scene.ok_or_else(|| Failure::usage(format!("{}: its plan has no such scene", args.run.display())))?;
    let level: Level = run.plan.level.to_string().parse().map_err(Failure::usage)?;
    let picked = of_finding(args, tool, run, finding)?;
    interrupt::listen_for_all();
    let worker = Worker {
        permutations: None,
        threads: None,
        cache: args.cache.as_deref(),
        folder: std::env::temp_dir().join(format!("predicament-replay-{}", std::process::id())),
        engines: &picked.files,
        suite: suite_of(&args.run, &run.plan, &finding.suite),
        scene,
        limit: Some(args.timeout),
        level,
        answers: false,
    };
    say!("\nThe whole scene again:");
    let mut seen = false;
    for backend in &picked.backends {
        let Some(found) = worker.run(tool, &backend.name())? else {
            return Err(Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE });
        };
        for row in &found.summary {
            let classes: Vec<String> = Class::ALL
                .into_iter()
                .filter(|&class| row.count(class) > 0)
                .map(|class| format!("{} {class}", row.count(class)))
                .collect();
            say!("  {:<24} {}", row.backend, classes.join(", "));
        }
        for row in &found.findings {
            seen |= row.finding_id == finding.finding_id;
            say!("  {:<24} {}: {}", "", row.check, row.got);
        }
    }
    say!("{}", if seen { "The finding is there again." } else { "The finding is not there any more." });
    Ok(exit::OK)
}

/// The finding with this id, or the only one that it begins.
pub fn find<'a>(run: &'a RunDir, id: &str, folder: &Path) -> Result<&'a FindingRow, Failure> {
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

/// The scene of a finding, as it was in its run.
pub fn load(run: &RunDir, finding: &FindingRow, cache: Option<&Path>, tool: &Tool) -> Result<LoadedScene, Failure> {
    let level: Level = run.plan.level.to_string().parse().map_err(Failure::usage)?;
    let suite = suite_of(&run.path, &run.plan, &finding.suite);
    let selection =
        Selector { suites: vec![suite], filter: None, level, cache: cache.map(Path::to_path_buf) }.select(tool)?;
    let Some(def) = selection.defs().into_iter().find(|def| def.name == finding.scene) else {
        let (suite, of) = (&finding.suite, selection.of_file(&finding.suite));
        return Err(Failure::nothing(format!(
            "{}: the suite `{suite}`{of} has no scene `{}` any more; run it again",
            run.path.display(),
            finding.scene
        )));
    };
    let loaded = selection.load(def)?;
    if loaded.id != finding.scene_id {
        let file = run.plan.paths.get(&finding.suite).filter(|_| changed(&run.plan, &finding.suite));
        let file = file.map_or_else(String::new, |file| format!(", as has {file}"));
        return Err(Failure::usage(format!(
            "scene {}/{} has changed since the run ({} then, {} now){file}; run it again",
            finding.suite, finding.scene, finding.scene_id, loaded.id
        )));
    }
    Ok(loaded)
}

/// Whether the file of a suite that was named by path is another one than it was.
fn changed(plan: &Plan, suite: &str) -> bool {
    let now = plan.paths.get(suite).and_then(|file| std::fs::read(file).ok());
    now.is_none_or(|bytes| plan.hashes.get(suite).is_some_and(|then| *then != hex(&Sha256::digest(bytes))))
}

/// Asks one query of all backends.
fn explain(tool: &Tool, loaded: &LoadedScene, query: &Query, backends: &[&dyn Contestant]) -> Result<(), Failure> {
    let told = tool.task(loaded.task).explain_query(loaded, query, backends).map_err(Failure::usage)?;
    for line in point_lines(loaded, &told.vertices).into_iter().chain(lines(&told)) {
        say!("  {line}");
    }
    Ok(())
}

/// The truth and the answers, in columns.
pub fn lines(told: &Explanation) -> Vec<String> {
    let mut lines: Vec<String> = told.truth.iter().map(|line| format!("{:<24} {line}", "truth")).collect();
    let heads = (!told.heads.is_empty()).then(|| ("backend".to_owned(), told.heads.clone()));
    let rows: Vec<(String, Vec<String>)> = heads.into_iter().chain(told.rows.iter().cloned()).collect();
    let width = |column: usize| {
        let cells = rows.iter().filter(|(_, cells)| cells.len() > 1).filter_map(|(_, cells)| cells.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    for (name, cells) in &rows {
        let cells: Vec<String> = cells.iter().enumerate().map(|(at, cell)| format!("{cell:<0$}", width(at))).collect();
        lines.push(format!("{name:<24} {}", cells.join("  ")).trim_end().to_owned());
    }
    if told.permutations.iter().any(|(_, of)| of.iter().any(|sign| *sign != of[0])) {
        lines.push("of all orders of the vertices, turned back where they are odd:".to_owned());
        // Those that begin with one vertex stand together.
        let grouped = |of: &[Sign]| of.chunks(group(of.len())).map(signs).collect::<Vec<_>>().join(" ");
        lines.extend(told.permutations.iter().map(|(name, of)| format!("{name:<24} {}", grouped(of))));
    }
    lines
}

/// Signs as a word.
pub fn signs(of: &[Sign]) -> String {
    of.iter().map(|sign| ["-", "0", "+"][usize::from(sign.as_i8() >= 0) + usize::from(sign.as_i8() > 0)]).collect()
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

/// How many of all orders begin with one vertex: n! orders are of n vertices.
fn group(orders: usize) -> usize {
    (1..=5)
        .map(|n| (n, (1..=n).product::<usize>()))
        .find(|(_, all)| *all == orders)
        .map_or(orders.max(1), |(n, all)| all / n)
}
