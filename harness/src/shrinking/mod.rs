//! Shrinks a finding into a folder: the scene as a suite, tests, and the state needed to continue.
//!
//! Each smaller scene is written as soon as it is found, so a kill at any moment loses one evaluation.

mod begun;
mod first;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

use predicament_corpus::{Heading, Level, LoadedScene, Spelled, Suite};
use predicament_engines::PREFIX;
use predicament_formats::Manifest;
use predicament_predicates::{Class, Query, Vertex};
use predicament_records::{EngineFile, replace};
use predicament_search::shrink::{End, Limits, Shrunk, Size, shrink};
use predicament_search::snippets::Subject;
use predicament_search::{Backends, Wanted, Witness};
use predicament_tasks::{Budget, Finding, Stop, Watch};
use serde::{Deserialize, Serialize};

use crate::exit::Failure;
use crate::programs::{Picked, Programs, Recorded};
use crate::select::planned_scene;
use crate::tool::Tool;
use crate::worker::Worker;
use crate::{interrupt, planning};

pub use begun::{Ask, EVALUATIONS, again, begun, told};
pub use first::first_of_each_class;

/// The files of a folder: the state, and the smallest scene so far.
pub const STATE: &str = "shrink.json";
pub const SUITE: &str = "shrunk.toml";
/// The smallest scene as tests.
const TESTS: [&str; 4] = ["shrunk.rs", "shrunk.cpp", "shrunk.py", "shrunk.mjs"];

/// The state of a shrink, written to `shrink.json`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct State {
    /// The id of the finding.
    pub finding_id: String,
    /// The place of the finding: suite, scene, and the scene's id.
    pub suite: String,
    pub scene: String,
    pub scene_id: String,
    pub task: String,
    pub class: String,
    pub check: String,
    /// The names of the backends that have to show the finding, its own backend first.
    pub shown_by: Vec<String>,
    /// The names of the backends that must not show it.
    pub not_by: Vec<String>,
    /// The files and versions of the engines among them.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub engines: BTreeMap<String, EngineFile>,
    pub level: String,
    /// The time limit in seconds of one backend on one scene.
    pub limit: f64,
    /// The number of scenes evaluated, and its maximum.
    pub evaluations: u64,
    pub most: u64,
    /// The reason why it ended, or `None` while it is not finished.
    pub end: Option<String>,
    /// The size of the scene: points, pieces, and digits of the coordinates.
    pub before: Measure,
    pub after: Measure,
}

/// The size of a scene.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct Measure {
    pub points: usize,
    pub pieces: usize,
    pub digits: u64,
}

impl Measure {
    pub fn of(spelled: &Spelled) -> Measure {
        let Size { pieces, digits } = Size::of(spelled);
        let rows = spelled.rows().len();
        Measure { points: rows, pieces, digits }
    }
}

/// A finding and its scene, ready to be shrunk.
pub struct Job<'a> {
    pub tool: &'a Tool,
    /// The initial state.
    pub state: State,
    /// The initial scene: that of the finding, or the smallest so far.
    pub start: Spelled,
    /// The source of the original scene, in words.
    pub source: String,
    /// The vertices that the finding is about.
    pub named: Vec<Vertex>,
    /// The backends that have to show the finding, and those that must not.
    pub backends: [Picked; 2],
}

/// The vertices of queries given as text.
pub fn named(query: &str) -> Vec<Vertex> {
    queries(query).iter().flat_map(|query| query.vertices().collect::<Vec<_>>()).collect()
}

fn queries(text: &str) -> Vec<Query> {
    text.split(" | ").filter_map(|one| one.parse().ok()).collect()
}

/// The name of a shrunk scene, from its task, class, backend and finding.
fn name_of(state: &State) -> String {
    let backend = state.shown_by.first().map_or("", String::as_str);
    let backend: String = backend.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
    format!("{}-{}-{}-{}", state.task, state.class.replace('_', "-"), backend, state.finding_id)
}

impl State {
    /// The backends that have to show the finding, and those that must not.
    pub fn pick(&self, tool: &Tool, programs: &Programs, recorded: Recorded<'_>) -> Result<[Picked; 2], Failure> {
        Ok([programs.pick(tool, &self.shown_by, recorded)?, programs.pick(tool, &self.not_by, recorded)?])
    }

    fn analysis(&self, finding: &Finding) -> String {
        let mut text = format!("{}: {} ({})", self.shown_by.join(", "), finding.class.name(), finding.check);
        if !finding.queries.is_empty() {
            text += &format!(" of {}", finding.query_text());
        }
        for (what, said) in [("got", &finding.got), ("truth", &finding.truth)] {
            if !said.is_empty() {
                text += &format!(", {what} {said}");
            }
        }
        text.replace('\n', " ")
    }

    /// The scene as a `[[scene]]` table; `from` is the source of the original scene, in words.
    pub fn table(&self, from: &str, spelled: &Spelled, finding: &Finding) -> String {
        let analysis = self.analysis(finding);
        let mut source = format!("shrunk from {}/{} ({})", self.suite, self.scene, self.scene_id);
        if !from.is_empty() {
            source += &format!("; {from}");
        }
        let tags = ["shrunk".to_owned()];
        spelled.table(Heading { name: &name_of(self), tags: &tags, source: &source, analysis: &analysis })
    }
}

impl Job<'_> {
    /// Shrinks and writes into an existing folder; `told` is called with the numbers of evaluations and pieces.
    pub fn run(mut self, folder: &Path, told: &mut dyn FnMut(u64, usize)) -> Result<(State, Shrunk), Failure> {
        let level: Level = self.state.level.parse().map_err(Failure::usage)?;
        for picked in &self.backends {
            self.state.engines.extend(picked.recorded()?);
        }
        let [shown_by, not_by] = [&self.backends[0], &self.backends[1]];
        let class: Class = self.state.class.parse().map_err(Failure::usage)?;
        let wanted = Wanted::finding(class, &self.state.check);
        let limit = Duration::try_from_secs_f64(self.state.limit).map_err(Failure::usage)?;
        let task = self.tool.task(&self.state.task);
        let quiet = |_: u64| {};
        let watch = Watch::new(interrupt::flag(), None, &quiet);
        let budget = Budget { findings_per_class: 1000, ..planning::budget(level) };
        let here = Backends {
            task,
            wanted: wanted.clone(),
            shown_by: shown_by.backends.iter().map(AsRef::as_ref).collect(),
            not_by: not_by.backends.iter().map(AsRef::as_ref).collect(),
            budget,
            watch: &watch,
            limit: Some(limit),
        };
        let all = || self.state.shown_by.iter().chain(&self.state.not_by);
        let is_apart = class == Class::Timeout
            || class == Class::Panic && self.state.check != "panic"
            || all().any(|backend| self.tool.is_foreign(backend));
        let apart = Apart {
            tool: self.tool,
            folder: folder.join("worker"),
            engines: self.backends.iter().flat_map(|picked| picked.files.clone()).collect(),
            wanted,
            shown_by: shown_by.backends.iter().map(|one| one.name()).collect(),
            not_by: not_by.backends.iter().map(|one| one.name()).collect(),
            limit,
            level,
        };
        let witness: &dyn Witness = if is_apart { &apart } else { &here };
        let mut failed = None;
        let (start, evaluations) = (self.start.clone(), self.state.evaluations);
        let limits = Limits { evaluations: self.state.most };
        let (mut state, job) = (self.state.clone(), &self);
        let mut kept = |spelled: &Spelled, finding: &Finding, evaluations: u64| {
            state.evaluations = evaluations;
            state.after = Measure::of(spelled);
            told(evaluations, state.after.pieces);
            if failed.is_none() {
                failed = job.write(folder, &state, spelled, finding).err();
            }
        };
        let vocabulary = self.tool.vocabulary();
        let done = shrink(vocabulary, witness, start, &self.named, limits, evaluations, &mut kept);
        let done = done.map_err(|why| {
            let State { suite, scene, finding_id, .. } = &self.state;
            // A continued shrink takes the scene from its own file.
            let own = folder.join(SUITE);
            let place = if own.exists() { format!("{}: ", own.display()) } else { String::new() };
            Failure::usage(format!("{place}{suite}/{scene}, finding {finding_id}: {why}; start it again"))
        });
        let done = done?;
        if let Some(failure) = failed {
            return Err(failure);
        }
        self.state.evaluations = done.evaluations;
        self.state.after = Measure::of(&done.spelled);
        self.state.end = (done.end != End::Interrupted).then(|| done.end.name().to_owned());
        self.write(folder, &self.state, &done.spelled, &done.finding)?;
        Ok((self.state, done))
    }

    /// Writes the scene, its tests and the state, in this order, so that everything that the state refers to exists.
    fn write(&self, folder: &Path, state: &State, spelled: &Spelled, finding: &Finding) -> Result<(), Failure> {
        let put = |name: &str, text: &str| replace(&folder.join(name), text.as_bytes()).map_err(Failure::usage);
        put(SUITE, &format!("title = \"Shrunk findings\"\n\n{}", state.table(&self.source, spelled, finding)))?;
        if state.end.is_some() {
            let name = name_of(state);
            let backend = state.shown_by.join(", ");
            let subject = Subject { spelled, finding, backend: &backend, name: &name, suite: SUITE };
            let texts = [subject.rust(), subject.cpp(), subject.python(), subject.javascript()];
            for (file, text) in TESTS.iter().zip(texts) {
                put(file, &text)?;
            }
        }
        let json = serde_json::to_string_pretty(state).map_err(Failure::usage)?;
        put(STATE, &(json + "\n"))
    }
}

/// Reads a folder of `shrink`: its state, and the smallest scene so far.
pub fn open(tool: &Tool, folder: &Path) -> Result<(State, LoadedScene), Failure> {
    let file = folder.join(STATE);
    let cure = "name the folder of a `shrink` that was begun";
    let text = std::fs::read_to_string(&file)
        .map_err(|error| Failure::usage(format!("{}: {error}; {cure}", file.display())))?;
    let state: State = serde_json::from_str(&text)
        .map_err(|error| Failure::usage(format!("{}: {error}; start it again", file.display())))?;
    let suite = Suite::from_file(tool.vocabulary(), &folder.join(SUITE), &Manifest::default())?;
    let [def] = suite.scenes.as_slice() else {
        return Err(Failure::usage(format!("{}: it should have one scene", folder.join(SUITE).display())));
    };
    let loaded = def.load(Level::Quick, &predicament_formats::Cache::new(""))?;
    let refuse = |what: String| Err(Failure::usage(format!("{}: {what}; start it again", file.display())));
    match loaded.spelled() {
        Some(spelled) if spelled.task == state.task => {}
        _ => return refuse(format!("the scene of {SUITE} is not of the task `{}`", state.task)),
    }
    if let Err(why) = state.class.parse::<Class>() {
        return refuse(why.to_string());
    }
    if let Err(why) = state.level.parse::<Level>() {
        return refuse(why.to_string());
    }
    // Engines are looked up when they are picked; reading a folder never starts one.
    let is_strange = |name: &&String| !name.starts_with(PREFIX) && !tool.knows_backend(name);
    for name in state.shown_by.iter().chain(&state.not_by).filter(is_strange) {
        if let Err(why) = tool.backend(name) {
            return refuse(why.to_string());
        }
    }
    if let Err(error) = Duration::try_from_secs_f64(state.limit) {
        return refuse(format!("`limit` is not a time limit: {error}"));
    }
    Ok((state, loaded))
}

/// Backends that run in separate processes, because they may loop or crash, or are from another crate.
struct Apart<'a> {
    tool: &'a Tool,
    folder: PathBuf,
    engines: BTreeMap<String, String>,
    wanted: Wanted,
    shown_by: Vec<String>,
    not_by: Vec<String>,
    limit: Duration,
    level: Level,
}

impl Apart<'_> {
    /// The wanted finding of a backend, if it shows it.
    fn find(&self, loaded: &LoadedScene, suite: &Path, backend: &str) -> Result<Option<Finding>, Stop> {
        let scene = planned_scene(loaded);
        let worker = Worker {
            permutations: None,
            threads: None,
            cache: None,
            folder: self.folder.clone(),
            suite: suite.display().to_string(),
            engines: &self.engines,
            scene: &scene,
            limit: Some(self.limit),
            level: self.level,
            answers: false,
        };
        // A worker that could not do its work shows nothing.
        let Ok(found) = worker.run(self.tool, backend) else { return Ok(None) };
        let found = found.ok_or(Stop::Interrupted)?;
        let findings = found.findings.into_iter().map(|row| Finding {
            queries: queries(&row.query),
            ..Finding::plain(row.class, row.check, Vec::new(), row.got, row.truth)
        });
        Ok(findings.into_iter().find(|finding| self.wanted.is(finding)))
    }
}

impl Witness for Apart<'_> {
    fn look(&self, loaded: &LoadedScene) -> Result<Option<Finding>, Stop> {
        let Some(spelled) = loaded.spelled() else { return Ok(None) };
        let suite = self.folder.with_file_name(format!("{}.toml", loaded.suite));
        let text = spelled.suite("A scene on trial", Heading { name: &loaded.name, ..Heading::default() });
        if std::fs::write(&suite, text).is_err() {
            return Ok(None);
        }
        let found = || {
            let mut first = None;
            for backend in &self.shown_by {
                match self.find(loaded, &suite, backend)? {
                    None => return Ok(None),
                    found => first = first.or(found),
                }
            }
            for backend in &self.not_by {
                if self.find(loaded, &suite, backend)?.is_some() {
                    return Ok(None);
                }
            }
            Ok(first)
        };
        let found = found();
        let _ = std::fs::remove_file(&suite);
        found
    }
}
