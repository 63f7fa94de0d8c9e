//! The folder of a hunt: its options, its progress, and its finds.
//!
//! `hunt.json` has everything that is needed to continue. It is replaced as a whole after each generation, after the
//! files that it refers to. A kill at any moment therefore loses one generation.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use predicament_corpus::{Heading, Spelled};
use predicament_engines::PREFIX;
use predicament_predicates::Class;
use predicament_records::{EngineFile, replace};
use predicament_search::hunt::{Find, State, read};
use predicament_search::snippets::Subject;
use predicament_tasks::Finding;
use serde::{Deserialize, Serialize};

use crate::exit::Failure;
use crate::tool::Tool;

/// The files of a folder: state, suite of finds, and table.
pub const STATE: &str = "hunt.json";
pub const SUITE: &str = "finds.toml";
pub const TABLE: &str = "hunt.csv";

/// The options of a hunt that must not change when it continues.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Order {
    pub task: String,
    pub class: Option<String>,
    pub check: Option<String>,
    /// The names of the backends that have to show the finding.
    pub shown_by: Vec<String>,
    /// The names of the backends that must not show it.
    pub not_by: Vec<String>,
    /// The files and versions of the engines among them.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub engines: BTreeMap<String, EngineFile>,
    pub seed: u64,
    /// The suites of the initial scenes; `shapes` is true if shapes are used too.
    pub suites: Vec<String>,
    pub shapes: bool,
    /// A digest of the initial scenes.
    pub seeds: u64,
    /// The maximum number of scenes evaluated to shrink a find.
    pub shrinking: u64,
    /// The time limit in seconds of one backend on one scene.
    pub limit: f64,
}

/// The contents of `hunt.json`.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub struct Saved {
    pub order: Order,
    /// The budget; `--resume` continues with the rest of it.
    pub evaluations: u64,
    pub finds: usize,
    /// The seconds that all processes of the hunt took.
    pub seconds: f64,
    pub state: State,
}

/// A row of `hunt.csv`.
#[derive(Serialize)]
struct Row<'a> {
    find: usize,
    task: &'a str,
    class: &'a str,
    check: &'a str,
    backend: String,
    evaluations: u64,
    seconds: String,
    pieces_before: usize,
    pieces_after: usize,
    scene_id: &'a str,
}

impl Saved {
    /// Reads the folder of a hunt. Errors in its scenes and names are reported here, because here the file is known.
    pub fn open(tool: &Tool, folder: &Path) -> Result<Saved, Failure> {
        let file = folder.join(STATE);
        let text = std::fs::read_to_string(&file).map_err(|error| {
            Failure::usage(format!("{}: {error}; name the folder of a `hunt` that was begun", file.display()))
        })?;
        let refuse = |why: &str| Failure::usage(format!("{}: {why}; start the hunt again", file.display()));
        let saved: Saved = serde_json::from_str(&text).map_err(|error| refuse(&error.to_string()))?;
        let Order { task, class, shown_by, not_by, limit, .. } = &saved.order;
        if tool.vocabulary().names().all(|name| name != task) {
            return Err(refuse(&format!("there is no task `{task}`")));
        }
        for class in class.iter().chain(saved.state.finds.iter().map(|find| &find.class)) {
            class.parse::<Class>().map_err(|why| refuse(&why.to_string()))?;
        }
        // Engines are looked up when they are picked; reading a folder never starts one.
        let is_strange = |name: &&String| !name.starts_with(PREFIX) && !tool.knows_backend(name);
        for name in shown_by.iter().chain(not_by).filter(is_strange) {
            tool.backend(name).map_err(|why| refuse(&why.to_string()))?;
        }
        Duration::try_from_secs_f64(*limit).map_err(|why| refuse(&format!("`limit` is not a time limit: {why}")))?;
        saved.state.check(tool.vocabulary(), task).map_err(|why| refuse(&why.to_string()))?;
        Ok(saved)
    }

    /// Writes all files, the state last, so that everything that it refers to exists. If `written` finds are on disk
    /// already, only new ones are written.
    pub fn write(&self, tool: &Tool, folder: &Path, written: Option<usize>) -> Result<(), Failure> {
        let put = |name: &str, text: &str| replace(&folder.join(name), text.as_bytes()).map_err(Failure::usage);
        for (at, find) in self.state.finds.iter().enumerate().skip(written.unwrap_or(0)) {
            let (spelled, finding) = (scene(tool, &find.shrunk)?, finding(find)?);
            let (name, backend) = (self.name(find), self.order.shown_by.join(", "));
            let subject =
                Subject { spelled: &spelled, finding: &finding, backend: &backend, name: &name, suite: SUITE };
            let texts = [subject.rust(), subject.cpp(), subject.python(), subject.javascript()];
            for (end, text) in ["rs", "cpp", "py", "mjs"].into_iter().zip(texts) {
                put(&format!("find-{}.{end}", at + 1), &text)?;
            }
        }
        if written.is_none_or(|written| written < self.state.finds.len()) {
            put(SUITE, &self.suite(tool)?)?;
            put(TABLE, &self.table()?)?;
        }
        put(STATE, &serde_json::to_string(self).map_err(Failure::usage)?)
    }

    /// The finds as a suite, in which a scene with several finds occurs once.
    fn suite(&self, tool: &Tool) -> Result<String, Failure> {
        let mut text = "title = \"Finds of a hunt\"\n".to_owned();
        if self.state.finds.iter().any(|find| find.class == Class::Inconsistent.name()) {
            text += "# Laws between predicates are checked only in thorough runs: `run --level full`.\n";
        }
        for find in self.state.finds.iter().filter(|find| std::ptr::eq(self.first(find), *find)) {
            text += &format!("\n{}", self.scene(tool, find)?);
        }
        Ok(text)
    }

    /// The first find with the same scene as this one.
    fn first<'f>(&'f self, find: &'f Find) -> &'f Find {
        self.state.finds.iter().find(|other| other.scene_id == find.scene_id).unwrap_or(find)
    }

    /// The name of a find's scene, from its first find and its id.
    pub fn name(&self, find: &Find) -> String {
        let find = self.first(find);
        let backend = self.order.shown_by.first().map_or("", String::as_str);
        let backend: String = backend.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        let id: String = find.scene_id.chars().take(8).collect();
        format!("{}-{}-{backend}-{id}", self.order.task, find.class.replace('_', "-"))
    }

    /// A find as a `[[scene]]` table.
    pub fn scene(&self, tool: &Tool, find: &Find) -> Result<String, Failure> {
        let spelled = scene(tool, &find.shrunk)?;
        let parents: Vec<String> = find.parents.iter().map(ToString::to_string).collect();
        let mut source = format!("hunted with seed {}: scene {}", self.order.seed, find.number);
        if !parents.is_empty() {
            source += &format!(", derived from {}", parents.join(" and "));
        }
        source += &format!("; {}; found within {} evaluations", find.story, find.evaluations);
        let mut analysis = format!("{}: {} ({})", self.order.shown_by.join(", "), find.class, find.check);
        for (what, said) in [("of", &find.query), (", got", &find.got), (", truth", &find.truth)] {
            if !said.is_empty() {
                let space = if what == "of" { " " } else { "" };
                analysis += &format!("{space}{what} {said}");
            }
        }
        let others = self.state.finds.iter().filter(|other| other.scene_id == find.scene_id);
        for other in others.filter(|other| (&other.class, &other.check) != (&find.class, &find.check)) {
            analysis += &format!("; {} ({}) as well", other.class, other.check);
        }
        let (tags, analysis) = (["hunted".to_owned()], analysis.replace('\n', " "));
        Ok(spelled.table(Heading { name: &self.name(find), tags: &tags, source: &source, analysis: &analysis }))
    }

    fn table(&self) -> Result<String, Failure> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        if self.state.finds.is_empty() {
            let columns = "find,task,class,check,backend,evaluations,seconds,pieces_before,pieces_after,scene_id";
            return Ok(format!("{columns}\n"));
        }
        for (at, find) in self.state.finds.iter().enumerate() {
            let row = Row {
                find: at + 1,
                task: &self.order.task,
                class: &find.class,
                check: &find.check,
                backend: self.order.shown_by.join(" "),
                evaluations: find.evaluations,
                seconds: format!("{:.3}", find.seconds),
                pieces_before: find.pieces[0],
                pieces_after: find.pieces[1],
                scene_id: &find.scene_id,
            };
            writer.serialize(row).map_err(Failure::usage)?;
        }
        let bytes = writer.into_inner().map_err(Failure::usage)?;
        String::from_utf8(bytes).map_err(Failure::usage)
    }
}

fn scene(tool: &Tool, text: &str) -> Result<Spelled, Failure> {
    read(tool.vocabulary(), text).map_err(Failure::usage)
}

fn finding(find: &Find) -> Result<Finding, Failure> {
    let class: Class = find.class.parse().map_err(Failure::usage)?;
    let queries = find.query.split(" | ").filter_map(|one| one.parse().ok()).collect();
    Ok(Finding::plain(class, find.check.clone(), queries, find.got.clone(), find.truth.clone()))
}
