//! `replay`: one finding again, asked alone, with all that can be told about it.

use std::path::{Path, PathBuf};

use predicament_corpus::{Level, LoadedScene, Task, hexfloat};
use predicament_judge as judge;
use predicament_oracle::{Case, Contestant, Truth, Watch};
use predicament_predicates::{Axis, Plane, Question, Vertex};
use predicament_report::{FindingRow, RunDir};

use crate::exit::{self, Failure};
use crate::select::Selector;
use crate::{interrupt, roster};

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

    /// Where fetched data lie; $PREDICAMENT_CACHE or the user's cache if left out
    #[arg(long, value_name = "DIR")]
    pub cache: Option<PathBuf>,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    let run = RunDir::open(&args.run).map_err(Failure::usage)?;
    let finding = find(&run, &args.id, &args.run)?;
    let loaded = load(&run, finding, args)?;
    println!("finding   {} ({})", finding.finding_id, finding.class.name());
    println!("scene     {}/{} ({})", finding.suite, finding.scene, finding.scene_id);
    for (key, text) in [("source", &loaded.source), ("analysis", &loaded.analysis)] {
        if !text.is_empty() {
            println!("{key:<9} {text}");
        }
    }
    println!("backend   {}", finding.backend);
    println!("check     {}", finding.check);
    println!("got       {}", finding.got);
    if !finding.truth.is_empty() {
        println!("truth     {}", finding.truth);
    }
    if finding.query.is_empty() {
        println!("\nThis finding is about the whole scene; run it again with -f '{}'.", finding.scene);
        return Ok(exit::OK);
    }
    let mut names = vec![finding.backend.clone()];
    names.extend(roster::pick(&args.backends)?.iter().map(|backend| backend.name()));
    let backends = roster::pick(&names)?;
    for query in finding.query.split(" | ") {
        println!("\n{query}");
        let about = |task: Task| {
            query
                .strip_prefix(task.name())
                .and_then(|rest| rest.strip_prefix('('))
                .and_then(|rest| rest.strip_suffix(')'))
        };
        if let Some(id) = about(Task::Interval) {
            ask_cells(&loaded, parse_ids(id)?[0], &backends)?;
        } else if let Some(id) = about(Task::PolygonLocate) {
            ask_location(&loaded, parse_ids(id)?[0], &backends)?;
        } else if let Some(pair) = about(Task::Contacts2d).or(about(Task::Contacts3d)) {
            ask_contact(&loaded, pair, &backends)?;
        } else {
            let (question, ids) = parse(query)?;
            ask_sign(&loaded, question, &ids, &backends);
        }
    }
    Ok(exit::OK)
}

fn find<'a>(run: &'a RunDir, id: &str, folder: &Path) -> Result<&'a FindingRow, Failure> {
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

fn load(run: &RunDir, finding: &FindingRow, args: &Args) -> Result<LoadedScene, Failure> {
    let level: Level = run.plan.level.to_string().parse().map_err(Failure::usage)?;
    let suites = vec![finding.suite.clone()];
    let selection = Selector { suites, filter: None, level, cache: args.cache.clone() }.select()?;
    let Some(def) = selection.defs().into_iter().find(|def| def.name == finding.scene) else {
        return Err(Failure::nothing(format!("suite `{}` has no scene `{}` any more", finding.suite, finding.scene)));
    };
    let loaded = selection.load(def)?;
    if loaded.id != finding.scene_id {
        return Err(Failure::usage(format!(
            "scene {}/{} has changed since the run ({} then, {} now); run it again",
            finding.suite, finding.scene, finding.scene_id, loaded.id
        )));
    }
    Ok(loaded)
}

/// Reads a query as [`Question::describe`](predicament_predicates::Question::describe) writes it.
fn parse(query: &str) -> Result<(Question, Vec<Vertex>), Failure> {
    let bad = || Failure::usage(format!("`{query}` is no query; the run's findings.csv was changed"));
    let (kind, rest) = query.strip_suffix(')').and_then(|text| text.split_once('(')).ok_or_else(bad)?;
    let (detail, ids) = rest.split_once("; ").unwrap_or(("", rest));
    let question = match (kind, detail) {
        ("compare", "x") => Question::Compare(Axis::X),
        ("compare", "y") => Question::Compare(Axis::Y),
        ("compare", "z") => Question::Compare(Axis::Z),
        ("orient2d", "xy") => Question::Orient2d(Plane::Xy),
        ("orient2d", "yz") => Question::Orient2d(Plane::Yz),
        ("orient2d", "zx") => Question::Orient2d(Plane::Zx),
        ("orient3d", "") => Question::Orient3d,
        ("incircle", "") => Question::Incircle,
        ("insphere", "") => Question::Insphere,
        _ => return Err(bad()),
    };
    let ids = parse_ids(ids)?;
    if ids.len() == question.kind().arity() { Ok((question, ids)) } else { Err(bad()) }
}

fn parse_ids(text: &str) -> Result<Vec<Vertex>, Failure> {
    let ids: Result<Vec<Vertex>, _> = text.split(' ').map(str::parse).collect();
    ids.map_err(|_| Failure::usage(format!("`{text}` is no list of vertices; findings.csv was changed")))
}

fn print_points(loaded: &LoadedScene, ids: &[Vertex]) {
    for &id in ids {
        if let Some(construction) = loaded.scene.construction(id) {
            println!("  vertex {:>8}  {construction}", id.to_string());
            let defining: Vec<Vertex> = construction.flats().flatten().copied().collect();
            print_points(loaded, &defining);
            continue;
        }
        let point = loaded.scene.point(id);
        let decimal: Vec<String> = point.iter().map(|x| format!("{x:?}")).collect();
        let hex: Vec<String> = point.iter().map(|&x| hexfloat::format(x)).collect();
        println!("  vertex {:>8}  ({})  = ({})", id.to_string(), decimal.join(", "), hex.join(", "));
    }
}

fn ask_sign(loaded: &LoadedScene, question: Question, ids: &[Vertex], backends: &[Box<dyn Contestant>]) {
    print_points(loaded, ids);
    let verdict = judge::verdict(&loaded.scene, question, ids);
    let degeneracy = judge::log2_relative(&verdict).map_or_else(|| "exactly zero".to_owned(), |x| format!("2^{x:.2}"));
    println!("  exact sign {}, |det| / permanent {degeneracy}", verdict.sign());
    println!("  {:<24} {:<5} {:<14} {:<24} band (lower, width, upper)", "backend", "sign", "stage", "estimate");
    for backend in backends {
        match backend.explain(&loaded.scene, question, ids) {
            Ok(told) => {
                let estimate = told.estimate.map_or_else(String::new, |x| format!("{x:e}"));
                let band = told.band.map_or_else(String::new, |band| band.map(|x| format!("{x:e}")).join(", "));
                let stage = told.stage.unwrap_or_default();
                println!("  {:<24} {:<5} {stage:<14} {estimate:<24} {band}", backend.name(), told.sign.to_string());
            }
            Err(why) => println!("  {:<24} {why}", backend.name()),
        }
    }
    println!("  query: {}", question.describe(ids));
}

/// Works out the truth about the scene again.
fn case_of(loaded: &LoadedScene) -> Result<Case<'_>, Failure> {
    let quiet = |_: u64| {};
    let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    Case::new(loaded, &Watch::new(interrupt::flag(), None, &quiet)).map_err(stopped)
}

/// What each backend says about something.
fn print_answers(backends: &[Box<dyn Contestant>], ask: impl Fn(&dyn Contestant) -> Result<String, String>) {
    for backend in backends {
        let answer = ask(backend.as_ref()).unwrap_or_else(|why| why);
        println!("  {:<24} {answer}", backend.name());
    }
}

fn ask_cells(loaded: &LoadedScene, id: Vertex, backends: &[Box<dyn Contestant>]) -> Result<(), Failure> {
    print_points(loaded, &[id]);
    let case = case_of(loaded)?;
    let Truth::Interval(case) = case.truth() else {
        return Err(Failure::usage("the scene has no cells any more"));
    };
    print_answers(backends, |backend| backend.cells_of_one(case, id));
    Ok(())
}

fn ask_location(loaded: &LoadedScene, id: Vertex, backends: &[Box<dyn Contestant>]) -> Result<(), Failure> {
    print_points(loaded, &[id]);
    let case = case_of(loaded)?;
    let Truth::Locate(case) = case.truth() else {
        return Err(Failure::usage("the scene is no map any more"));
    };
    print_answers(backends, |backend| backend.locate_one(case, id));
    Ok(())
}

fn ask_contact(loaded: &LoadedScene, pair: &str, backends: &[Box<dyn Contestant>]) -> Result<(), Failure> {
    let (s, t) = pair.split_once(", ").ok_or_else(|| Failure::usage(format!("`{pair}` is no pair of simplices")))?;
    let (s, t) = (parse_ids(s)?, parse_ids(t)?);
    let case = case_of(loaded)?;
    let Truth::Contacts(case) = case.truth() else {
        return Err(Failure::usage("the scene asks for no contacts any more"));
    };
    let pair = case.find(&s, &t).map_err(Failure::usage)?;
    print_points(loaded, &[s, t].concat());
    println!("  {:<24} {}", "truth", case.truth_about(pair));
    print_answers(backends, |backend| backend.contact(case, pair));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn queries_read_back_as_they_are_written() {
        let [a, b, c, d] = [3, 1, 0, 5].map(Vertex::input);
        let ids = [a, b, Vertex::constructed(4), c, d];
        for question in [
            Question::Compare(Axis::Z),
            Question::Orient2d(Plane::Zx),
            Question::Orient3d,
            Question::Incircle,
            Question::Insphere,
        ] {
            let ids = &ids[..question.kind().arity()];
            let (parsed, parsed_ids) = parse(&question.describe(ids)).unwrap();
            assert_eq!((parsed, parsed_ids.as_slice()), (question, ids));
        }
        for broken in [
            "",
            "orient2d",
            "orient2d(xy; 1 2)",
            "orient2d(xy; 1 2 d3)",
            "orient3d(xy; 1 2 3 4)",
            "compare(w; 1 2)",
            "incircle(1 2 3 x)",
        ] {
            assert!(parse(broken).is_err(), "{broken}");
        }
    }
}
