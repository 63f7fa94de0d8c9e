//! `report`: writes pages from run folders.

use std::path::{Path, PathBuf};

use predicament_records::{RunDir, replace};
use predicament_report::{Section, against, ranking, sources, splice, write_pages};
use predicament_studies::{ablation, compare, stress};

use crate::citing;
use crate::details::details;
use crate::exit::{self, Failure};
use crate::out::hold;
use crate::places::apart;
use crate::progress;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament report out/run --out out/report
  predicament report out/run out/bench --out out/report    errors and timings on one page
  predicament study compare --out out/run/compare                then every report of out/run has the table of backends
  predicament study stress --out out/run/stress                  and where they break
  predicament report out/run --baseline out/main --out out/report   what changed since an earlier run
  predicament report out/run --splice README.md             the same tables in a page of your own
  predicament report out/run out/compare --out out/report  with the comparison of backends that `compare` has written elsewhere";

/// Write a report of runs: one HTML page, Markdown, plots, figures as CSV
///
/// If several folders have the same scene and backend, the first folder counts. If the folders disagree, that is an
/// error.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Folders written by `run` or `bench`; if several have the same pair of scene and backend, the first counts.
    /// Folders written by `compare` and `stress` add their sections, as do RUN/compare and RUN/stress
    #[arg(required = true, value_name = "RUN")]
    pub runs: Vec<PathBuf>,

    /// The folder for the pages; files of an earlier report are replaced
    #[arg(long, value_name = "DIR", default_value = "predicament-report")]
    pub out: PathBuf,

    /// One or more earlier runs; the page shows changes since then in scenes, classes and times
    #[arg(long, value_name = "RUN")]
    pub baseline: Vec<PathBuf>,

    /// Put sections into a Markdown page, between `<!-- predicament: SECTION -->` and `<!-- /predicament -->`; `SECTION
    /// tables` is only its tables, and `which PART` a part of docs/WHICH.md, made from the studies in RUN/compare,
    /// RUN/curves, RUN/stress, RUN/cut, RUN/parity and RUN/parity-space
    #[arg(long, value_name = "FILE")]
    pub splice: Vec<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let _working = progress::working("making the report");
    let (mut folders, mut compared) = (Vec::new(), Vec::new());
    for folder in &args.runs {
        let of_studies = studied(folder)?;
        if of_studies.is_empty() || folder.join("plan.json").exists() {
            folders.push(folder.clone());
        } else {
            compared.extend(of_studies);
        }
    }
    if folders.is_empty() {
        return Err(Failure::usage(
            "the folders do not have a run; also name a folder that `run` or `bench` has written",
        ));
    }
    let runs: Vec<&Path> = folders.iter().chain(&args.baseline).map(|folder| &**folder).collect();
    apart(&[("--out", &args.out)], &[], &runs)?;
    for folder in &folders {
        for place in [folder.clone(), folder.join(COMPARISON), folder.join(STRESS), folder.join(ABLATION)] {
            for section in studied(&place)? {
                if compared.iter().all(|other: &Section| other.id != section.id) {
                    compared.push(section);
                }
            }
        }
    }
    if compared.iter().all(|section| section.id != COMPARISON) {
        compared.push(compare::missing(&folders[0].join(COMPARISON)));
    }
    compared.push(compare::decision());
    let runs = RunDir::open_all(&folders).map_err(Failure::usage)?;
    for warning in runs.iter().flat_map(|run| &run.warnings) {
        note!("{warning}");
    }
    compared.extend(tool.sections(&runs).map_err(Failure::usage)?);
    compared.extend(sources(&citing::sources(&runs, tool).named));
    let (told, missing) = details(&runs, tool)?;
    if missing > 0 {
        note!("the page shows {missing} findings without their points: their queries cannot be repeated alone");
    }
    if !args.baseline.is_empty() {
        let earlier = RunDir::open_all(&args.baseline).map_err(Failure::usage)?;
        compared.push(against(&runs, &earlier).map_err(Failure::usage)?);
    }
    let with_studies = folders.iter().find(|folder| folder.join(COMPARISON).exists()).unwrap_or(&folders[0]);
    // All pages are made before any page is written.
    let mut spliced = Vec::new();
    for (at, page) in args.splice.iter().enumerate() {
        if args.splice[..at].contains(page) {
            continue;
        }
        let named = |why: String| Failure::usage(format!("{}: {why}", page.display()));
        let hold = hold(page)?;
        let text = std::fs::read_to_string(page).map_err(|why| named(why.to_string()))?;
        let part = |name: &str| compare::part(with_studies, name).map(|made| made.map_err(|why| why.to_string()));
        let (text, _) = splice(&text, &runs, &compared, &part).map_err(|why| named(why.message))?;
        spliced.push((page, text, hold));
    }
    write_pages(&runs, &compared, &told, &args.out).map_err(Failure::usage)?;
    for (page, text, _hold) in spliced {
        replace(page, text.as_bytes()).map_err(Failure::usage)?;
        note!("{} has the sections that its marks name", page.display());
    }
    say!("{}", ranking(&runs));
    say!("{}", args.out.join("report.html").display());
    Ok(exit::OK)
}

/// The sections that studies wrote into a folder.
fn studied(folder: &Path) -> Result<Vec<Section>, Failure> {
    let sections = [compare::section(folder), stress::section(folder), ablation::section(folder)];
    sections.into_iter().filter_map(|section| section.map_err(Failure::usage).transpose()).collect()
}

/// The folder of a stress study inside a run's folder.
const STRESS: &str = "stress";
/// The folder of an ablation inside a run's folder.
const ABLATION: &str = "ablation";
/// The folder of a comparison inside a run's folder, and the name of its section.
const COMPARISON: &str = "compare";
