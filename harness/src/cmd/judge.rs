//! `judge`: judges the answer to a scene that another program has left in files.

use std::sync::atomic::AtomicBool;

use predicament_tasks::replies::Reply;
use predicament_tasks::{Asked, Budget, Class, Outcome, Watch};
use serde_json::json;

use crate::answer_files;
use crate::exit::{self, Failure};
use crate::one_scene::OneScene;
use crate::tool::Tool;
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
The input is that of `solve`: a task on your own files, or one scene of a suite. The answer is in files: meshes as \
OFF, OBJ, PLY or STL, polygons as GeoJSON or WKT, triangles in one of these or as indices in JSON or CSV, labels of \
probes in JSON or CSV, or as points of GeoJSON with a property `label`, pairs and other lists in JSON or CSV (a list \
a line), polylines as GeoJSON or WKT, numbers in JSON. An answer of several parts is written PART=FILE, or in files \
with the names of the parts. docs/ENGINES.md lists the parts of each task.

The judge decides in rationals. Answers of indices and labels are right or wrong. Constructed coordinates and measures are \
right, rounded by a distance that is printed, or wrong. The exit code is 0 if the answer is right, and 100 otherwise.

With `--set truth=decimals` the answer is also judged by the decimals in the files, of which a program gets only the \
doubles.

Examples:
  predicament judge delaunay2d survey.csv --answer triangles.json
  predicament judge delaunay2d survey.csv --answer triangles.json --format json
  predicament judge overlays -f stars --answer union=out/union.geojson";

/// Judge the answer of another program to one scene, exactly
#[derive(clap::Args)]
#[command(
    after_help = EXAMPLES,
    override_usage = "predicament judge [OPTIONS] --answer <FILE>... TASK FILE...\n       \
                      predicament judge [OPTIONS] --answer <FILE>... SUITE -f RE"
)]
pub struct Args {
    #[command(flatten)]
    pub scene: OneScene,

    /// A file of the answer, or PART=FILE; once for each file
    #[arg(long = "answer", value_name = "FILE", required = true)]
    pub answers: Vec<String>,

    /// The form of the verdict on stdout
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,
}

/// The form of the verdict.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Format {
    /// Lines for people
    Text,
    /// One JSON object
    Json,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    interrupt::leave_at_once();
    let working = progress::working("reading the scene");
    let loaded = args.scene.load(tool)?;
    let task = tool.task(loaded.task);
    let name = args.scene.named(&loaded);
    let question = task
        .question(&loaded.scene, loaded.content.as_ref())
        .map_err(|declined| Failure::usage(format!("{name}: not judged: {declined}")))?;
    let (arrays, rounded) = answer_files::read(task, &loaded.scene, &question, &args.answers)?;
    working.now(format!("judging {name}"));
    let (never, quiet) = (AtomicBool::new(false), |_: u64| {});
    let watch = Watch::new(&never, None, &quiet);
    let stopped = |_| Failure::usage("the judge was stopped");
    let case = task.case(&loaded, &watch).map_err(stopped)?;
    if let Some(dispute) = case.dispute() {
        return Err(Failure { message: format!("{name}: {dispute}"), code: exit::CORPUS });
    }
    let exact = tool.backend("exact").map_err(Failure::usage)?;
    let mut outcome = Outcome { queries: loaded.count() as u64, ..Outcome::default() };
    let reply = Reply { arrays, ..Reply::default() };
    let mut judged = Ok(());
    exact
        .with_session(&loaded.scene, &mut |session| {
            let asked = Asked { backend: exact.as_ref(), session, budget: Budget::FULL, watch: &watch };
            judged = case.judge(&asked, &reply, &mut outcome);
        })
        .map_err(Failure::usage)?;
    judged.map_err(stopped)?;
    drop(working);
    if rounded > 0 {
        note!("{rounded} decimals of the answer are not doubles: their nearest doubles were judged");
    }
    tell(args.format, &name, &outcome);
    Ok(if outcome.findings.is_empty() { exit::OK } else { exit::UNEXPECTED })
}

/// The verdict in one word.
fn verdict(outcome: &Outcome) -> &'static str {
    let classes = || outcome.findings.iter().map(|finding| finding.class);
    match classes().any(|class| class != Class::Rounded) {
        true => "wrong",
        false if outcome.findings.is_empty() => "right",
        false => "rounded",
    }
}

fn tell(format: Format, name: &str, outcome: &Outcome) {
    match format {
        Format::Text => {
            say!("{name}: {}", verdict(outcome));
            for finding in &outcome.findings {
                let query =
                    if finding.queries.is_empty() { String::new() } else { format!("{}: ", finding.query_text()) };
                say!("  {} ({}): {query}{}", finding.check, finding.class, finding.got);
            }
            let kept = outcome.findings.len() as u64;
            let all: u64 =
                Class::ALL.into_iter().filter(|class| !class.is_legal()).map(|c| outcome.counts.get(c)).sum();
            if all > kept {
                say!("  and {} more", all - kept);
            }
            if let Some(agreement) = &outcome.agreement {
                say!("  {agreement}");
            }
            if let Some(sampled) = &outcome.sampled {
                say!("  judged: {sampled}");
            }
        }
        Format::Json => {
            let findings: Vec<_> = outcome
                .findings
                .iter()
                .map(|finding| {
                    json!({
                        "class": finding.class.name(),
                        "check": finding.check,
                        "query": finding.query_text(),
                        "got": finding.got,
                        "truth": finding.truth,
                    })
                })
                .collect();
            let mut said = json!({ "input": name, "verdict": verdict(outcome), "findings": findings });
            if let Some(agreement) = &outcome.agreement {
                said["right_as_written"] = (agreement.written == agreement.answers).into();
            }
            say!("{said}");
        }
    }
}
