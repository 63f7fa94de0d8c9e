//! `engines doctor`: which settings of the compiler break which predicate of an engine.

mod settings;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_engines::{Config, Engine, EngineError, FILE, PREFIX, Step, chore, find};
use predicament_formats::{Cache, Manifest};
use predicament_predicates::Class;
use predicament_search::shrink::{Limits, shrink};
use predicament_search::{Backends, Wanted};
use predicament_tasks::{AnyCase, Budget, Contestant, Finding, Outcome, Stop, Watch};
use rayon::prelude::*;
use regex::Regex;

use crate::exit::{self, Failure};
use crate::shared::set_threads;
use crate::temporary::Temporary;
use crate::told::point_lines;
use crate::tool::Tool;
use crate::{interrupt, progress};
use settings::{ROUNDING, Setting};

const EXAMPLES: &str = "\
The engine is built in a temporary copy of its folder, once with its own commands and once with each setting: \
optimisation, -ffast-math, contraction to fused operations, x87, link-time optimisation and rounding modes for C and \
C++, with clang too if it is there; profiles and target-cpu for Rust. Each build answers small scenes of the embedded \
families. A setting breaks a predicate if it is wrong in a family that the engine's own build answers right. The exit \
code is 100 then, and 0 otherwise.

Examples:
  predicament engines doctor mine
  predicament engines doctor mine/engine.toml --settings 'fast|native'   some settings only
  predicament engines doctor mine --format csv > doctor.csv
  predicament engines doctor mine --keep                                  the builds stay, for a debugger";

/// Build an engine with many compiler settings, and say which of them break a predicate
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The engine, by name or file
    name: String,

    /// Only settings whose name matches this regular expression
    #[arg(long, value_name = "RE")]
    settings: Option<String>,

    /// The output format
    #[arg(long, value_enum, default_value = "text")]
    format: Format,

    /// Keep the folder with the builds
    #[arg(long)]
    keep: bool,

    /// The number of builds at a time; default: all cores
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug, clap::ValueEnum)]
enum Format {
    Text,
    Md,
    Csv,
}

/// The families of the scenes, with the keys of a suite.
const FAMILIES: [(&str, &str); 8] = [
    ("uniform", "n = 200\nseed = 1"),
    ("grid", "n = 200\nseed = 2"),
    ("near", "n = 400\nseed = 3\nulps = 4"),
    ("kettner", "n = 400\nseed = 4"),
    ("degen", "n = 400\nseed = 5"),
    ("wide-scaled", "n = 200\nseed = 6"),
    ("wide-mixed", "n = 200\nseed = 7"),
    ("far", "n = 400\nseed = 8"),
];
/// The predicates that have scenes.
const PREDICATES: [&str; 5] = ["compare", "orient2d", "orient3d", "incircle", "insphere"];
/// The maximum number of scenes that shrinking one case evaluates.
const EVALUATIONS: u64 = 1_000;
/// Signs are compared with the truth; laws between answers are not checked.
const BUDGET: Budget = Budget { permutations: 0, relations: 0, ..Budget::QUICK };
/// Folders that are not copied: outputs of builds.
const OUTPUTS: [&str; 4] = ["target", "venv", "node_modules", ".git"];

/// The scenes of one predicate.
struct Scenes<'a> {
    predicate: &'a str,
    cases: Vec<Box<dyn AnyCase + 'a>>,
}

/// The answers of a build to one predicate, by scene, against those of the engine's own build.
#[derive(Default)]
struct Cell {
    queries: u64,
    wrong: u64,
    declined: u64,
    crashes: u64,
    /// The scenes that only the engine's own build answers right.
    broken: Vec<usize>,
    /// The smallest case: answer and truth, then coordinates.
    case: Vec<String>,
}

/// A setting: a cell for each predicate, or the reason why there is no build.
type Line = (String, Result<Vec<Cell>, String>);

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let config = find(&args.name).map_err(Failure::usage)?;
    let has_clang = std::process::Command::new("clang").arg("--version").output().is_ok();
    let mut settings = Setting::of(&config.build, has_clang);
    if settings.is_empty() {
        let message = format!("{}: its build calls no compiler of C, C++ or Rust", config.file.display());
        return Err(Failure::usage(format!("{message}; name another engine, or call c++, cc or cargo in `build`")));
    }
    if let Some(text) = &args.settings {
        let wanted = Regex::new(text).map_err(|error| Failure::usage(format!("--settings: {error}")))?;
        let names: Vec<String> = settings.iter().map(Setting::name).collect();
        settings.retain(|setting| wanted.is_match(&setting.name()));
        if settings.is_empty() {
            return Err(Failure::nothing(format!("no setting matches `{text}`; choose from {}", names.join("; "))));
        }
    }
    set_threads(args.threads)?;
    interrupt::listen_for_all();
    let root = Temporary::new("predicament-doctor").map_err(Failure::usage)?;
    let working = progress::working("building the engine with its own settings");
    let own = built(&config, &Setting::Own, &root.path.join("own")).map_err(Failure::usage)?;
    let engine = Engine::start(Config::read(&own).map_err(Failure::usage)?).map_err(Failure::usage)?;
    let offered = engine.predicates().iter().map(|kind| kind.name());
    let (predicates, rest): (Vec<&str>, Vec<&str>) = offered.partition(|name| PREDICATES.contains(name));
    drop(engine);
    if !rest.is_empty() {
        note!("not tested, because there are no scenes: {}", rest.join(", "));
    }
    let own = contestant(tool, &own).map_err(Failure::usage)?;
    let watch = Watch::new(interrupt::flag(), None, &|_| {});
    let loaded = predicates.iter().map(|predicate| scenes(tool, predicate)).collect::<Result<Vec<_>, _>>()?;
    let interrupted = |_: Stop| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    let all = predicates.iter().zip(&loaded).map(|(predicate, loaded)| {
        let cases = loaded.iter().map(|loaded| tool.task(predicate).case(loaded, &watch)).collect::<Result<_, _>>();
        cases.map(|cases| Scenes { predicate, cases })
    });
    let all: Vec<Scenes<'_>> = all.collect::<Result<_, _>>().map_err(interrupted)?;
    let right = all.iter().map(|scenes| answers(scenes, own.as_ref(), &watch)).collect::<Result<Vec<_>, _>>();
    let right = right.map_err(interrupted)?;
    working.now(format!("building and asking the engine with {} settings", settings.len()));
    let examined = |(number, setting): (usize, &Setting)| -> Result<Line, Stop> {
        let folder = root.path.join(format!("{number}"));
        let variant = built(&config, setting, &folder).map_err(|error| reason(&error.to_string()));
        let variant = variant.and_then(|file| contestant(tool, &file).map_err(|error| reason(&error)));
        let cells = match variant {
            Err(why) => Err(why),
            Ok(variant) => {
                let cell = |(scenes, right): (&Scenes<'_>, &Vec<Outcome>)| -> Result<Cell, Stop> {
                    let found = answers(scenes, variant.as_ref(), &watch)?;
                    let mut cell = Cell::of(right, &found);
                    if let Some(&at) = cell.broken.first() {
                        cell.case = smallest(tool, scenes, at, &found[at], [variant.as_ref(), own.as_ref()], &watch)?;
                    }
                    Ok(cell)
                };
                Ok(all.iter().zip(&right).map(cell).collect::<Result<_, _>>()?)
            }
        };
        if !args.keep {
            let _ = fs::remove_dir_all(&folder);
        }
        Ok((setting.name(), cells))
    };
    let lines: Result<Vec<Line>, Stop> = settings.par_iter().enumerate().with_max_len(1).map(examined).collect();
    let mut lines = lines.map_err(interrupted)?;
    drop(working);
    lines.insert(0, ("own".to_owned(), Ok(right.iter().map(|row| Cell::of(row, row)).collect())));
    print(&lines, &predicates, args.format);
    if args.keep {
        note!("the builds are in {}", root.path.display());
        std::mem::forget(root);
    }
    let breaks = |line: &&Line| line.1.iter().flatten().any(|cell| !cell.broken.is_empty());
    let (broken, unbuilt) = (lines.iter().filter(breaks).count(), lines.iter().filter(|line| line.1.is_err()).count());
    let unbuilt = if unbuilt == 0 { String::new() } else { format!("; {unbuilt} were not built") };
    note!("{broken} of {} settings break a predicate{unbuilt}", lines.len() - 1);
    Ok(if broken == 0 { exit::OK } else { exit::UNEXPECTED })
}

/// Copies the engine into a folder, with the folders beside it that its commands or its manifest name, and builds it
/// with a setting. Returns the copy's configuration file.
fn built(config: &Config, setting: &Setting, root: &Path) -> Result<PathBuf, EngineError> {
    let unread = |error| EngineError::Unread { file: config.file.clone(), error };
    let beside = config.folder.parent().unwrap_or(Path::new("/"));
    let words = config.build.iter().flatten().chain(&config.run).chain(&config.version).cloned();
    let manifest = fs::read_to_string(config.folder.join("Cargo.toml")).unwrap_or_default();
    let mut names: BTreeSet<PathBuf> = config.folder.file_name().map(PathBuf::from).into_iter().collect();
    for text in words.chain([manifest]) {
        let ends = |c: char| !(c.is_ascii_alphanumeric() || "-_.".contains(c));
        let after = text.split("../").skip(1).filter_map(|rest| rest.split(ends).next());
        names.extend(after.filter(|name| !name.is_empty() && beside.join(name).is_dir()).map(PathBuf::from));
    }
    names.iter().try_for_each(|name| copy(&beside.join(name), &root.join(name))).map_err(unread)?;
    let folder = root.join(config.folder.file_name().unwrap_or_default());
    if let Some(source) = setting.source() {
        fs::write(folder.join(ROUNDING), source).map_err(unread)?;
    }
    let mut copied = config.clone();
    copied.build = config.build.iter().map(|words| setting.applied(words)).collect();
    copied.environment.extend(setting.variables());
    copied.folder = folder.clone();
    chore(&copied, Step::Build, |_| {})?;
    Ok(folder.join(config.file.file_name().unwrap_or(FILE.as_ref())))
}

/// Copies a folder, without outputs of builds.
fn copy(from: &Path, to: &Path) -> std::io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let (path, name) = entry.map(|entry| (entry.path(), entry.file_name()))?;
        if path.is_dir() {
            if !OUTPUTS.iter().any(|output| name == *output) {
                copy(&path, &to.join(name))?;
            }
        } else if path.is_file() {
            fs::copy(&path, to.join(name))?;
        }
    }
    Ok(())
}

fn contestant(tool: &Tool, file: &Path) -> Result<Box<dyn Contestant>, String> {
    tool.backend(&format!("{PREFIX}{}", file.display()))
}

/// The most telling line of an error: the first that says `error`, or the last one.
fn reason(text: &str) -> String {
    let line = text.lines().find(|line| line.contains("error:") || line.contains("error[")).or(text.lines().last());
    line.unwrap_or_default().trim().chars().take(160).collect()
}

/// Small scenes of a predicate, one of each family.
fn scenes(tool: &Tool, predicate: &str) -> Result<Vec<LoadedScene>, Failure> {
    let table = |(family, keys): &(&str, &str)| {
        format!("[[generate]]\nfamily = \"{family}\"\ntask = \"{predicate}\"\n{keys}\n")
    };
    let text = format!("title = \"Doctor\"\n{}", FAMILIES.iter().map(table).collect::<String>());
    let suite = Suite::parse(tool.vocabulary(), "doctor.toml", &text, None, &Manifest::default())?;
    let loaded = suite.scenes.iter().map(|def| def.load(Level::Quick, &Cache::new(""))).collect::<Result<_, _>>();
    Ok(loaded?)
}

fn answers(scenes: &Scenes<'_>, contestant: &dyn Contestant, watch: &Watch<'_>) -> Result<Vec<Outcome>, Stop> {
    scenes.cases.iter().map(|case| predicament_tasks::run(case.as_ref(), contestant, BUDGET, watch)).collect()
}

fn count(outcome: &Outcome, classes: &[Class]) -> u64 {
    classes.iter().map(|&class| outcome.counts.get(class)).sum()
}

const CRASHES: [Class; 2] = [Class::Panic, Class::Timeout];

impl Cell {
    fn of(own: &[Outcome], found: &[Outcome]) -> Cell {
        let wrong: Vec<Class> = Class::ALL.into_iter().filter(|class| class.is_wrong_answer()).collect();
        let bad = |outcome: &Outcome| count(outcome, &wrong) + count(outcome, &CRASHES) > 0;
        let sum = |classes: &[Class]| found.iter().map(|outcome| count(outcome, classes)).sum();
        let broken = found.iter().zip(own).enumerate().filter(|(_, (found, own))| bad(found) && !bad(own));
        Cell {
            queries: found.iter().map(|outcome| outcome.queries).sum(),
            wrong: sum(&wrong),
            declined: sum(&[Class::Declined]),
            crashes: sum(&CRASHES),
            broken: broken.map(|(at, _)| at).collect(),
            case: Vec::new(),
        }
    }

    fn text(&self) -> String {
        let Cell { queries, wrong, declined, crashes, .. } = self;
        let breaks = if self.broken.is_empty() { "" } else { "BREAKS: " };
        match (crashes, wrong, declined) {
            (0, 0, 0) => "right".to_owned(),
            (0, 0, declined) if declined >= queries => "declined".to_owned(),
            (0, 0, declined) => format!("right, {declined} declined"),
            (0, wrong, _) => format!("{breaks}{wrong} wrong of {queries}"),
            (crashes, 0, _) => format!("{breaks}crash in {crashes} of {} scenes", FAMILIES.len()),
            (crashes, wrong, _) => format!("{breaks}{wrong} wrong of {queries}, crash in {crashes} scenes"),
        }
    }
}

/// The smallest case that the build answers wrong and the engine's own build answers right, in lines.
fn smallest(
    tool: &Tool,
    scenes: &Scenes<'_>,
    at: usize,
    found: &Outcome,
    [variant, own]: [&dyn Contestant; 2],
    watch: &Watch<'_>,
) -> Result<Vec<String>, Stop> {
    let told = |finding: &Finding, how: &str| {
        let (family, query) = (FAMILIES[at].0, finding.query_text());
        format!("{query} of {family}: answer {}, truth {}{how}", finding.got, finding.truth)
    };
    let Some(finding) = found.findings.iter().find(|finding| finding.class.is_wrong_answer()) else {
        // A crash: the scene is not shrunk.
        return Ok(found
            .findings
            .iter()
            .take(1)
            .map(|finding| format!("{}: {}", FAMILIES[at].0, finding.got))
            .collect());
    };
    let loaded = scenes.cases[at].loaded();
    let vertices = |finding: &Finding| finding.queries.iter().flat_map(|query| query.vertices()).collect::<Vec<_>>();
    let witness = Backends {
        task: tool.task(scenes.predicate),
        wanted: Wanted::finding(finding.class, &finding.check),
        shown_by: vec![variant],
        not_by: vec![own],
        budget: BUDGET,
        watch,
        limit: None,
    };
    let start = loaded.spelled().filter(|_| !finding.queries.is_empty());
    let limits = Limits { evaluations: EVALUATIONS };
    let shrunk =
        start.map(|start| shrink(tool.vocabulary(), &witness, start, &vertices(finding), limits, 0, &mut |_, _, _| {}));
    let (loaded, finding, how) = match &shrunk {
        Some(Ok(shrunk)) => (&shrunk.loaded, &shrunk.finding, ""),
        _ => (loaded, finding, " (not shrunk)"),
    };
    watch.done(0)?;
    Ok(std::iter::once(told(finding, how)).chain(point_lines(loaded, &vertices(finding))).collect())
}

/// Prints the table, and below it the smallest cases; CSV has a row for each setting and predicate.
fn print(lines: &[Line], predicates: &[&str], format: Format) {
    if format == Format::Csv {
        let quoted = |text: &str| format!("\"{}\"", text.replace('"', "\"\""));
        say!("setting,predicate,result,wrong,queries,breaks,case");
        for (name, cells) in lines {
            for (at, predicate) in predicates.iter().enumerate() {
                let row = match cells {
                    Ok(cells) => {
                        let Cell { wrong, queries, broken, case, .. } = &cells[at];
                        let [text, case] = [cells[at].text(), case.join(" / ")].map(|text| quoted(&text));
                        format!("{text},{wrong},{queries},{},{case}", !broken.is_empty())
                    }
                    Err(why) => format!("{},,,false,", quoted(&format!("not built: {why}"))),
                };
                say!("{},{predicate},{row}", quoted(name));
            }
        }
        return;
    }
    let row = |(name, cells): &Line| -> Vec<String> {
        let texts: Vec<String> = match cells {
            Ok(cells) => cells.iter().map(Cell::text).collect(),
            Err(why) => vec![format!("not built: {}", why.replace('|', "/"))],
        };
        std::iter::once(name.clone()).chain(texts).collect()
    };
    let head: Vec<String> = std::iter::once("setting").chain(predicates.iter().copied()).map(str::to_owned).collect();
    let rows: Vec<Vec<String>> = std::iter::once(head).chain(lines.iter().map(row)).collect();
    let width = |at: usize| {
        let full = rows.iter().filter(|row| row.len() == predicates.len() + 1);
        full.filter_map(|row| row.get(at)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    for (number, row) in rows.iter().enumerate() {
        let cells: Vec<String> = row.iter().enumerate().map(|(at, cell)| format!("{cell:<0$}", width(at))).collect();
        if format == Format::Text {
            say!("{}", cells.join("  ").trim_end());
        } else {
            say!("| {} |", cells.join(" | "));
            if number == 0 {
                say!("|{}", "---|".repeat(row.len()));
            }
        }
    }
    for (name, cells) in lines {
        for (predicate, cell) in predicates.iter().zip(cells.iter().flatten()).filter(|(_, cell)| !cell.case.is_empty())
        {
            say!("\n{name}, {predicate}: {}", cell.case[0]);
            cell.case[1..].iter().for_each(|line| say!("    {line}"));
        }
    }
}
