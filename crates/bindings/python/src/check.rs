//! A Python function on the embedded corpora, judged.

use std::sync::Arc;
use std::sync::atomic::Ordering;

use predicament_corpus::{Heading, Level, Library, LoadedScene, Suite};
use predicament_formats::{Cache, hexfloat};
use predicament_predicates::{Class, PredicateKind, Vertex, ZeroMeaning};
use predicament_search::shrink::{Limits, shrink};
use predicament_search::snippets::Subject;
use predicament_search::{Backends, Wanted, Witness};
use predicament_tasks::{AnyTask, Budget, Contestant, Entry, Finding, Outcome, Stop, Watch, run};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use rayon::ThreadPool;

use crate::callable::{Callable, Ended, is_single, rounded};
use crate::waiting::interruptible;
use crate::{cases, kinds};

/// The sample sizes of the judge: each query once, and some in other orders of their points. Single calls of Python
/// are slow, so that there are fewer of these than the tool makes.
const BUDGET: Budget = Budget { permutations: 600, relations: 100, ..Budget::QUICK };
/// The scenes that shrinking evaluates, at most.
const EVALUATIONS: u64 = 3000;

/// A scene that was asked about, or the reason why it was not.
struct Row {
    suite: String,
    scene: String,
    family: String,
    queries: u64,
    counts: Vec<(Class, u64)>,
    /// The reason why nothing was asked.
    skipped: Option<String>,
}

/// A finding with its points.
struct Found {
    suite: String,
    scene: String,
    family: String,
    finding: Finding,
    points: Vec<Vec<f64>>,
}

/// The smallest scene that still shows a finding.
struct Small {
    of: usize,
    found: Found,
    python: String,
    toml: String,
    evaluations: u64,
}

#[derive(Default)]
struct Done {
    rows: Vec<Row>,
    found: Vec<Found>,
    small: Vec<Small>,
}

/// Runs a function on the scenes of a predicate; returns the scenes, the findings, and shrunk findings.
///
/// `ask` takes an array of shape (queries, points, coordinates) and returns an array of numbers. With `is_float`,
/// scenes are rounded to single precision, and the truth is about the rounded points. `shrunk` is the number of
/// findings to shrink, of different classes first.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn check<'py>(
    py: Python<'py>,
    name: &str,
    ask: Py<PyAny>,
    function: String,
    level: &str,
    suites: Vec<String>,
    is_float: bool,
    breaks_ties: bool,
    shrunk: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let kind = kinds::kind(name)?;
    let level: Level = level.parse().map_err(|why| PyValueError::new_err(format!("{why}")))?;
    let ended = Arc::new(Ended::default());
    let zero = if breaks_ties { ZeroMeaning::Never } else { ZeroMeaning::Exact };
    let entry = Entry::new(Callable { name: function, kind, ask, zero, ended: Arc::clone(&ended) });
    let flag = Arc::clone(&ended);
    let cancel = move || flag.flag.store(true, Ordering::Relaxed);
    let asking = Asking { kind, level, is_float, entry: &entry, ended: &ended };
    let done = interruptible(py, cancel, || asking.all(&suites, shrunk))?;
    if let Some(why) = ended.why.lock().map_err(|_| PyRuntimeError::new_err("lost"))?.take() {
        return Err(why);
    }
    told(py, kind, &done.map_err(PyValueError::new_err)?)
}

struct Asking<'a> {
    kind: PredicateKind,
    level: Level,
    is_float: bool,
    entry: &'a Entry<Callable>,
    ended: &'a Ended,
}

impl Asking<'_> {
    /// Asks about all scenes, then shrinks.
    fn all(&self, names: &[String], shrunk: usize) -> Result<Done, String> {
        let library = Library::embedded(predicament_bundle::vocabulary()).map_err(|why| why.to_string())?;
        let named: Vec<Suite>;
        let suites: &[Suite] = if names.is_empty() {
            library.suites().map_err(|why| why.to_string())?
        } else {
            let all: Result<_, _> = names.iter().map(|name| library.suite(name)).collect();
            named = all.map_err(|why: predicament_formats::CorpusError| why.to_string())?;
            &named
        };
        // Python answers one call at a time.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(|why| why.to_string())?;
        let task = predicament_bundle::task(self.kind.name()).ok_or("the predicate has no task")?;
        let quiet = |_: u64| {};
        let watch = Watch::new(&self.ended.flag, None, &quiet);
        let mut done = Done::default();
        let mut starts: Vec<(Class, usize, LoadedScene)> = Vec::new();
        for def in suites.iter().flat_map(|suite| &suite.scenes).filter(|scene| scene.task == self.kind.name()) {
            let mut row = Row {
                suite: def.suite.clone(),
                scene: def.name.clone(),
                family: def.family.clone(),
                queries: 0,
                counts: Vec::new(),
                skipped: None,
            };
            let loaded = if def.needs_fetch() {
                Err("its data have to be fetched".to_owned())
            } else {
                def.load(self.level, &Cache::new("")).map_err(|why| why.to_string()).and_then(|one| self.moved(one))
            };
            match loaded.and_then(|loaded| Ok((self.outcome(task, &loaded, &pool, &watch)?, loaded))) {
                Err(why) => row.skipped = Some(why),
                Ok((outcome, loaded)) => {
                    row.queries = outcome.queries;
                    let counts = Class::ALL.into_iter().map(|class| (class, outcome.counts.get(class)));
                    row.counts = counts.filter(|(_, count)| *count > 0).collect();
                    for finding in outcome.findings {
                        if starts.iter().all(|(class, ..)| *class != finding.class) || starts.len() < shrunk {
                            starts.push((finding.class, done.found.len(), loaded.clone()));
                        }
                        done.found.push(found(&loaded, finding));
                    }
                }
            }
            done.rows.push(row);
            if self.ended.flag.load(Ordering::Relaxed) {
                return Ok(done);
            }
        }
        // The first of each class before the second of any.
        let mut order: Vec<usize> = (0..starts.len()).collect();
        order.sort_by_key(|&at| starts[..at].iter().filter(|(class, ..)| *class == starts[at].0).count());
        for &at in order.iter().take(shrunk) {
            let (_, of, loaded) = &starts[at];
            done.small.extend(self.shrunk(task, loaded, &done.found[*of], *of, &pool, &watch));
        }
        Ok(done)
    }

    /// The scene as the function sees it.
    fn moved(&self, loaded: LoadedScene) -> Result<LoadedScene, String> {
        if !loaded.scene.constructions().is_empty() {
            return Err("constructed points have no coordinates".to_owned());
        }
        if !self.is_float || is_single(&loaded.scene) {
            return Ok(loaded);
        }
        let coordinates = loaded.scene.coordinates().iter().map(|&x| rounded(x)).collect();
        loaded.moved(coordinates).map_err(|why| format!("rounded to single precision: {why}"))
    }

    fn outcome(
        &self,
        task: &dyn AnyTask,
        loaded: &LoadedScene,
        pool: &ThreadPool,
        watch: &Watch<'_>,
    ) -> Result<Outcome, String> {
        let stopped = |_: Stop| "stopped".to_owned();
        let case = task.case(loaded, watch).map_err(stopped)?;
        if let Some(dispute) = case.dispute() {
            return Err(format!("the scene is not judged: {dispute}"));
        }
        let contestant: &dyn Contestant = self.entry;
        pool.install(|| run(case.as_ref(), contestant, BUDGET, watch)).map_err(stopped)
    }

    fn shrunk(
        &self,
        task: &dyn AnyTask,
        loaded: &LoadedScene,
        from: &Found,
        of: usize,
        pool: &ThreadPool,
        watch: &Watch<'_>,
    ) -> Option<Small> {
        let finding = &from.finding;
        let contestant: &dyn Contestant = self.entry;
        let backends = Backends {
            task,
            wanted: Wanted::finding(finding.class, &finding.check),
            shown_by: vec![contestant],
            not_by: Vec::new(),
            budget: Budget { findings_per_class: 1000, ..BUDGET },
            watch,
            limit: None,
        };
        let witness = Rounded { backends, is_float: self.is_float };
        let named: Vec<Vertex> = finding.queries.iter().flat_map(|query| query.vertices()).collect();
        let limits = Limits { evaluations: EVALUATIONS };
        let vocabulary = predicament_bundle::vocabulary();
        let start = loaded.spelled()?;
        let small = pool.install(|| shrink(vocabulary, &witness, start, &named, limits, 0, &mut |_, _, _| {})).ok()?;
        let name = format!("{}-{}", self.kind.name(), finding.class.name());
        let function = contestant.name();
        let subject = Subject {
            spelled: &small.spelled,
            finding: &small.finding,
            backend: &function,
            name: &name,
            suite: "shrunk.toml",
        };
        let source = format!("shrunk from {}/{}", from.suite, from.scene);
        let toml = small.spelled.table(Heading { name: &name, source: &source, ..Heading::default() });
        let python = subject.python();
        let mut found = found(&small.loaded, small.finding);
        (found.suite, found.scene) = (from.suite.clone(), from.scene.clone());
        found.family.clone_from(&from.family);
        Some(Small { of, found, python, toml, evaluations: small.evaluations })
    }
}

/// A witness that looks only at scenes that the function sees as they are.
struct Rounded<'a> {
    backends: Backends<'a>,
    is_float: bool,
}

impl Witness for Rounded<'_> {
    fn look(&self, loaded: &LoadedScene) -> Result<Option<Finding>, Stop> {
        if self.is_float && !is_single(&loaded.scene) {
            return Ok(None);
        }
        self.backends.look(loaded)
    }
}

fn found(loaded: &LoadedScene, finding: Finding) -> Found {
    let points = finding.queries.iter().flat_map(|query| {
        let axes = query.question().map_or(&[0, 1, 2][..loaded.scene.dimension().count()], |(of, _)| of.coordinates());
        let point = |v: Vertex| cases::seen(&loaded.scene, axes, v).collect();
        query.vertices().filter(|v| v.index() < loaded.scene.len()).map(point).collect::<Vec<Vec<f64>>>()
    });
    let points = points.collect();
    let (suite, scene, family) = (loaded.suite.clone(), loaded.name.clone(), loaded.family.clone());
    Found { suite, scene, family, finding, points }
}

fn told<'py>(py: Python<'py>, kind: PredicateKind, done: &Done) -> PyResult<Bound<'py, PyDict>> {
    let all = PyDict::new(py);
    let rows = PyList::empty(py);
    for row in &done.rows {
        let dict = PyDict::new(py);
        dict.set_item("suite", &row.suite)?;
        dict.set_item("scene", &row.scene)?;
        dict.set_item("family", &row.family)?;
        dict.set_item("queries", row.queries)?;
        let count =
            |is: fn(Class) -> bool| row.counts.iter().filter(|(class, _)| is(*class)).map(|(_, n)| n).sum::<u64>();
        dict.set_item("findings", count(|class| !class.is_legal()))?;
        for class in Class::ALL {
            let count = row.counts.iter().find(|(one, _)| *one == class).map_or(0, |(_, count)| *count);
            dict.set_item(class.name(), count)?;
        }
        dict.set_item("skipped", row.skipped.as_deref())?;
        rows.append(dict)?;
    }
    all.set_item("scenes", rows)?;
    let findings = PyList::empty(py);
    for one in &done.found {
        findings.append(finding(py, kind, one)?)?;
    }
    all.set_item("findings", findings)?;
    let small = PyList::empty(py);
    for one in &done.small {
        let dict = finding(py, kind, &one.found)?;
        dict.set_item("of", one.of)?;
        dict.set_item("evaluations", one.evaluations)?;
        dict.set_item("python", &one.python)?;
        dict.set_item("toml", &one.toml)?;
        small.append(dict)?;
    }
    all.set_item("shrunk", small)?;
    Ok(all)
}

fn finding<'py>(py: Python<'py>, kind: PredicateKind, found: &Found) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let of = &found.finding;
    dict.set_item("predicate", kind.name())?;
    dict.set_item("suite", &found.suite)?;
    dict.set_item("scene", &found.scene)?;
    dict.set_item("family", &found.family)?;
    dict.set_item("class", of.class.name())?;
    dict.set_item("check", &of.check)?;
    dict.set_item("query", of.query_text())?;
    let hex: Vec<Vec<String>> =
        found.points.iter().map(|point| point.iter().map(|&x| hexfloat::format(x)).collect()).collect();
    dict.set_item("points", &found.points)?;
    dict.set_item("points_hex", hex)?;
    dict.set_item("answer", &of.got)?;
    dict.set_item("truth", &of.truth)?;
    dict.set_item("log2_relative_det", of.log2_relative_det)?;
    Ok(dict)
}
