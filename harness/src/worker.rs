//! Runs a scene on a backend in a separate process, so that neither a time limit nor a crash ends the run.
//!
//! A backend from another crate may loop forever, overflow its stack, abort or ask for all memory. An algorithm on a
//! whole scene does not check the clock. Both run where they can be ended: in another process of the same program,
//! whose run folder is read back.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Child, ExitStatus, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use predicament_corpus::Level;
use predicament_engines::PREFIX;
use predicament_records::{Error, FindingRow, Outcome, PlannedScene, Record, RunDir, StageRow, Status, SummaryRow};
use predicament_tasks::{Class, Finding, finding_id};

use crate::child::{self, End, wait};
use crate::death::{Said, death, unable, was_signalled};
use crate::exit::{Failure, INCOMPLETE, OK, UNEXPECTED, UNEXPECTED_PASS};
use crate::interrupt;
use crate::planning::tables_with;
use crate::tool::Tool;

/// The prefix of the folder for files of workers, inside the run's folder. The process id of the run follows, because a
/// worker of a killed run may still be running for a moment.
const FOLDER: &str = "worker-";
/// The number of times that a worker ended by somebody is started again before this counts as the backend's fault or as
/// the end of the run.
const AGAIN: u32 = 2;
/// The time to wait for an interrupt to reach this process after it reached a worker.
const HEARSAY: Duration = Duration::from_millis(200);
/// The exit codes of a worker that has done its work. With the last code, an engine ran out of time.
const FINE: [u8; 4] = [OK, UNEXPECTED, UNEXPECTED_PASS, INCOMPLETE];
/// The scene, suite and time limit of a worker.
pub struct Worker<'a> {
    pub permutations: Option<usize>,
    pub threads: Option<usize>,
    pub cache: Option<&'a Path>,
    /// A folder for its files, which no other process writes; see [`folder`].
    pub folder: PathBuf,
    /// The suite, by name or file.
    pub suite: String,
    /// The files of engines, by backend name.
    pub engines: &'a BTreeMap<String, String>,
    pub scene: &'a PlannedScene,
    /// The time limit, or `None` if only Ctrl-C ends the worker.
    pub limit: Option<Duration>,
    pub level: Level,
    /// True if every answer is written.
    pub answers: bool,
}

/// The rows that a worker wrote.
pub struct Found {
    pub summary: Vec<SummaryRow>,
    pub findings: Vec<FindingRow>,
    pub stages: Vec<StageRow>,
    pub more: Vec<Record>,
    /// Pictures with their names.
    pub maps: Vec<(String, Vec<u8>)>,
}

/// The end of a worker.
enum Done {
    /// The worker wrote rows, or crashed; a crash is a row too.
    Found(Box<Found>),
    /// The worker was killed by a signal that no program sends itself; this would be its row.
    Killed(Box<Found>),
    /// The worker or this process was asked to stop.
    Stopped,
}

impl Done {
    fn found(found: Found) -> Done {
        Done::Found(Box::new(found))
    }
}

/// The folder for the files of this process's workers, inside the run's folder.
pub fn folder(run: &Path) -> PathBuf {
    run.join(format!("{FOLDER}{}", std::process::id()))
}

/// Removes the worker files of killed runs from the folder of a run.
pub fn clear(run: &Path) {
    for entry in std::fs::read_dir(run).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(FOLDER) {
            let _ = std::fs::remove_dir_all(entry.path());
        }
    }
}

/// True if this process is asked to stop within this time.
fn was_interrupted_within(while_: Duration) -> bool {
    let start = Instant::now();
    while !interrupt::flag().load(Ordering::Relaxed) && start.elapsed() < while_ {
        std::thread::sleep(Duration::from_millis(2));
    }
    interrupt::flag().load(Ordering::Relaxed)
}

/// True if a worker ended because it was asked to: its exit code says so and its rows are incomplete, or a signal ended
/// it.
fn was_stopped(status: Option<ExitStatus>, run: &Path) -> bool {
    let ended = status.and_then(|status| status.code()) == Some(i32::from(INCOMPLETE));
    let outcome = || RunDir::open(run).map(|dir| dir.outcome);
    (ended && outcome().is_ok_and(|outcome| outcome == Outcome::Interrupted)) || was_signalled(status, &[1, 2, 15])
}

/// True if a worker was killed outright, by somebody or by the system when memory runs out.
fn was_killed(status: Option<ExitStatus>) -> bool {
    was_signalled(status, &[9])
}

impl Worker<'_> {
    /// Runs one backend; returns `None` if the tool was interrupted.
    ///
    /// A worker that somebody ended, such as a batch system, is started again, because its backend did not cause that.
    /// A worker that is killed repeatedly counts as out of memory.
    pub fn run(&self, tool: &Tool, backend: &str) -> Result<Option<Found>, Failure> {
        let mut done = self.once(tool, backend);
        for _ in 0..AGAIN {
            if matches!(done, Ok(Done::Killed(_) | Done::Stopped)) && !was_interrupted_within(HEARSAY) {
                done = self.once(tool, backend);
            }
        }
        let _ = std::fs::remove_dir_all(&self.folder);
        Ok(match done? {
            Done::Found(found) => Some(*found),
            Done::Killed(fate) if !interrupt::flag().load(Ordering::Relaxed) => Some(*fate),
            Done::Killed(_) | Done::Stopped => None,
        })
    }

    /// Runs one backend once.
    fn once(&self, tool: &Tool, backend: &str) -> Result<Done, Failure> {
        let folder = &self.folder;
        let cannot = |what: &Path, error: std::io::Error| Failure::usage(Error::io(what)(error));
        let _ = std::fs::remove_dir_all(folder);
        std::fs::create_dir(folder).map_err(|error| cannot(folder, error))?;
        let run = folder.join("run");
        let mut child = self.command(backend, &run)?;
        let said = Said::last(child.stderr.take());
        Ok(match wait(&mut child, self.limit) {
            End::Interrupt => Done::Stopped,
            End::Limit(limit) => {
                Done::found(self.fate(backend, Class::Timeout, "time limit", format!("took longer than {limit:?}")))
            }
            // Ctrl-C reaches both processes; the worker may have ended before this process looked.
            End::Exit(_) if interrupt::flag().load(Ordering::Relaxed) => Done::Stopped,
            End::Exit(status) => match self.left(tool, status, &run) {
                Some(found) => Done::found(found),
                None if was_stopped(status, &run) => Done::Stopped,
                None => {
                    let said = said.text();
                    if let Some(failure) = unable(status, &said).filter(|_| !backend.starts_with(PREFIX)) {
                        let _ = std::fs::remove_dir_all(folder);
                        return Err(failure);
                    }
                    let (check, message) = death(status, &said);
                    let fate = self.fate(backend, Class::Panic, check, message);
                    if was_killed(status) { Done::Killed(Box::new(fate)) } else { Done::found(fate) }
                }
            },
        })
    }

    /// The rows that a worker wrote, or `None` if it ended before they were complete, whatever its exit code.
    fn left(&self, tool: &Tool, status: Option<ExitStatus>, run: &Path) -> Option<Found> {
        FINE.iter().find(|&&code| status.and_then(|status| status.code()) == Some(i32::from(code)))?;
        let dir =
            RunDir::open(run).ok().filter(|dir| dir.outcome != Outcome::Unfinished && dir.not_run().is_empty())?;
        let more = tables_with(tool, self.answers).into_iter().flat_map(|table| dir.records(table)).collect();
        let RunDir { summary, findings, stages, maps, .. } = dir;
        let (summary, findings, stages) = (summary.into(), findings.into(), stages.into());
        Some(Found { summary, findings, stages, more, maps })
    }

    fn command(&self, backend: &str, run: &Path) -> Result<Child, Failure> {
        let mut command = child::command()?;
        let filter = format!("^{}$", regex::escape(&format!("{}/{}", self.scene.suite, self.scene.scene)));
        let argument = self.engines.get(backend).map_or_else(|| backend.to_owned(), |file| format!("{PREFIX}{file}"));
        command.args(["run", &self.suite, "-f", &filter, "-b", &argument]);
        command.args(["--level", self.level.name(), "--isolate", "never"]).arg("--out").arg(run);
        if self.answers {
            command.arg("--answers");
        }
        if let Some(permutations) = self.permutations {
            command.args(["--permutations", &permutations.to_string()]);
        }
        if let Some(threads) = self.threads {
            command.args(["--threads", &threads.to_string()]);
        }
        if let Some(cache) = self.cache {
            command.arg("--cache").arg(cache);
        }
        child::start(command, Stdio::null())
    }

    /// The rows for a worker that wrote none.
    fn fate(&self, backend: &str, class: Class, check: &str, said: String) -> Found {
        let scene = self.scene;
        let finding = Finding::plain(class, check, Vec::new(), said, String::new());
        let mut summary = SummaryRow::new(scene, backend, scene.queries, Status::Unexpected);
        *summary.count_mut(class) = 1;
        let finding = crate::rows::finding(scene, backend, &finding, finding_id(&scene.scene_id, backend, &finding));
        Found {
            summary: vec![summary],
            findings: vec![finding],
            stages: Vec::new(),
            more: Vec::new(),
            maps: Vec::new(),
        }
    }
}
