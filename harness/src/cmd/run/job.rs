//! The work of a run: the selection of the command line, a plan, or the rest of an incomplete run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use predicament_corpus::Level;
use predicament_records::{Build, Env, Plan, PlannedScene, RunDir, RunWriter, Shard, Whole, WorkPlan};
use predicament_tasks::Contestant;

use super::Args;
use crate::exit::Failure;
use crate::ledger::Ledger;
use crate::planning::{env, env_of, free_folder, plan, same_versions, tables_of};
use crate::programs::{Picked, Recorded, recorded};
use crate::select::{Planned, Selection, Selector, suites_of};
use crate::shared::tell_not_selected;
use crate::tool::{Tool, engines};
use crate::{expectations, worker};

/// A run in progress.
pub struct Job {
    pub selection: Selection,
    pub scenes: Vec<Planned>,
    pub backends: Vec<Box<dyn Contestant>>,
    /// The files of engines, by backend name.
    pub engines: BTreeMap<String, String>,
    /// The number of evaluations spent on other orders of arguments, if given.
    pub permutations: Option<usize>,
    pub ledger: Ledger,
}

impl Job {
    /// The job that the command line asks for.
    pub fn of(args: &Args, tool: &Tool, expected: &str) -> Result<Job, Failure> {
        match (&args.resume, &args.plan) {
            (Some(folder), _) => Job::resume(args, tool, folder, expected),
            (None, Some(file)) => Job::planned(args, tool, file, expected),
            (None, None) => Job::new(args, tool, expected),
        }
    }

    /// A new job for the scenes and backends that the command line selects.
    fn new(args: &Args, tool: &Tool, expected: &str) -> Result<Job, Failure> {
        let selection = args.selector.select(tool)?;
        let (backends, only) = tool.pick_for(&args.backends, &selection.defs())?;
        let shard = args.shard.unwrap_or(Shard::WHOLE);
        let (scenes, whole) = selection.part(shard)?;
        let plan = Plan {
            answers: args.answers,
            permutations: args.permutations.map(|most| most as u64),
            engines: recorded(&args.backends, &backends)?,
            left_out: tool.left_out(&args.backends, &only),
            only,
            expected: args.expected.as_deref().map(expectations::file).transpose()?,
            whole: whole.map(|whole| Whole { expected: Some(expected.to_owned()), ..whole }),
            ..plan(tool, &selection, &scenes, &backends, shard)
        };
        let picked = Picked { backends, files: engines(&args.backends)? };
        let job = Job::start(args, tool, (selection, scenes, picked), plan, None)?;
        tell_not_selected(&job.selection.not_selected, "run");
        Ok(job)
    }

    /// The job of a work plan, or of one of its parts.
    fn planned(args: &Args, tool: &Tool, file: &Path, expected: &str) -> Result<Job, Failure> {
        let work = WorkPlan::read(file).map_err(Failure::usage)?;
        let refuse = |why: String| Failure::usage(format!("{}: {why}", file.display()));
        let build = Build::of(&env());
        if work.build != build {
            let (planned, this) = (work.build.describe(), build.describe());
            return Err(refuse(format!("it was made by another build of the tool, {planned}; this is {this}")));
        }
        if work.expected != expected {
            return Err(refuse(
                "it was made for other expectations; give the same --expected, or make a new plan".to_owned(),
            ));
        }
        let named = args.expected.as_deref().map(expectations::file).transpose()?;
        let plan = Plan { expected: named, ..work.part(args.shard).map_err(|why| refuse(why.to_string()))? };
        let level: Level = plan.level.to_string().parse().map_err(Failure::usage)?;
        let selector = Selector { suites: suites_of(file, &plan), level, ..args.selector.clone() };
        let selection = selector.select(tool)?;
        let scenes = selection.of_plan(&plan.scenes, |scene, of| {
            refuse(format!(
                "scene {}/{}{of} has changed since the plan was made, or is gone; make a new plan",
                scene.suite, scene.scene
            ))
        })?;
        if let Some((suite, _)) = plan.hashes.iter().find(|(suite, hash)| selection.hashes().get(*suite) != Some(hash))
        {
            let of = selection.of_file(suite);
            return Err(refuse(format!("the suite `{suite}`{of} has changed since; make a new plan")));
        }
        let recorded = Recorded { file, folder: None, engines: &plan.engines };
        let picked = args.programs.pick(tool, &plan.backends, recorded)?;
        Job::start(args, tool, (selection, scenes, picked), plan, Some(work.hash))
    }

    /// Makes the folder of the run and writes its plan.
    fn start(
        args: &Args,
        tool: &Tool,
        (selection, scenes, picked): (Selection, Vec<Planned>, Picked),
        plan: Plan,
        work: Option<String>,
    ) -> Result<Job, Failure> {
        let folder = args.out.clone().unwrap_or_else(|| free_folder("predicament-run"));
        let Picked { backends, files: engines } = picked;
        let env = Env { plan: work, ..env_of(&backends) };
        let writer = RunWriter::create(&folder, &plan, &env, &tables_of(tool, &plan)).map_err(Failure::usage)?;
        let (level, answers, permutations) = (selection.level, plan.answers, permutations(&plan));
        let (done, precision, wholes) = (Vec::new(), Vec::new(), BTreeMap::new());
        let (places, left_out, only) = (places(&plan), plan.left_out, plan.only);
        let ledger = Ledger { level, answers, wholes, done, precision, only, left_out, places, folder, writer };
        Ok(Job { selection, scenes, backends, engines, permutations, ledger })
    }

    /// The rest of an incomplete run.
    fn resume(args: &Args, tool: &Tool, folder: &PathBuf, expected: &str) -> Result<Job, Failure> {
        let plan = &RunDir::plan(folder).map_err(Failure::usage)?;
        if plan.timed {
            let message = format!(
                "{}: a bench cannot be resumed, because its times belong together; start a new one",
                folder.display()
            );
            return Err(Failure::usage(message));
        }
        if plan.whole.as_ref().and_then(|whole| whole.expected.as_ref()).is_some_and(|hash| hash != expected) {
            let message = "it was begun with other expectations, so its rows would not agree; give the same --expected";
            return Err(Failure::usage(format!("{}: {message}", folder.display())));
        }
        let level: Level = plan.level.to_string().parse().map_err(Failure::usage)?;
        let selector = Selector { level, ..args.selector.clone() };
        let selector = if selector.suites.is_empty() {
            Selector { suites: suites_of(folder, plan), ..selector }
        } else {
            selector
        };
        let selection = selector.select(tool)?;
        let recorded = Recorded { file: &folder.join("plan.json"), folder: Some(folder), engines: &plan.engines };
        let Picked { backends, files: engines } = args.programs.pick(tool, &plan.backends, recorded)?;
        // The filter of the first call is not needed, because the plan lists the scenes.
        let scenes = selection.of_plan(&plan.scenes, |lost, of| {
            Failure::usage(format!(
                "{}: scene {}/{}{of} has changed since the run was planned, or is gone; start a new run",
                folder.join("plan.json").display(),
                lost.suite,
                lost.scene
            ))
        })?;
        let permutations = args.permutations.or(permutations(plan));
        let (answers, left_out, only, places) = (plan.answers, plan.left_out.clone(), plan.only.clone(), places(plan));
        same_versions(folder, &backends)?;
        let (writer, before) =
            RunWriter::resume(folder, || env_of(&backends), &tables_of(tool, plan)).map_err(Failure::usage)?;
        // Remove what workers of a killed run left.
        worker::clear(folder);
        let RunDir { summary, precision, .. } = before;
        let (done, precision) = (summary.into(), precision.into());
        let (folder, wholes, level) = (folder.clone(), BTreeMap::new(), selection.level);
        let ledger = Ledger { level, answers, wholes, done, precision, only, left_out, places, folder, writer };
        Ok(Job { selection, scenes, backends, engines, permutations, ledger })
    }
}

/// The number of evaluations that a plan spends on other orders of arguments, if it says so.
fn permutations(plan: &Plan) -> Option<usize> {
    plan.permutations.map(|most| usize::try_from(most).unwrap_or(usize::MAX))
}

/// The position of each scene of a part in the whole run.
fn places(plan: &Plan) -> BTreeMap<PlannedScene, u64> {
    let places = plan.whole.iter().flat_map(|whole| whole.places.iter().copied());
    plan.scenes.iter().cloned().zip(places).collect()
}
