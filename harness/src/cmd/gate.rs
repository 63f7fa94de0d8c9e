//! `gate`: compares a run with its expectations and with an earlier run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use predicament_predicates::{Severity, UnknownName};
use predicament_records::{self as records, RunDir, Status, SummaryRow, junit};
use predicament_tasks::{Class, is_declared};
use serde_json::json;

use crate::baseline::{Beside, Change};
use crate::colour::{Paint, paint};
use crate::comment::{Comment, LIMIT};
use crate::details::Bodies;
use crate::exit::{self, Failure};
use crate::expect_file::grouped;
use crate::expectations;
use crate::ledger::describe;
use crate::out::{one_line, program, word};
use crate::places::apart;
use crate::progress;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament gate out/run
  predicament gate out/run --baseline out/main --junit out/junit.xml
  predicament gate out/run --baseline out/main --summary comment.md      for a comment on a pull request
  predicament gate out/bench --baseline out/bench-before --time 20       and no scene slower by 20 %
  predicament gate out/run --fail-on broken,not_done     vertices off by rounding, within its bound, are let pass
  predicament gate out/run --expected mine-expected.toml --suggest more.toml";

/// Check a run against expectations and a baseline
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// A folder written by `run`
    pub run: PathBuf,

    /// An earlier run; a finding that became more frequent fails the gate
    #[arg(long, value_name = "RUN")]
    pub baseline: Option<PathBuf>,

    /// The severities that fail the gate, of `broken` (a wrong sign or topology), `not_done` (declined, out of time,
    /// crashed), `accepted` (a library answered invalid input), `refused` (a library reported an error for valid input)
    /// and `rounded` (off by the rounding of output coordinates, within a stated bound); findings of the other
    /// severities are listed but pass, expected or not
    #[arg(long, value_name = "SEVERITIES", value_delimiter = ',', value_parser = severity,
          default_value = "broken,not_done,accepted,refused,rounded")]
    pub fail_on: Vec<Severity>,

    /// Also compare times on the same machine: a scene fails if all its samples are slower than those of the baseline
    /// and its median is slower by this percentage (default 10)
    #[arg(long, value_name = "PERCENT", num_args = 0..=1, default_missing_value = "10", requires = "baseline",
          value_parser = percent)]
    pub time: Option<f64>,

    /// Write Markdown for a comment, at most 65,536 characters: the verdict, counts, first findings, and the changes
    /// since the baseline; `-` writes only this to stdout
    #[arg(long, value_name = "FILE")]
    pub summary: Option<PathBuf>,

    /// The file of expected disagreements; default: those of the embedded corpora
    #[arg(long, value_name = "FILE")]
    pub expected: Option<PathBuf>,

    /// Write a JUnit file
    #[arg(long, value_name = "FILE")]
    pub junit: Option<PathBuf>,

    /// Lines for people, or one JSON object with the counts and everything that is not as expected
    #[arg(long, value_enum, default_value_t = Format::Text)]
    pub format: Format,

    /// Write the expectations that would cover every unexpected finding, as TOML with empty reasons; to stdout if no
    /// file is named
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    pub suggest: Option<PathBuf>,
}

/// Parses a threshold for times, in percent.
fn percent(text: &str) -> Result<f64, String> {
    let percent = text.parse().ok().filter(|percent: &f64| (0.0..=1e6).contains(percent));
    percent.ok_or_else(|| format!("`{text}` is not a threshold; write percent, such as 10"))
}

/// Parses a severity of findings.
fn severity(text: &str) -> Result<Severity, String> {
    match text.parse().map_err(|why: UnknownName| why.to_string())? {
        legal @ (Severity::Right | Severity::Undecided) => {
            Err(format!("findings do not have the severity `{legal}`; leave it out"))
        }
        severity => Ok(severity),
    }
}

/// The output format.
#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
pub enum Format {
    /// Lines for people.
    Text,
    /// One JSON object.
    Json,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let _working = progress::working("reading the run");
    let to_stdout = args.summary.as_deref() == Some(Path::new("-"));
    if to_stdout && args.format == Format::Json {
        return Err(Failure::usage("--format json and --summary - both write to stdout; name a file for --summary"));
    }
    let outputs = [("--summary", &args.summary), ("--junit", &args.junit), ("--suggest", &args.suggest)];
    let outputs: Vec<(&str, &Path)> =
        outputs.iter().filter_map(|(name, file)| Some((*name, file.as_deref()?))).collect();
    let runs: Vec<&Path> = [&*args.run].into_iter().chain(args.baseline.as_deref()).collect();
    apart(&outputs, &args.expected.as_deref().into_iter().collect::<Vec<_>>(), &runs)?;
    let expected = expectations::load(tool, args.expected.as_ref())?;
    let mut run = exit::open(&args.run)?;
    // The file may have changed since the run; the gate's expectations count.
    expectations::hold(&expected, &mut run);
    let mut baseline = args.baseline.as_ref().map(exit::open).transpose()?;
    if let Some(baseline) = &mut baseline {
        expectations::hold(&expected, baseline);
    }
    let mut beside = match &baseline {
        None => Beside::default(),
        Some(baseline) => Beside::baseline(&run, baseline, args.time)?,
    };
    let mut passed = expectations::let_pass(&expected, &mut run, &args.fail_on);
    let is_asked = |change: &Change| args.fail_on.contains(&change.class.severity());
    let (worse, milder) = beside.worse.into_iter().partition(is_asked);
    beside.worse = worse;
    passed.extend(milder.iter().map(Change::to_string));
    let unmet = expectations::unmet(&expected, &run);
    if let Some(path) = &args.junit {
        let bodies = Bodies::new(&run, &expected, tool);
        let text = junit("predicament", &run.summary, &run.not_run(), &|row| bodies.of(row, &unmet));
        let text = text.map_err(Failure::usage)?;
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
    let code = if unexpected > 0 || !undeclared.is_empty() || !beside.worse.is_empty() {
        exit::UNEXPECTED
    } else if passes > 0 || !unused.never.is_empty() {
        exit::UNEXPECTED_PASS
    } else if !run.is_complete() || !not_run.is_empty() {
        exit::INCOMPLETE
    } else if !beside.timings.is_empty() {
        exit::SLOWER
    } else {
        exit::OK
    };
    if args.format == Format::Json {
        let told = json!({
            "run": args.run,
            "outcome": run.outcome,
            "rows": run.summary.len(),
            "ok": count(Status::Ok),
            "expected": count(Status::Expected),
            "unexpected": unexpected,
            "unexpected_pass": passes,
            "failed": failed,
            "let_pass": passed,
            "not_declared": undeclared,
            "not_met": unmet,
            "never_true": unused.never,
            "not_held": unused.here,
            "not_run": missing,
            "worse": lines(&beside.worse).into_iter().chain(beside.timings.clone()).collect::<Vec<_>>(),
            "better": lines(&beside.better),
            "times_not_compared": beside.not_compared,
            "times_not_judged": beside.times.as_ref().and_then(|times| times.as_ref().err()),
        });
        say!("{told}");
    } else if !to_stdout {
        failed
            .iter()
            .chain(&lines(&beside.worse))
            .chain(&beside.timings)
            .for_each(|line| say!("{}", paint(Paint::Bad, line)));
        passed.iter().for_each(|line| say!("let pass: {line}"));
        beside.better.iter().for_each(|change| say!("{change}"));
        undeclared.iter().for_each(|line| say!("not declared: {line}"));
        missing.iter().for_each(|line| say!("{}", paint(Paint::Faint, &format!("not run: {line}"))));
        unused.never.iter().for_each(|line| say!("never true: {line}"));
        unmet.iter().for_each(|line| say!("not met: {line}"));
        if !unmet.is_empty() || !unused.never.is_empty() {
            say!("remove unmet expectations with: {}", prune(args));
        }
        if let Some(Err(why)) = &beside.times {
            say!("times were not judged: {why}");
        }
        beside.not_compared.iter().for_each(|line| say!("time not compared: {line}"));
        if !unused.here.is_empty() {
            say!("{} expectations do not apply to this run's scenes, backends and level", unused.here.len());
        }
        let told = format!(
            "{} rows: {} ok, {} expected, {unexpected} unexpected, {passes} unexpected pass, {} never true, {} not \
             run, {} worse than the baseline, {} better{}{}; {}",
            run.summary.len(),
            count(Status::Ok),
            count(Status::Expected),
            unused.never.len(),
            not_run.len(),
            beside.worse.len(),
            beside.better.len(),
            if passed.is_empty() { String::new() } else { format!(", {} let pass", passed.len()) },
            if beside.timings.is_empty() { String::new() } else { format!(", {} slower", beside.timings.len()) },
            run.outcome.describe(),
        );
        say!("{}: {}", args.run.display(), paint(Paint::of(code), &told));
    }
    if let Some(file) = &args.summary {
        let (run, baseline, expected, unused) = (&run, baseline.as_ref(), &expected, &unused);
        let prune = prune(args);
        let comment = Comment {
            run,
            baseline,
            beside: &beside,
            passed: &passed,
            unmet: &unmet,
            prune: &prune,
            expected,
            unused,
            fail_on: &args.fail_on,
            code,
        };
        let text = comment.text(LIMIT)?;
        if to_stdout {
            say_text!("{text}");
        } else {
            records::replace(file, text.as_bytes()).map_err(Failure::usage)?;
        }
    }
    Ok(code)
}

fn lines(changes: &[Change]) -> Vec<String> {
    changes.iter().map(ToString::to_string).collect()
}

/// The command that removes expectations that the run does not meet.
fn prune(args: &Args) -> String {
    let mut command = format!("{} corpus expect prune {}", program(), word(&args.run.display().to_string()));
    if let Some(file) = &args.expected {
        command += &format!(" --expected {}", word(&file.display().to_string()));
    }
    command
}

/// The findings whose task does not declare their check, one per kind. The task's judge reports a check that its list
/// lacks.
fn undeclared<'r>(findings: impl Iterator<Item = &'r records::FindingRow>, tool: &Tool) -> Vec<String> {
    let is_declared = |row: &&records::FindingRow| {
        let task = tool.tasks().iter().find(|task| task.name() == row.task);
        task.is_none_or(|&task| is_declared(task, row.class, &row.check))
    };
    let mut first: BTreeMap<String, &str> = BTreeMap::new();
    for row in findings.filter(|row| !is_declared(row)) {
        first.entry(format!("{} ({}) of {}", row.class, one_line(&row.check), row.task)).or_insert(&row.finding_id);
    }
    first.into_iter().map(|(what, id)| format!("{what}, such as {id}")).collect()
}

/// Writes the TOML that would make the gate pass once a person fills in the reasons; an empty reason is refused.
fn suggest(run: &RunDir, file: &Path) -> Result<(), Failure> {
    let found = |row: &SummaryRow| {
        let classes = Class::ALL.into_iter().filter(|class| !class.is_legal() && row.count(*class) > 0);
        classes.collect()
    };
    let level = run.plan.level.to_string();
    let entries = grouped(run, found).into_iter().map(|entry| entry.text(&level, None) + "\n");
    let text: String = entries.collect();
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
        let tool = Tool::new((), &predicament_bundle::Systems, crate::tool::Guests::default());
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
