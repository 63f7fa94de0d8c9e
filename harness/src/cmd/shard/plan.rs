//! `plan`: writes down and seals what a run will do, and in which part, before any part begins.

use std::path::PathBuf;

use predicament_records::format::thousands;
use predicament_records::{self as records, Basis, Costs, Plan, Shard, Share, WorkPlan, balance};

use crate::exit::{self, Failure};
use crate::planning::{env, plan};
use crate::programs::recorded;
use crate::select::Selector;
use crate::shared::tell_not_selected;
use crate::tool::Tool;
use crate::{expectations, out};

const EXAMPLES: &str = "\
`run --plan FILE --shard k/N` runs a part, on any machine with the same build of the tool, and `merge` combines the \
parts. Scenes are assigned to parts by their ids. With --costs each scene, longest first, is assigned to the part \
with the least work; the cost of a scene that was not measured is estimated from its family or task. A plan that was \
changed is refused, and so is a scene that has changed since the plan was made.

Examples:
  predicament shard plan --shards 7 --out plan.json
  predicament shard plan --shards 7 --costs out/yesterday --out plan.json    balanced by what scenes took
  predicament run --plan plan.json --shard 1/7 --out out/1
  predicament shard plan families --level full --shards 64 --costs out/run   only tells what it would cost";

/// Write a plan of a run in parts
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,

    /// Backends, several with commas or by repeating; default: those that run by default
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backends: Vec<String>,

    /// The number of parts
    #[arg(long, value_name = "N", default_value = "1", value_parser = clap::value_parser!(u32).range(1..))]
    pub shards: u32,

    /// Folders of earlier runs, whose costs.csv has the time of each scene and backend
    #[arg(long, value_name = "RUN", num_args = 1..)]
    pub costs: Vec<PathBuf>,

    /// Write every answer of every backend
    #[arg(long)]
    pub answers: bool,

    /// Evaluations on other orders of the arguments, as for `run`
    #[arg(long, value_name = "N")]
    pub permutations: Option<usize>,

    /// The file of expected disagreements; default: those of the embedded corpora
    #[arg(long, value_name = "FILE")]
    pub expected: Option<PathBuf>,

    /// The file to write; default: nothing is written
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let costs = Costs::read(&args.costs).map_err(Failure::usage)?;
    let digest = expectations::held(tool, args.expected.as_ref())?.digest;
    let selection = args.selector.select(tool)?;
    let (backends, only) = tool.pick_for(&args.backends, &selection.defs())?;
    let scenes = selection.plan()?;
    tell_not_selected(&selection.not_selected, "planned");
    let plan = Plan {
        answers: args.answers,
        permutations: args.permutations.map(|most| most as u64),
        engines: recorded(&args.backends, &backends)?,
        left_out: tool.left_out(&args.backends, &only),
        only,
        ..plan(tool, &selection, &scenes, &backends, Shard::WHOLE)
    };
    let known: Vec<(Option<u64>, Basis)> = plan.scenes.iter().map(|scene| costs.of(scene, &plan.backends)).collect();
    let weighed: Vec<(&str, Option<u64>)> =
        plan.scenes.iter().zip(&known).map(|(scene, (cost, _))| (&*scene.scene_id, *cost)).collect();
    let parts = balance(&weighed, args.shards);
    let share = |(part, (cost_us, basis))| Share { part, cost_us, basis };
    let shares = parts.into_iter().zip(known).map(share).collect();
    let folders = args.costs.iter().map(|folder| folder.display().to_string()).collect();
    let work = WorkPlan::new(&env(), plan, args.shards, shares, digest, folders);
    tell(&work);
    match &args.out {
        Some(file) if file.exists() => {
            return Err(Failure::usage(format!("{}: the file is there; name another for --out", file.display())));
        }
        Some(file) => {
            records::replace(file, work.text().as_bytes()).map_err(Failure::usage)?;
            say!("{}: plan {}", file.display(), work.hash);
            let (program, parts) = (out::program(), work.parts);
            note!(
                "`{program} run --plan {} --shard k/{parts} --out FOLDER`, for each k from 1 to {parts}",
                file.display()
            );
        }
        None => say!("plan {}; --out writes it", work.hash),
    }
    Ok(exit::OK)
}

/// Prints the parts and their work.
fn tell(work: &WorkPlan) {
    let WorkPlan { plan, shares, parts, .. } = work;
    let backends = plan.backends.len() as u64;
    let has_costs = shares.iter().any(|share| share.cost_us.is_some());
    let line = |name: &str, cells: [String; 4]| {
        let [scenes, queries, answers, cost] = cells;
        say!("{name:<7} {scenes:>8} {queries:>15} {answers:>16} {cost:>14}");
    };
    line("part", ["scenes", "queries", "answers", "estimated cost"].map(str::to_owned));
    let row = |name: String, of: &dyn Fn(&Share) -> bool| {
        let (mut scenes, mut queries, mut cost) = (0_u64, 0_u64, 0_u64);
        for (scene, share) in plan.scenes.iter().zip(shares).filter(|(_, share)| of(share)) {
            (scenes, queries) = (scenes + 1, queries + scene.queries);
            cost = cost.saturating_add(share.cost_us.unwrap_or(0));
        }
        let cost = if has_costs { seconds(cost) } else { "unknown".to_owned() };
        line(&name, [thousands(scenes), thousands(queries), thousands(queries.saturating_mul(backends)), cost]);
    };
    for part in 1..=*parts {
        row(format!("{part}/{parts}"), &|share| share.part == part);
    }
    row("all".to_owned(), &|_| true);
    let count = |basis: Basis| shares.iter().filter(|share| share.basis == basis).count();
    say!(
        "level {}, {backends} backends; costs of {} scenes measured, of {} estimated, of {} unknown",
        plan.level,
        count(Basis::Measured),
        count(Basis::Estimated),
        count(Basis::Unknown)
    );
}

/// Formats microseconds as seconds with one decimal.
fn seconds(micros: u64) -> String {
    let tenths = micros.saturating_add(50_000) / 100_000;
    format!("{}.{} s", thousands(tenths / 10), tenths % 10)
}
