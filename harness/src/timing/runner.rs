//! Prepared backends: what is timed, and the answers that it has to give.

use predicament_corpus::LoadedScene;
use predicament_oracle::caught;
use predicament_records::{Interface, PlannedScene};
use predicament_tasks::{Contestant, Stopwatch, on_threads};

/// A backend that is ready to be timed on one scene.
pub struct Runner<'a> {
    /// The backend's name.
    pub name: String,
    pub(super) family: String,
    pub(super) version: String,
    /// The interface through which it is called.
    pub(super) interface: Interface,
    /// The number of threads that it uses.
    pub threads: usize,
    /// The stopwatch that runs and times its passes.
    pub watch: Box<dyn Stopwatch + 'a>,
    pub(super) judged: u64,
    pub(super) queries: u64,
    pub(super) passes: u32,
    /// The nanoseconds per query of each sample.
    pub(super) samples: Vec<f64>,
}

impl Runner<'_> {
    /// True if another program answers.
    pub(super) fn is_program(&self) -> bool {
        self.name.starts_with("engine:")
    }
}

/// Prepares a backend for each interface and each of these numbers of threads.
pub fn start<'a>(
    loaded: &'a LoadedScene,
    backend: &'a dyn Contestant,
    scene: &PlannedScene,
    judged: Option<u64>,
    threads: &[usize],
) -> Result<Vec<Runner<'a>>, String> {
    let judged = judged.ok_or("the answers were not judged")?;
    let solver = backend.solver(loaded.task).ok_or("the backend does not know the task")?;
    let content = loaded.content.as_ref();
    let mut runners = Vec::new();
    for &threads in threads {
        for interface in solver.interfaces(content) {
            let prepared = caught(|| solver.stopwatch(&loaded.scene, content, threads, interface));
            let watch = prepared.map_err(|broken| broken.to_string())?.map_err(|why| why.to_string())?;
            let Some(watch) = watch else { continue };
            runners.push(Runner {
                name: backend.name(),
                family: on_threads(&scene.family, threads),
                version: backend.version().unwrap_or_else(|| env!("CARGO_PKG_VERSION").to_owned()),
                watch,
                interface,
                threads,
                judged,
                queries: scene.queries,
                passes: 1,
                samples: Vec::new(),
            });
        }
    }
    Ok(runners)
}

/// Prepares predicates that return at once. Their answers are not judged; they only have to stay the same.
pub fn empty<'a>(
    loaded: &'a LoadedScene,
    binding: &'a dyn Contestant,
    scene: &PlannedScene,
    threads: &[usize],
) -> Result<Vec<Runner<'a>>, String> {
    let mut runners = start(loaded, binding, scene, Some(0), threads)?;
    for runner in &mut runners {
        caught(|| runner.watch.pass()).map_err(|broken| broken.to_string())?;
        runner.judged = runner.watch.digest();
    }
    Ok(runners)
}
