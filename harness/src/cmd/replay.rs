//! `replay`: asks the query of one finding again and explains the answers.

use std::path::PathBuf;
use std::time::Duration;

use predicament_corpus::{Level, LoadedScene};
use predicament_predicates::{Class, Query};
use predicament_records::{FindingRow, RunDir};
use predicament_tasks::Contestant;

use crate::exit::{self, Failure};
use crate::found::{find, load};
use crate::interrupt;
use crate::out::one_line;
use crate::programs::{Picked, Programs, Recorded};
use crate::select::suite_of;
use crate::shared::seconds;
use crate::told::{lines, point_lines};
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
    /// The id of the finding, or a prefix of it, from findings.csv or the report
    pub id: String,

    /// The run that found it
    #[arg(long, value_name = "DIR")]
    pub run: PathBuf,

    /// Backends to ask in addition to the finding's backend; default: all
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    #[command(flatten)]
    pub programs: Programs,

    /// The folder of fetched data; default: $PREDICAMENT_CACHE or the user's cache
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,

    /// The time limit in seconds for a whole scene that is run again
    #[arg(long, value_name = "SECONDS", value_parser = seconds, default_value = "600")]
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

/// The backend of a finding, and the backends that the command line names.
fn of_finding(args: &Args, tool: &Tool, run: &RunDir, finding: &FindingRow) -> Result<Picked, Failure> {
    let file = args.run.join("plan.json");
    let recorded = Recorded { file: &file, folder: Some(&args.run), engines: &run.plan.engines };
    let (programs, named) = args.programs.clone().and_named(&args.backends)?;
    let names: Vec<String> = std::iter::once(finding.backend.clone()).chain(named).collect();
    programs.pick(tool, &names, recorded)
}

/// Runs the scene of a whole-scene finding again, in a separate process, because it may loop or crash.
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

/// Asks one query of all backends.
fn explain(tool: &Tool, loaded: &LoadedScene, query: &Query, backends: &[&dyn Contestant]) -> Result<(), Failure> {
    let told = tool.task(loaded.task).explain_query(loaded, query, backends).map_err(Failure::usage)?;
    for line in point_lines(loaded, &told.vertices).into_iter().chain(lines(&told)) {
        say!("  {line}");
    }
    Ok(())
}
