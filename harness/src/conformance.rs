//! Conformance tests: a test in a backend's own crate runs the backend on the corpora.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use predicament_bundle::Systems;
use predicament_conformance::{Answer, regression_test};
use predicament_corpus::{Level, LoadedScene};
use predicament_judge::TieJudge;
use predicament_oracle::expect::Expectations;
use predicament_oracle::roster::Roster;
use predicament_predicates::{Backend, Question, Scene, Sign, Vertex};
use predicament_records::{RunWriter, Shard};
use predicament_tasks::{Contestant, Entry, Finding, Task, Watch};

use crate::exit::Failure;
use crate::planning::{budget, env_of, plan, tables};
use crate::rows;
use crate::select::Selector;
use crate::told::point_lines;
use crate::tool::{Guests, Tool};

/// The test of a function of points that reproduces a finding; `None` if the finding is not about the sign of one query
/// about input points.
fn regression(loaded: &LoadedScene, finding: &Finding) -> Option<String> {
    let [query] = finding.queries.as_slice() else { return None };
    let (question, args) = query.question()?;
    let sign = |text: &str| text.chars().next().and_then(Sign::from_symbol);
    let point = |v: &Vertex| {
        let point = (!v.is_constructed()).then(|| loaded.scene.point(*v))?;
        question.coordinates().iter().map(|&axis| point.get(axis).copied()).collect::<Option<Vec<f64>>>()
    };
    let points: Vec<Vec<f64>> = args.iter().map(point).collect::<Option<_>>()?;
    let points: Vec<&[f64]> = points.iter().map(Vec::as_slice).collect();
    let (kind, name) = (question.kind(), &loaded.name);
    let got = sign(&finding.got).map_or(Answer::NotANumber, Answer::Sign);
    let test = regression_test(kind, kind.name(), name, &points, got, sign(&finding.truth)?)?;
    Some(format!("  as a test of a function of points:\n{test}"))
}

/// The number of findings printed in full.
const SHOWN: usize = 5;

/// A conformance test of a backend: every embedded scene that needs no download.
///
/// ```no_run
/// # use predicament::example::Mine;
/// predicament::conformance(Mine).level(predicament::Level::Quick).assert();
/// ```
pub fn conformance<B: Backend + 'static>(backend: B) -> Conformance<B> {
    Conformance {
        backend: Arc::new(backend),
        tasks: Systems,
        ties: None,
        selector: Selector::everything(),
        suites: Vec::new(),
        expected: None,
        folder: None,
    }
}

/// A conformance test; see [`conformance`].
pub struct Conformance<B, T = Systems> {
    backend: Arc<B>,
    tasks: T,
    ties: Option<Arc<TieJudge>>,
    selector: Selector,
    suites: Vec<PathBuf>,
    expected: Option<PathBuf>,
    folder: Option<PathBuf>,
}

impl<B: Backend + 'static, T: Roster> Conformance<B, T> {
    /// Sets the level; the default is quick.
    #[must_use]
    pub fn level(mut self, level: Level) -> Conformance<B, T> {
        self.selector.level = level;
        self
    }

    /// Selects the scenes whose `suite/scene` matches this regular expression.
    #[must_use]
    pub fn filter(mut self, regex: impl Into<String>) -> Conformance<B, T> {
        self.selector.filter = Some(regex.into());
        self
    }

    /// Selects these suites, by name.
    #[must_use]
    pub fn only<S: Into<String>>(mut self, suites: impl IntoIterator<Item = S>) -> Conformance<B, T> {
        self.selector.suites = suites.into_iter().map(Into::into).collect();
        self
    }

    /// Adds a task, which your own suites use.
    #[must_use]
    pub fn task<N: Task + Clone>(self, task: N) -> Conformance<B, (N, T)> {
        let Conformance { backend, tasks, ties, selector, suites, expected, folder } = self;
        Conformance { backend, tasks: (task, tasks), ties, selector, suites, expected, folder }
    }

    /// Adds a folder of suites.
    #[must_use]
    pub fn suites(mut self, folder: impl Into<PathBuf>) -> Conformance<B, T> {
        self.suites.push(folder.into());
        self
    }

    /// Names a file of expected disagreements: known errors of the backend.
    #[must_use]
    pub fn expected(mut self, file: impl Into<PathBuf>) -> Conformance<B, T> {
        self.expected = Some(file.into());
        self
    }

    /// Names the independent judge of the backend's tie-breaking.
    #[must_use]
    pub fn breaking_ties(
        mut self,
        judge: impl Fn(&Scene, Question, &[Vertex]) -> Sign + Send + Sync + 'static,
    ) -> Conformance<B, T> {
        self.ties = Some(Arc::new(judge));
        self
    }

    /// Names the folder of the run; the default is `target/predicament/NAME`. An earlier run in it is replaced.
    #[must_use]
    pub fn folder(mut self, folder: impl Into<PathBuf>) -> Conformance<B, T> {
        self.folder = Some(folder.into());
        self
    }

    /// Runs all selected scenes. The run folder stays, for `replay` and `report`.
    ///
    /// # Errors
    /// The first unexpected findings, each with its coordinates and a line that replays it, or the reason why the run
    /// failed.
    pub fn check(&self) -> Result<String, String> {
        self.run().map_err(|failure| failure.message)
    }

    /// Runs all selected scenes and panics if [`check`](Conformance::check) returns an error.
    ///
    /// # Panics
    /// If there is an unexpected finding, or an expected finding did not occur.
    pub fn assert(&self) {
        if let Err(message) = self.check() {
            panic!("{message}");
        }
    }

    fn contestant(&self) -> Entry<B, T> {
        let ties = self
            .ties
            .clone()
            .map(|judge| -> Box<TieJudge> { Box::new(move |scene, question, args| judge(scene, question, args)) });
        Entry::shared(Arc::clone(&self.backend), ties, self.tasks.clone())
    }

    fn run(&self) -> Result<String, Failure> {
        let guests = Guests { suites: self.suites.clone(), ..Guests::default() };
        let tool = Tool::new((), &self.tasks, guests);
        let expected = match &self.expected {
            Some(file) => crate::expectations::load(&tool, Some(file))?,
            None => Expectations::default(),
        };
        let selection = self.selector.select(&tool)?;
        let mut scenes = selection.plan()?;
        let backends: Vec<Box<dyn Contestant>> = vec![Box::new(self.contestant())];
        let backend = backends[0].as_ref();
        let name = backend.name();
        let plain: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        let folder = self.folder.clone().unwrap_or_else(|| PathBuf::from("target/predicament").join(plain));
        if folder.exists() {
            if !folder.join("plan.json").exists()
                && std::fs::read_dir(&folder).is_ok_and(|mut all| all.next().is_some())
            {
                let message = format!("{}: the folder does not hold a run; name another", folder.display());
                return Err(Failure::usage(message));
            }
            std::fs::remove_dir_all(&folder).map_err(Failure::io(&folder))?;
        }
        let plan = plan(&tool, &selection, &scenes, &backends, Shard::WHOLE);
        let mut writer =
            RunWriter::create(&folder, &plan, &env_of(&backends), &tables(&tool)).map_err(Failure::usage)?;
        let never = AtomicBool::new(false);
        let watch = Watch::new(&never, None, &|_| {});
        let (mut answers, mut wrong, mut shown) = (0_u64, Vec::new(), String::new());
        for scene in &mut scenes {
            let planned = scene.plan.clone();
            let loaded = scene.take(&selection)?;
            let case = tool.task(loaded.task).case(&loaded, &watch);
            let case = case.map_err(|_| Failure::usage("the run was stopped"))?;
            let outcome = predicament_oracle::run(case.as_ref(), backend, budget(selection.level), &watch);
            let outcome = outcome.map_err(|_| Failure::usage("the run was stopped"))?;
            let level = selection.level.name();
            let row = rows::record(&mut writer, &planned, &name, &outcome, &expected, level).map_err(Failure::usage)?;
            writer.commit_if_due().map_err(Failure::usage)?;
            answers += if row.has_answers() { outcome.queries } else { 0 };
            if row.status.passes() {
                continue;
            }
            wrong.push(crate::ledger::describe(&row));
            if let Some(finding) = outcome.findings.first().filter(|_| wrong.len() <= SHOWN) {
                let id = predicament_tasks::finding_id(&planned.scene_id, &name, finding);
                let _ = writeln!(shown, "\n{}: got {}, true is {}", finding.query_text(), finding.got, finding.truth);
                let vertices: Vec<Vertex> = finding.queries.iter().flat_map(|query| query.vertices()).collect();
                for line in point_lines(&loaded, &vertices) {
                    let _ = writeln!(shown, "  {line}");
                }
                let _ = writeln!(
                    shown,
                    "  again, with a tool that has this backend: replay {id} --run {}",
                    folder.display()
                );
                shown.push_str(&regression(&loaded, finding).unwrap_or_default());
            }
        }
        writer.finish(predicament_records::Outcome::Complete).map_err(Failure::usage)?;
        let never = crate::expectations::unused(&expected, &tool, &plan)?.never;
        if !never.is_empty() {
            return Err(Failure::usage(format!("{name}: expectations that nothing can meet\n{}", never.join("\n"))));
        }
        if wrong.is_empty() {
            return Ok(format!("{name}: {answers} answers to {} scenes, none unexpected", scenes.len()));
        }
        let list: Vec<&str> = wrong.iter().map(String::as_str).take(20).collect();
        Err(Failure::usage(format!(
            "{name}: {} of {} scenes are not as expected\n{}\n{shown}",
            wrong.len(),
            scenes.len(),
            list.join("\n")
        )))
    }
}
