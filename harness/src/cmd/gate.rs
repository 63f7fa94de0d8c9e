//! `gate`: holds a run against its expectations, and against an earlier run.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use predicament_records::{self as records, RunDir, Spread, Status, SummaryRow, ThroughputRow, junit};
use predicament_tasks::{Class, ClassCounts, is_declared};
use serde_json::json;

use crate::exit::{self, Failure};
use crate::expectations;
use crate::ledger::describe;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament gate out/run
  predicament gate out/run --baseline out/main --junit out/junit.xml
  predicament gate out/run --expected mine-expected.toml --suggest more.toml";

/// Hold a run against expectations and a baseline
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// A folder written by `run`
    pub run: PathBuf,

    /// An earlier run: no finding may have become more frequent, no timing slower beyond noise
    #[arg(long, value_name = "RUN")]
    pub baseline: Option<PathBuf>,

    /// Expected disagreements; those of the embedded corpora if left out
    #[arg(long, value_name = "FILE")]
    pub expected: Option<PathBuf>,

    /// Write a JUnit file
    #[arg(long, value_name = "FILE")]
    pub junit: Option<PathBuf>,

    /// Print one JSON object: the counts, and everything that is not as it should be
    #[arg(long, conflicts_with = "suggest")]
    pub json: bool,

    /// Write the expectations that would make every unexpected finding expected, as TOML with reasons to
    /// be filled in; to stdout if no file is named
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    pub suggest: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let expected = expectations::load(tool, args.expected.as_ref())?;
    let mut run = RunDir::open(&args.run).map_err(Failure::usage)?;
    let level = run.plan.level.to_string();
    // The file may have changed since the run: it is the gate's word that counts.
    for row in &mut run.summary {
        let mut counts = ClassCounts::default();
        for class in Class::ALL {
            counts.add(class, row.count(class));
        }
        row.status = expected.status(&row.suite, &row.scene, &row.backend, &level, &counts);
    }
    let worse = match &args.baseline {
        None => Worse::default(),
        Some(baseline) => {
            let baseline = RunDir::open(baseline).map_err(Failure::usage)?;
            comparable(&run, &baseline)?;
            Worse { findings: more_findings(&run, &baseline), timings: slower(&run, &baseline) }
        }
    };
    if let Some(path) = &args.junit {
        let text = junit("predicament", &run.summary, &run.not_run()).map_err(Failure::usage)?;
        records::replace(path, text.as_bytes()).map_err(Failure::usage)?;
    }
    let not_run = run.not_run();
    let unused = expectations::unused(&expected, tool, &run.plan)?;
    if let Some(file) = &args.suggest {
        suggest(&run, file)?;
    }
    let undeclared = undeclared(run.findings.iter(), tool);
    let count = |status: Status| run.summary.iter().filter(|row| row.status == status).count();
    let (unexpected, passes) = (count(Status::Unexpected), count(Status::UnexpectedPass));
    let failed: Vec<String> = run.summary.iter().filter(|row| !row.status.passes()).map(describe).collect();
    let missing: Vec<String> =
        not_run.iter().map(|pair| format!("{}/{} on {}", pair.suite, pair.scene, pair.backend)).collect();
    if args.json {
        let told = json!({
            "run": args.run,
            "outcome": run.outcome,
            "rows": run.summary.len(),
            "ok": count(Status::Ok),
            "expected": count(Status::Expected),
            "unexpected": unexpected,
            "unexpected_pass": passes,
            "failed": failed,
            "not_declared": undeclared,
            "never_true": unused.never,
            "not_held": unused.here,
            "not_run": missing,
            "worse": worse.findings.iter().chain(&worse.timings).collect::<Vec<_>>(),
        });
        say!("{told}");
    } else {
        failed.iter().chain(&worse.findings).chain(&worse.timings).for_each(|line| say!("{line}"));
        undeclared.iter().for_each(|line| say!("not declared: {line}"));
        missing.iter().for_each(|line| say!("not run: {line}"));
        unused.never.iter().for_each(|line| say!("never true: {line}"));
        if !unused.here.is_empty() {
            say!("{} expectations are not about this run's scenes, backends and level", unused.here.len());
        }
        say!(
            "{}: {} rows: {} ok, {} expected, {unexpected} unexpected, {passes} unexpected pass, {} never true, {} not \
             run, {} worse than the baseline; {}",
            args.run.display(),
            run.summary.len(),
            count(Status::Ok),
            count(Status::Expected),
            unused.never.len(),
            not_run.len(),
            worse.findings.len() + worse.timings.len(),
            run.outcome.describe(),
        );
    }
    Ok(if unexpected > 0 || !undeclared.is_empty() || !worse.findings.is_empty() {
        exit::UNEXPECTED
    } else if passes > 0 || !unused.never.is_empty() {
        exit::UNEXPECTED_PASS
    } else if !run.is_complete() || !not_run.is_empty() {
        exit::INCOMPLETE
    } else if !worse.timings.is_empty() {
        exit::SLOWER
    } else {
        exit::OK
    })
}

/// The findings that no task declares a check for, each kind once: their judges say what their lists do not.
fn undeclared<'r>(findings: impl Iterator<Item = &'r records::FindingRow>, tool: &Tool) -> Vec<String> {
    let is_declared = |row: &&records::FindingRow| {
        let task = tool.tasks().iter().find(|task| task.name() == row.task);
        task.is_none_or(|&task| is_declared(task, row.class, &row.check))
    };
    let mut first: BTreeMap<String, &str> = BTreeMap::new();
    for row in findings.filter(|row| !is_declared(row)) {
        first.entry(format!("{} ({}) of {}", row.class, row.check, row.task)).or_insert(&row.finding_id);
    }
    first.into_iter().map(|(what, id)| format!("{what}, such as {id}")).collect()
}

#[derive(Default)]
struct Worse {
    findings: Vec<String>,
    timings: Vec<String>,
}

/// Rows of the same scene and backend with more of an illegal class than before.
fn more_findings(run: &RunDir, baseline: &RunDir) -> Vec<String> {
    let before: BTreeMap<(&str, &str), &SummaryRow> =
        baseline.summary.iter().map(|row| ((row.scene_id.as_str(), row.backend.as_str()), row)).collect();
    let mut worse = Vec::new();
    for row in &run.summary {
        let Some(old) = before.get(&(row.scene_id.as_str(), row.backend.as_str())) else { continue };
        for class in Class::ALL.into_iter().filter(|class| !class.is_legal()) {
            let (now, then) = (row.count(class), old.count(class));
            if now > then {
                worse.push(format!(
                    "worse than the baseline: {}/{} on {}: {} {class}, was {then}",
                    row.suite, row.scene, row.backend, now
                ));
            }
        }
    }
    worse
}

/// Timings of a scene whose fastest sample is slower than the slowest sample of before,
/// and by a tenth at least: beyond what noise explains. A family of several scenes is compared scene by scene, as
/// those take different times; where it had other scenes, there is nothing to compare.
fn slower(run: &RunDir, baseline: &RunDir) -> Vec<String> {
    let (now, then) = (timings(run), timings(baseline));
    let (scenes, scenes_then) = (scenes(run), scenes(baseline));
    let mut slower = Vec::new();
    for (key @ [task, family, backend], now) in &now {
        let Some(then) = then.get(key) else { continue };
        let of = [*task, *family];
        if now.len() != then.len() || scenes.get(&of) != scenes_then.get(&of) {
            note!("{task} {family} on {backend}: other scenes were timed than in the baseline; not compared");
            continue;
        }
        for (now, then) in now.iter().zip(then) {
            if now.min > then.max && now.median > 1.1 * then.median {
                let times = now.median / then.median;
                slower.push(format!(
                    "slower: {task} {family} on {backend}: {:.2} ns/query, was {:.2} ({times:.2} times)",
                    now.median, then.median
                ));
            }
        }
    }
    slower
}

/// The timings of each scene, by task, family and backend.
fn timings(run: &RunDir) -> BTreeMap<[&str; 3], Vec<Spread>> {
    let spread = |scene: &Vec<&ThroughputRow>| Spread::of(scene.iter().map(|row| row.ns_per_query));
    let scenes = run.timed_scenes().into_iter();
    scenes.map(|(key, scenes)| (key, scenes.iter().filter_map(spread).collect())).collect()
}

/// The scenes of each task and family, by id.
fn scenes(run: &RunDir) -> BTreeMap<[&str; 2], Vec<&str>> {
    let mut scenes: BTreeMap<_, Vec<_>> = BTreeMap::new();
    for scene in &run.plan.scenes {
        scenes.entry([&*scene.task, &*scene.family]).or_default().push(&*scene.scene_id);
    }
    scenes
}

/// Refuses a baseline that says nothing about this run.
fn comparable(run: &RunDir, baseline: &RunDir) -> Result<(), Failure> {
    let before: BTreeSet<&str> = baseline.plan.scenes.iter().map(|scene| scene.scene_id.as_str()).collect();
    let timed = || {
        let then = timings(baseline);
        timings(run).keys().any(|key| then.contains_key(key))
    };
    if run.plan.scenes.iter().any(|scene| before.contains(scene.scene_id.as_str())) || timed() {
        return Ok(());
    }
    Err(Failure::usage(format!(
        "{}: the baseline has no scene of this run, so nothing can be compared; name a run of the same suites",
        baseline.path.display()
    )))
}

/// Writes TOML that would turn the gate green once a person has given the reasons: an empty reason is refused.
fn suggest(run: &RunDir, file: &Path) -> Result<(), Failure> {
    let mut alike: BTreeMap<(&str, Vec<&str>), Vec<String>> = BTreeMap::new();
    for row in run.summary.iter().filter(|row| row.status == Status::Unexpected) {
        let found = |class: &Class| !class.is_legal() && row.count(*class) > 0;
        let classes = Class::ALL.into_iter().filter(found).map(Class::name).collect();
        let scene = globset::escape(&format!("{}/{}", row.suite, row.scene));
        alike.entry((&row.backend, classes)).or_default().push(scene);
    }
    let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
    let list = |items: Vec<String>| format!("[{}]", items.join(", "));
    let mut text = String::new();
    for ((backend, classes), scenes) in alike {
        let classes = list(classes.into_iter().map(quoted).collect());
        let scenes: String = scenes.iter().map(|scene| format!("    {},\n", quoted(scene))).collect();
        let (backend, level) = (quoted(backend), &run.plan.level);
        text += &format!(
            "[[expect]]\nbackend = {backend}\nclass = {classes}\nscene = [\n{scenes}]\nlevel = \"{level}\"\n\
             reason = \"\" # say why\n\n"
        );
    }
    if file == Path::new("-") {
        say_text!("{text}");
        return Ok(());
    }
    if file.exists() {
        return Err(Failure::usage(format!("{}: the file is there; name another for --suggest", file.display())));
    }
    records::replace(file, text.as_bytes()).map_err(Failure::usage)
}

#[cfg(test)]
mod tests {
    use predicament_records::PlannedScene;
    use predicament_tasks::Finding;

    use super::*;

    #[test]
    fn a_finding_that_its_task_does_not_declare_is_named_once() {
        let tool = Tool::new((), &(), Vec::new(), None);
        let row = |task: &str, class: Class, check: &str, id: &str| {
            let scene = PlannedScene {
                suite: "mine".to_owned(),
                scene: "a".to_owned(),
                scene_id: "0123456789abcdef".to_owned(),
                task: task.to_owned(),
                family: "a".to_owned(),
                queries: 1,
            };
            let finding = Finding::plain(class, check, Vec::new(), String::new(), String::new());
            crate::rows::finding(&scene, "naive", &finding, id.to_owned())
        };
        let rows = [
            row("orient2d", Class::SignFlip, "sign", "000000000001"),
            row("orient2d", Class::Panic, "crashed", "000000000002"),
            row("orient2d", Class::SignFlip, "sigh", "000000000003"),
            row("orient2d", Class::SignFlip, "sigh", "000000000004"),
            row("orient2d", Class::Topology, "sign", "000000000005"),
            row("hull3d", Class::Topology, "stitched faces make a surface", "000000000006"),
            row("hull2d", Class::Topology, "stitched faces make a surface", "000000000007"),
        ];
        assert_eq!(
            undeclared(rows.iter(), &tool),
            [
                "sign_flip (sigh) of orient2d, such as 000000000003",
                "topology (sign) of orient2d, such as 000000000005",
                "topology (stitched faces make a surface) of hull2d, such as 000000000007",
            ]
        );
    }
}
