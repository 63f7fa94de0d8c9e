//! The sample report: the tool's results on the embedded and the fetched suites, in `reports/sample`, README and
//! `docs/WHICH.md`.

#[cfg(test)]
mod agrees;

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::command::{cargo, fresh, root, step_ending, target_directory};

/// The folder of the runs, beside the build.
const WORK: &str = "target/sample";
/// The folder of the sample.
const SAMPLE: &str = "reports/sample";
/// The text of `corpus list` for suites whose data must be fetched.
const FETCHED: &str = "(needs `predicament corpus fetch`)";

/// Backends that differ in one parameter: the curves of errors over time.
const CURVES: &str = "exact,epsilon:1e-16,epsilon:1e-14,epsilon:1e-12,epsilon:1e-10,epsilon:1e-8,epsilon:1e-6,epsilon:1e-4,\
    exact:stages=1,exact:stages=2,exact:stages=3,exact:stages=4,exact:stages=5,exact:stages=6";

/// The backends that are asked about decimals.
const SWEPT: &str = "exact,sos,tolerance,epsilon:1e-12,epsilon:1e-10,epsilon:1e-8,epsilon:1e-6,epsilon:1e-2";

/// The files of studies from which the figures of `docs/WHICH.md` are made, relative to the folder of the run.
const STUDIED: [&str; 11] = [
    "compare/compare.csv",
    "compare/promises.csv",
    "compare/conditioning.csv",
    "curves/compare.csv",
    "stress/breaks.csv",
    "stress/stress-laws.csv",
    "cut/cut.csv",
    "parity/parity.csv",
    "parity-space/parity-space.csv",
    "decimals/decimals.csv",
    "ablation/ablation.csv",
];

/// Measures that no figure of the page uses: the sample omits their rows.
const UNUSED: [&str; 10] = [
    "stage: ",
    "topology: ",
    "memory,",
    "declined,",
    "tie_broken,",
    "sign_flip,",
    "missed_zero,",
    "overreach,",
    "nan,",
    "inconsistent,",
];

/// Runs, times and compares everything, and writes the report.
///
/// It puts a selection into the sample, README and `docs/WHICH.md`. With `resume` it keeps the steps that an earlier
/// call has done.
pub fn make(resume: bool) -> Result<(), String> {
    let work = if resume { PathBuf::from(WORK) } else { fresh(WORK)? };
    let path = |name: &str| work.join(name).display().to_string();
    let (run, fetched, bench, report) = (path("run"), path("fetched"), path("bench"), path("report"));
    cargo("build the tool", &["build", "--release"])?;
    let program = target_directory()?.join("release").join("predicament").display().to_string();
    let words =
        |args: &[&str]| -> Vec<String> { [program.as_str()].iter().chain(args).map(|&word| word.to_owned()).collect() };
    let tool = |what: &str, args: &[&str]| once(&work, what, &words(args), &[0]);
    tool("fetch real data", &["corpus", "fetch", "--quiet"])?;
    tool("run the embedded suites", &["run", "--out", &run])?;
    let suites = fetched_suites(&program)?;
    let all: Vec<&str> =
        ["run"].into_iter().chain(suites.iter().map(String::as_str)).chain(["--out", &fetched]).collect();
    tool("run the fetched suites", &all)?;
    tool("time the backends", &["bench", "--judged", &run, "--out", &bench])?;
    let study = |name: &str| format!("{run}/{name}");
    tool("compare the backends", &["study", "compare", "--quiet", "--out", &study("compare")])?;
    let one_parameter =
        ["study", "compare", "--quiet", "-b", CURVES, "--scenes", "5", "--trials", "0", "--queries", "0"];
    tool("turn one parameter", &[&one_parameter[..], &["--out", &study("curves")]].concat())?;
    tool("cut tetrahedra", &["study", "cut", "--quiet", "--out", &study("cut")])?;
    let pairs = ["study", "parity", "--quiet", "--pairs", "2000", "--shrink", "0"];
    tool("merge closed curves", &[&pairs[..], &["--out", &study("parity")]].concat())?;
    let surfaces = ["--dimension", "3", "--out", &study("parity-space")];
    tool("merge closed surfaces", &[&pairs[..], &surfaces].concat())?;
    let decimals = ["study", "decimals", "--quiet", "--digits", "0,1,2,3,4,6,8", "--samples", "0", "-b", SWEPT];
    tool("ask about decimals", &[&decimals[..], &["--out", &study("decimals")]].concat())?;
    tool("leave out devices", &["study", "ablation", "--quiet", "--out", &study("ablation")])?;
    tool("turn the knobs", &["study", "stress", "--quiet", "--out", &study("stress")])?;
    let [readme, which] = ["README.md", "docs/WHICH.md"].map(|page| root().join(page).display().to_string());
    let spliced = ["--splice", &readme, "--splice", &which];
    tool("write the report", &[&["report", &run, &fetched, &bench, "--out", &report], &spliced[..]].concat())?;
    let picture = root().join(SAMPLE).join("kettner.png").display().to_string();
    tool(
        "draw a pixel map",
        &["draw", "map", "kettner-pixels-a", "-b", "naive,naive:first,exact,tolerance", "--out", &picture],
    )?;
    keep(Path::new(&report))?;
    keep_studied(Path::new(&run))?;
    println!("\n{SAMPLE}, the table of README and docs/WHICH.md are new; commit them together");
    Ok(())
}

/// Runs a step that leaves a mark in this folder, or only says that the mark is there.
///
/// The step may end with these codes.
pub fn once(work: &Path, what: &str, words: &[String], fine: &[i32]) -> Result<(), String> {
    let mark = root().join(work).join(format!("{}.done", what.replace(' ', "-")));
    if mark.is_file() {
        println!("\n== {what}: done before");
        return Ok(());
    }
    // A step that was stopped has left a part of its folder.
    let out = words.iter().skip_while(|word| *word != "--out").nth(1).map(|out| root().join(out));
    if let Some(out) = out.filter(|out| out.is_dir()) {
        std::fs::remove_dir_all(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    }
    step_ending(what, words, &[], fine)?;
    std::fs::write(&mark, "").map_err(|error| format!("{}: {error}", mark.display()))
}

/// The suites whose data must be fetched.
fn fetched_suites(program: &str) -> Result<Vec<String>, String> {
    let output =
        Command::new(program).args(["corpus", "list"]).output().map_err(|error| format!("corpus list: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let lines = text.lines().filter(|line| line.contains(FETCHED));
    let suites: Vec<String> = lines.filter_map(|line| line.split_whitespace().next().map(str::to_owned)).collect();
    if suites.is_empty() { Err("corpus list names no suite that has to be fetched".to_owned()) } else { Ok(suites) }
}

/// Replaces the sample by the parts of the report that a forge shows: the page in Markdown, its plots, and the figures.
fn keep(report: &Path) -> Result<(), String> {
    let sample = root().join(SAMPLE);
    let is_kept = |name: &str| ["report.md", "figures.csv"].contains(&name) || name.ends_with(".svg");
    let names = |folder: &Path| -> Result<Vec<String>, String> {
        let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
        let entries = std::fs::read_dir(folder).map_err(failed)?;
        let names = entries.map(|entry| Ok(entry.map_err(failed)?.file_name().to_string_lossy().into_owned()));
        Ok(names.collect::<Result<Vec<_>, String>>()?.into_iter().filter(|name| is_kept(name)).collect())
    };
    for name in names(&sample)? {
        std::fs::remove_file(sample.join(&name)).map_err(|error| format!("{name}: {error}"))?;
    }
    for name in names(report)? {
        std::fs::copy(report.join(&name), sample.join(&name)).map_err(|error| format!("{name}: {error}"))?;
    }
    Ok(())
}

/// Replaces the files of studies in the sample.
fn keep_studied(run: &Path) -> Result<(), String> {
    for file in STUDIED {
        let to = root().join(SAMPLE).join(file);
        let failed = |error: std::io::Error| format!("{}: {error}", to.display());
        std::fs::create_dir_all(to.parent().unwrap_or(&to)).map_err(failed)?;
        let text = std::fs::read_to_string(run.join(file)).map_err(failed)?;
        // The fifth column is the measure.
        let is_unused = |line: &&str| {
            let measure = line.splitn(5, ',').nth(4).unwrap_or_default().trim_start_matches('"');
            UNUSED.iter().any(|unused| measure.starts_with(unused))
        };
        let is_kept = |line: &&str| !file.ends_with("/compare.csv") || !is_unused(line);
        let kept: String = text.lines().filter(is_kept).flat_map(|line| [line, "\n"]).collect();
        std::fs::write(&to, kept).map_err(failed)?;
    }
    Ok(())
}
