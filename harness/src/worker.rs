//! Runs a scene on a backend in a process of its own, which a time limit, or its own end, cannot take the run with.
//!
//! A backend of somebody else may loop for ever, overflow its stack, abort or ask
//! for all memory; an algorithm that runs on a whole scene looks at no clock. Both
//! run where they can be ended: in another process of the same program, whose
//! run folder is read back.

use std::collections::BTreeMap;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStderr, ExitStatus};
use std::sync::atomic::Ordering;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use predicament_corpus::Level;
use predicament_engines::PREFIX;
use predicament_records::{Error, FindingRow, Outcome, PlannedScene, Record, RunDir, StageRow, Status, SummaryRow};
use predicament_tasks::{Class, Finding, finding_id};

use crate::child::{self, End, FAREWELL, wait};
use crate::exit::{CORPUS, Failure, INCOMPLETE, NOTHING_SELECTED, OK, UNEXPECTED, UNEXPECTED_PASS, USAGE};
use crate::interrupt;
use crate::out::program;
use crate::planning::tables_with;
use crate::tool::Tool;

/// The folder of the files of workers begins so, in that of the run; the number of the process that they work for follows, since a
/// worker whose run was killed may be there a moment longer.
const FOLDER: &str = "worker-";
/// How often a worker is started again that somebody has ended, before it counts as the backend's fault, or as an end of the run.
const AGAIN: u32 = 2;
/// How long an end of the run may take to be told of here, where it was told to a worker, too.
const HEARSAY: Duration = Duration::from_millis(200);
/// The codes of a worker that has done its work: with the last one, an engine has run out of time.
const FINE: [u8; 4] = [OK, UNEXPECTED, UNEXPECTED_PASS, INCOMPLETE];
/// The codes of a worker that could not: there is no room on the disk, or the suite is another one by now.
const UNABLE: [u8; 3] = [USAGE, NOTHING_SELECTED, CORPUS];
/// The scene, suite and time limit of a worker.
pub struct Worker<'a> {
    pub permutations: Option<usize>,
    pub threads: Option<usize>,
    pub cache: Option<&'a Path>,
    /// A folder for its files, which no other process writes: see [`folder`].
    pub folder: PathBuf,
    /// The suite, by name or file.
    pub suite: String,
    /// The files of engines, by the backends' names.
    pub engines: &'a BTreeMap<String, String>,
    pub scene: &'a PlannedScene,
    /// None where nothing but Ctrl-C ends it.
    pub limit: Option<Duration>,
    pub level: Level,
    /// Whether every answer is written.
    pub answers: bool,
}

/// The rows that a worker has left.
pub struct Found {
    pub summary: Vec<SummaryRow>,
    pub findings: Vec<FindingRow>,
    pub stages: Vec<StageRow>,
    pub more: Vec<Record>,
    /// Pictures with their names.
    pub maps: Vec<(String, Vec<u8>)>,
}

/// How a worker has ended.
enum Done {
    /// With rows, or with what it died of as a row.
    Found(Box<Found>),
    /// By a signal that no program sends itself; what its row would be.
    Killed(Box<Found>),
    /// Because it, or this process, was asked to.
    Stopped,
}

impl Done {
    fn found(found: Found) -> Done {
        Done::Found(Box::new(found))
    }
}

/// The folder for the files of workers of this process, in that of the run.
pub fn folder(run: &Path) -> PathBuf {
    run.join(format!("{FOLDER}{}", std::process::id()))
}

/// Takes away what runs that were killed have left of their workers in the folder of a run.
pub fn clear(run: &Path) {
    for entry in std::fs::read_dir(run).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(FOLDER) {
            let _ = std::fs::remove_dir_all(entry.path());
        }
    }
}

/// Whether this process is told to stop before a while is over.
fn was_interrupted_within(while_: Duration) -> bool {
    let start = Instant::now();
    while !interrupt::flag().load(Ordering::Relaxed) && start.elapsed() < while_ {
        std::thread::sleep(Duration::from_millis(2));
    }
    interrupt::flag().load(Ordering::Relaxed)
}

/// Whether a worker has ended since it was asked to: it says so by its code, and by rows that are not all there.
fn was_stopped(status: Option<ExitStatus>, run: &Path) -> bool {
    let ended = status.and_then(|status| status.code()) == Some(i32::from(INCOMPLETE));
    let outcome = || RunDir::open(run).map(|dir| dir.outcome);
    (ended && outcome().is_ok_and(|outcome| outcome == Outcome::Interrupted)) || was_signalled(status, &[1, 2, 15])
}

/// Whether a worker was killed outright: by somebody, or by the system where memory runs out.
fn was_killed(status: Option<ExitStatus>) -> bool {
    was_signalled(status, &[9])
}

/// Whether a process was ended by one of these signals.
fn was_signalled(status: Option<ExitStatus>, signals: &[i32]) -> bool {
    #[cfg(unix)]
    return status
        .and_then(|status| std::os::unix::process::ExitStatusExt::signal(&status))
        .is_some_and(|signal| signals.contains(&signal));
    #[cfg(not(unix))]
    return {
        let _ = (status, signals);
        false
    };
}

impl Worker<'_> {
    /// Runs one backend; none where the tool was interrupted.
    ///
    /// A worker that somebody has ended, such as a batch system that ends what it finds, is started again: what it works for is not to
    /// blame. One that is killed time and again is out of memory, as far as anybody can tell.
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
        let said = Said::of(child.stderr.take());
        Ok(match wait(&mut child, self.limit) {
            End::Interrupt => Done::Stopped,
            End::Limit(limit) => {
                Done::found(self.fate(backend, Class::Timeout, "time limit", format!("took longer than {limit:?}")))
            }
            // Ctrl-C reaches both processes; the other one may have ended before this one looked.
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

    /// The rows that a worker has left; none where it ended before they were all there, whatever its code.
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
        child::start(command)
    }

    /// The rows of a worker that left none.
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

/// What a worker says on stderr. It goes through a pipe: into a file on a full disk it could not say that the disk is full.
struct Said {
    bytes: Arc<Mutex<Vec<u8>>>,
    listener: Option<JoinHandle<()>>,
}

impl Said {
    /// Listens until the other end is closed; keeps the end of what is said.
    fn of(stderr: Option<ChildStderr>) -> Said {
        const MOST: usize = 1 << 16;
        let bytes = Arc::new(Mutex::new(Vec::new()));
        let heard = Arc::clone(&bytes);
        let listen = |mut stderr: ChildStderr| {
            std::thread::spawn(move || {
                let mut piece = [0; 4096];
                while let Ok(count @ 1..) = stderr.read(&mut piece) {
                    let mut heard = heard.lock().unwrap_or_else(PoisonError::into_inner);
                    heard.extend_from_slice(&piece[..count]);
                    let old = heard.len().saturating_sub(MOST);
                    heard.drain(..old);
                }
            })
        };
        Said { bytes, listener: stderr.map(listen) }
    }

    /// The text, once the worker has ended. A process that it has left behind may hold the pipe, and is not waited for.
    fn text(&self) -> String {
        let start = Instant::now();
        while self.listener.as_ref().is_some_and(|listener| !listener.is_finished()) && start.elapsed() < FAREWELL {
            std::thread::sleep(Duration::from_millis(1));
        }
        String::from_utf8_lossy(&self.bytes.lock().unwrap_or_else(PoisonError::into_inner)).into_owned()
    }
}

/// Why a worker could not do its work, where it has said so itself: that is no row of a backend.
fn unable(status: Option<ExitStatus>, said: &str) -> Option<Failure> {
    let code = status.and_then(|status| status.code());
    let code = UNABLE.into_iter().find(|&unable| code == Some(i32::from(unable)))?;
    let line = said.lines().rfind(|line| !line.trim().is_empty())?;
    let message = line.strip_prefix(&program())?.strip_prefix(": ")?;
    Some(Failure { message: message.to_owned(), code })
}

/// What a worker died of: the name of the check, and what is known.
fn death(status: Option<ExitStatus>, said: &str) -> (&'static str, String) {
    let lines: Vec<&str> = said.lines().filter(|line| !line.trim().is_empty()).collect();
    if let Some(line) = lines.iter().find(|line| line.starts_with("memory allocation of ")) {
        return ("out of memory", (*line).to_owned());
    }
    if let Some(line) = lines.iter().find(|line| line.contains("has overflowed its stack")) {
        return ("crashed", line.trim().to_owned());
    }
    let last = lines.last().map_or_else(|| "without a word".to_owned(), |last| printable(last));
    #[cfg(unix)]
    if let Some(signal) = status.and_then(|status| std::os::unix::process::ExitStatusExt::signal(&status)) {
        // Nobody but the system sends this one, where memory runs out.
        let (check, name) = match signal {
            9 => ("out of memory", "killed by the system"),
            6 => ("crashed", "abort"),
            11 => ("crashed", "segmentation fault"),
            _ => ("crashed", "signal"),
        };
        return (check, format!("{name} (signal {signal}): {last}"));
    }
    let code = status.and_then(|status| status.code());
    (
        "crashed",
        format!("ended with code {}: {last}", code.map_or_else(|| "unknown".to_owned(), |code| code.to_string())),
    )
}

/// A line that is safe to print: control characters escaped, the rest of a long one left out.
fn printable(line: &str) -> String {
    const MOST: usize = 300;
    let escaped: String = line.trim().chars().take(MOST).flat_map(char::escape_debug).collect();
    if line.chars().nth(MOST).is_some() { escaped + "…" } else { escaped }
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::process::ExitStatusExt;

    use super::*;

    #[test]
    fn each_death_has_its_name() {
        let code = |code: i32| Some(ExitStatus::from_raw(code << 8));
        let long = format!("thread 'main' panicked\n{}\u{1b}[2J", "x".repeat(400));
        for (status, said, check, message) in [
            (Some(ExitStatus::from_raw(9)), "", "out of memory", "killed by the system (signal 9): without a word"),
            (Some(ExitStatus::from_raw(11)), "a\n\n", "crashed", "segmentation fault (signal 11): a"),
            (Some(ExitStatus::from_raw(6)), "", "crashed", "abort (signal 6): without a word"),
            (
                Some(ExitStatus::from_raw(6)),
                "memory allocation of 99 bytes failed\nnote",
                "out of memory",
                "memory allocation of 99 bytes failed",
            ),
            (code(101), "b", "crashed", "ended with code 101: b"),
            (None, "", "crashed", "ended with code unknown: without a word"),
        ] {
            assert_eq!(death(status, said), (check, message.to_owned()));
        }
        let (_, message) = death(code(2), &long);
        assert!(message.chars().count() < 350 && !message.contains(char::is_control), "{message}");
    }
}
