//! The sample report: what the tool says of the embedded and the fetched suites, in `reports/sample` and in README.

#[cfg(test)]
mod agrees;

use std::path::Path;
use std::process::Command;

use crate::steps::{cargo, fresh, root, step, target_directory};

/// Where the runs are made, beside the build.
const WORK: &str = "target/sample";
/// Where the sample is kept.
const SAMPLE: &str = "reports/sample";
/// What `corpus list` says of suites whose data have to be fetched.
const FETCHED: &str = "(needs `predicament corpus fetch`)";

/// Runs, times and compares everything, writes the report, and puts what is kept of it into the sample and README.
pub fn make() -> Result<(), String> {
    let work = fresh(WORK)?;
    let path = |name: &str| work.join(name).display().to_string();
    let (run, fetched, bench, report) = (path("run"), path("fetched"), path("bench"), path("report"));
    cargo("build the tool", &["build", "--release"])?;
    let program = target_directory()?.join("release").join("predicament").display().to_string();
    let words =
        |args: &[&str]| -> Vec<String> { [program.as_str()].iter().chain(args).map(|&word| word.to_owned()).collect() };
    let tool = |what: &str, args: &[&str]| step(what, &words(args), &[]);
    tool("fetch real data", &["corpus", "fetch", "--quiet"])?;
    tool("run the embedded suites", &["run", "--out", &run])?;
    let suites = fetched_suites(&program)?;
    let all: Vec<&str> =
        ["run"].into_iter().chain(suites.iter().map(String::as_str)).chain(["--out", &fetched]).collect();
    tool("run the fetched suites", &all)?;
    tool("time the backends", &["bench", "--judged", &run, "--out", &bench])?;
    tool("compare the backends", &["compare", "--quiet", "--out", &format!("{run}/compare")])?;
    tool("turn the knobs", &["stress", "--quiet", "--out", &format!("{run}/stress")])?;
    let readme = root().join("README.md").display().to_string();
    tool("write the report", &["report", &run, &fetched, &bench, "--out", &report, "--splice", &readme])?;
    let picture = root().join(SAMPLE).join("kettner.png").display().to_string();
    tool(
        "draw a pixel map",
        &["map", "kettner-pixels-a", "-b", "naive,naive:first,exact,tolerance", "--out", &picture],
    )?;
    keep(Path::new(&report))
}

/// The suites whose data have to be fetched.
fn fetched_suites(program: &str) -> Result<Vec<String>, String> {
    let output =
        Command::new(program).args(["corpus", "list"]).output().map_err(|error| format!("corpus list: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    let lines = text.lines().filter(|line| line.contains(FETCHED));
    let suites: Vec<String> = lines.filter_map(|line| line.split_whitespace().next().map(str::to_owned)).collect();
    if suites.is_empty() { Err("corpus list names no suite that has to be fetched".to_owned()) } else { Ok(suites) }
}

/// Replaces the sample by what a forge shows of the report: the page in Markdown, its plots, and the figures.
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
    println!("\n{SAMPLE} and the table of README are new; commit them together");
    Ok(())
}
