//! `selftest`: plants faults and sees whether they are caught.
//!
//! Each faulty backend claims a real contract and runs through the embedded
//! corpora like any other; each faulty algorithm runs on an honest backend. A
//! fault names the checks that have to find it: one that finds nothing means that
//! the corpora have a hole or that the check does not work, whatever else finds
//! the fault. The real backends of proved contracts run on every scene on which a
//! check finds what it has to, and must come out clean, or the score would mean nothing.
//! That they are clean on all others is for `run` and `gate` to say, but for the one that
//! is not among the backends of a run: it is run on every scene that it is for.

use std::collections::{BTreeMap, BTreeSet};

use predicament_corpus::Level;
use predicament_oracle::faults::Fault;
use predicament_tasks::{AnyCase, Catch, Class, Contestant, Outcome, Stop, Watch};
use rayon::prelude::*;
use serde_json::json;

use crate::exit::{self, Failure};
use crate::out::program;
use crate::select::Selector;
use crate::tool::Tool;
use crate::{expectations, interrupt, progress};

const EXAMPLES: &str = "\
A fault runs until all checks that have to find it have found it; what else would find it later is not tried. Honest
backends run on each scene that a check finds a fault on, sos:per-mesh on each with two meshes; `run` and `gate` hold
the others to all scenes.

Examples:
  predicament selftest
  predicament selftest --list                      the faults, and the checks that have to find them
  predicament selftest --only algorithm:closed-interval,fault:contacts-one-sided
  predicament selftest -f kettner                  which faults does one part of the corpora catch?
  predicament run -b fault:sos-swapped-term        a planted fault in a run of its own; `gate` turns red";

/// Backends that must have no finding but the expected ones.
const CLEAN: [&str; 5] = ["exact", "sos", "sos:edelsbrunner-mucke", TWO_MESHES, "tolerance"];

/// The one of them that no run has unless it is named: it is held to every scene with two meshes here.
const TWO_MESHES: &str = "sos:per-mesh";

/// Plant faults in backends and algorithms; each must be caught by its checks
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Only scenes whose `suite/scene` matches this regular expression; a fault is then
    /// caught by any finding
    #[arg(short = 'f', long = "filter", value_name = "RE")]
    pub filter: Option<String>,

    /// Only these faults by name, several with commas
    #[arg(long, value_name = "FAULT", value_delimiter = ',')]
    pub only: Vec<String>,

    /// Name the faults and the checks that have to find them, and stop
    #[arg(long)]
    pub list: bool,

    /// Print one JSON object a line: name, verdict, checks
    #[arg(long)]
    pub json: bool,
}

/// What is planted, or nothing in an honest backend, and what was found.
struct Entry {
    name: String,
    what: &'static str,
    /// None for an honest backend.
    caught_by: Option<&'static [Catch]>,
    /// What is planted in a backend.
    fault: Option<Fault>,
    caught: BTreeMap<(Class, String), u64>,
}

impl Entry {
    fn new(name: String, what: &'static str, caught_by: Option<&'static [Catch]>) -> Entry {
        Entry { name, what, caught_by, fault: None, caught: BTreeMap::new() }
    }

    fn note(&mut self, outcome: &Outcome, known: &BTreeSet<(Class, String)>) {
        for catch in catches(outcome).filter(|catch| !known.contains(catch)) {
            *self.caught.entry(catch).or_default() += 1;
        }
    }

    /// Whether it is a fault that is run on the next scene: until all its checks have found it.
    fn is_open(&self) -> bool {
        self.caught_by.is_some() && (self.caught.is_empty() || !self.missed().is_empty())
    }

    /// Whether it is a backend with a fault that is run on the next scene of this task.
    fn is_open_in(&self, task: &str) -> bool {
        self.fault.is_some_and(|fault| fault.shows_in(task)) && self.is_open()
    }

    /// Whether an outcome has a catch that is missed so far.
    fn gains(&self, outcome: &Outcome) -> bool {
        let caught_by = self.caught_by.unwrap_or_default();
        self.caught.is_empty() && catches(outcome).next().is_some()
            || catches(outcome).any(|catch| {
                let is_wanted = caught_by.iter().any(|&(class, check)| (class, check) == (catch.0, catch.1.as_str()));
                is_wanted && !self.caught.contains_key(&catch)
            })
    }

    /// The checks that should have found it and did not.
    fn missed(&self) -> Vec<String> {
        let caught_by = self.caught_by.unwrap_or_default();
        let missed =
            caught_by.iter().filter(|(class, check)| !self.caught.contains_key(&(*class, (*check).to_owned())));
        missed.map(|(class, check)| format!("{class} ({check})")).collect()
    }
}

/// Honest backends, faulty backends, faulty algorithms, in this order.
fn entries(tool: &Tool) -> Vec<Entry> {
    let honest = CLEAN.iter().map(|name| Entry::new((*name).to_owned(), "nothing is wrong", None));
    let backend = |fault: Fault| {
        let name = format!("fault:{}", fault.name());
        Entry { fault: Some(fault), ..Entry::new(name, fault.what(), Some(fault.caught_by())) }
    };
    let backends = Fault::planted().map(backend);
    let mut entries: Vec<Entry> = honest.chain(backends).collect();
    for planted in tool.tasks().iter().flat_map(|task| task.planted_faults()) {
        let name = algorithm(planted.name());
        // Tasks of one family share their algorithm and so its faults.
        if entries.iter().all(|entry| entry.name != name) {
            entries.push(Entry::new(name, planted.what(), Some(planted.caught_by())));
        }
    }
    entries
}

fn algorithm(fault: &str) -> String {
    format!("algorithm:{fault}")
}

/// Class and check of all findings but refusals.
fn catches(outcome: &Outcome) -> impl Iterator<Item = (Class, String)> {
    let findings = outcome.findings.iter().filter(|finding| finding.class != Class::Declined);
    findings.map(|finding| (finding.class, finding.check.clone()))
}

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    let mut entries = entries(tool);
    if !args.only.is_empty() {
        if let Some(unknown) = args.only.iter().find(|name| entries.iter().all(|entry| entry.name != **name)) {
            let message = format!("no fault is called `{unknown}`; `{} selftest --list` names them", program());
            return Err(Failure::usage(message));
        }
        entries.retain(|entry| entry.caught_by.is_none() || args.only.contains(&entry.name));
    }
    if args.list {
        for entry in entries.iter().filter(|entry| entry.caught_by.is_some()) {
            say!("{:<31} {}", entry.name, entry.what);
            say!("{:<31} caught by {}", "", entry.missed().join(", "));
        }
        return Ok(exit::OK);
    }
    let is_whole = args.filter.is_none();
    let selector = Selector { filter: args.filter, ..Selector::everything() };
    let selection = selector.select(tool)?;
    let mut scenes = selection.plan()?;
    let backends = entries.iter().filter(|entry| !is_algorithm(&entry.name));
    let contestants: Result<Vec<Box<dyn Contestant>>, String> =
        backends.map(|entry| tool.backend(&entry.name)).collect();
    let contestants = contestants.map_err(Failure::usage)?;
    let expected = expectations::load(tool, None)?;
    interrupt::listen();
    let bar = progress::bar(scenes.len() as u64, "scenes");
    let quiet = |_: u64| {};
    let interrupted = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    for scene in &mut scenes {
        bar.inc(1);
        let planted = tool.task(scene.plan.task.as_str()).planted_faults();
        let open = |name: &str| entries.iter().any(|entry| entry.name == name && entry.is_open());
        let is_needed = entries.iter().any(|entry| entry.is_open_in(&scene.plan.task))
            || planted.iter().any(|planted| open(&algorithm(planted.name())));
        let loaded = scene.take(&selection)?;
        let has_two = loaded.scene.second_mesh().is_some();
        if !is_needed && !has_two {
            continue;
        }
        let watch = Watch::new(interrupt::flag(), None, &quiet);
        let case = tool.task(loaded.task).case(&loaded, &watch).map_err(interrupted)?;
        let found = faulty(case.as_ref(), &contestants, &watch, &entries).map_err(interrupted)?;
        let gains = found.iter().any(|(at, outcome)| entries[*at].gains(outcome));
        let is_held = |entry: &Entry| entry.caught_by.is_none() && (gains || has_two && entry.name == TWO_MESHES);
        let honest = run_backends(case.as_ref(), &contestants, &watch, &entries, is_held).map_err(interrupted)?;
        // What an honest backend is known to show catches no fault.
        let mut known: BTreeSet<(Class, String)> = BTreeSet::new();
        for (at, outcome) in honest {
            let entry = &mut entries[at];
            let of = |class| {
                let mut of = expected.matching(&loaded.suite, &loaded.name, &entry.name, Level::Quick.name());
                of.any(|entry| entry.class == class)
            };
            let expected: BTreeSet<_> = catches(&outcome).filter(|&(class, _)| of(class)).collect();
            entry.note(&outcome, &expected);
            known.extend(expected);
        }
        // Without a gain nothing was held against the honest ones, and nothing is missed.
        for (at, outcome) in found.into_iter().filter(|_| gains) {
            entries[at].note(&outcome, &known);
        }
    }
    bar.finish_and_clear();
    Ok(scorecard(&entries, is_whole, args.json))
}

/// What became of entries, by their places.
type Found = Vec<(usize, Outcome)>;

fn is_algorithm(name: &str) -> bool {
    name.starts_with("algorithm:")
}

/// The backends of these entries, which come first.
fn run_backends(
    case: &dyn AnyCase,
    contestants: &[Box<dyn Contestant>],
    watch: &Watch,
    entries: &[Entry],
    which: impl Fn(&Entry) -> bool + Sync,
) -> Result<Found, Stop> {
    let budget = crate::planning::budget(Level::Quick);
    let chosen = contestants.par_iter().enumerate().filter(|(at, _)| which(&entries[*at]));
    chosen.map(|(at, one)| Ok((at, predicament_oracle::run(case, one.as_ref(), budget, watch)?))).collect()
}

/// Backends with a fault, and the algorithm of the scene's task with each of its faults: those that are open.
fn faulty(
    case: &dyn AnyCase,
    contestants: &[Box<dyn Contestant>],
    watch: &Watch,
    entries: &[Entry],
) -> Result<Found, Stop> {
    let mut found = run_backends(case, contestants, watch, entries, |entry| entry.is_open_in(case.task().name()))?;
    for planted in case.task().planted_faults() {
        let name = algorithm(planted.name());
        let Some(at) = entries.iter().position(|entry| entry.name == name && entry.is_open()) else { continue };
        let honest = contestants.iter().find(|contestant| contestant.name() == planted.backend());
        let honest = honest.unwrap_or_else(|| panic!("{} runs on no honest backend", planted.name()));
        let budget = crate::planning::budget(Level::Quick);
        found.push((at, predicament_oracle::run_planted(case, planted.as_ref(), honest.as_ref(), budget, watch)?));
    }
    Ok(found)
}

fn scorecard(entries: &[Entry], is_whole: bool, as_json: bool) -> u8 {
    let mut holes = 0;
    for entry in entries {
        let missed = if is_whole { entry.missed() } else { Vec::new() };
        let (good, verdict) = match (entry.caught_by, entry.caught.is_empty()) {
            (None, true) => (true, "clean"),
            (None, false) => (false, "NOT CLEAN"),
            (Some(_), true) => (false, "NOT CAUGHT"),
            (Some(_), false) if missed.is_empty() => (true, "caught"),
            (Some(_), false) => (false, "MISSED BY"),
        };
        holes += usize::from(!good);
        let by: Vec<String> = match verdict {
            "MISSED BY" => missed,
            _ => entry.caught.keys().map(|(class, check)| format!("{class} ({check})")).collect(),
        };
        if as_json {
            say!("{}", json!({ "name": entry.name, "verdict": verdict, "good": good, "checks": by }));
        } else {
            say!("{:<31} {verdict:<11} {}", entry.name, by.join(", "));
        }
    }
    if !as_json {
        say!("{} of {} as they should be", entries.len() - holes, entries.len());
    }
    if holes == 0 { exit::OK } else { exit::UNEXPECTED }
}
