//! Runs a scene on a backend in a process of its own, which a time limit can end.
//!
//! An algorithm that runs on a whole scene looks at no clock. Under a time limit
//! it runs where it can be ended: in another process of the same program, whose
//! run folder is read back.

use std::fs::File;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use predicament_records::{FindingRow, PlannedScene, Record, RunDir, StageRow, Status, SummaryRow};
use predicament_tasks::{Class, Finding, finding_id};

use crate::cmd::run::{Args, tables};
use crate::exit::{Failure, OK, UNEXPECTED, UNEXPECTED_PASS};
use crate::interrupt;
use crate::tool::Tool;

/// The scene, suite and time limit of a worker.
pub struct Worker<'a> {
    pub args: &'a Args,
    /// The suite, by name or file.
    pub suite: String,
    pub scene: &'a PlannedScene,
    pub limit: Duration,
}

/// The rows that a worker has left.
pub struct Found {
    pub summary: Vec<SummaryRow>,
    pub findings: Vec<FindingRow>,
    pub stages: Vec<StageRow>,
    pub more: Vec<Record>,
}

/// How a worker came to its end.
enum End {
    Exit(Option<i32>),
    Limit,
    Interrupt,
}

impl Worker<'_> {
    /// Runs one backend; none where the tool was interrupted.
    pub fn run(&self, tool: &Tool, backend: &str) -> Result<Option<Found>, Failure> {
        let folder = std::env::temp_dir().join(format!("predicament-worker-{}", std::process::id()));
        let cannot = |what: &Path, error: std::io::Error| Failure::usage(format!("{}: {error}", what.display()));
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).map_err(|error| cannot(&folder, error))?;
        let (run, errors) = (folder.join("run"), folder.join("stderr"));
        let stderr = File::create(&errors).map_err(|error| cannot(&errors, error))?;
        let mut child = self.command(backend, &run, stderr)?;
        let found = match self.wait(&mut child) {
            End::Interrupt => None,
            End::Limit => {
                let said = format!("took longer than {:?}", self.limit);
                Some(self.fate(backend, Class::Timeout, "time limit", said))
            }
            End::Exit(Some(code)) if [OK, UNEXPECTED, UNEXPECTED_PASS].map(i32::from).contains(&code) => {
                let dir = RunDir::open(&run).map_err(Failure::usage)?;
                let more = tables(tool).into_iter().flat_map(|table| dir.records(table)).collect();
                Some(Found { summary: dir.summary, findings: dir.findings, stages: dir.stages, more })
            }
            End::Exit(code) => {
                let said = std::fs::read_to_string(&errors).unwrap_or_default();
                let last = said.lines().last().unwrap_or("without a word").to_owned();
                let code = code.map_or_else(|| "a signal".to_owned(), |code| format!("code {code}"));
                Some(self.fate(backend, Class::Panic, "process", format!("ended with {code}: {last}")))
            }
        };
        let _ = std::fs::remove_dir_all(&folder);
        Ok(found)
    }

    fn command(&self, backend: &str, run: &Path, stderr: File) -> Result<Child, Failure> {
        let program = std::env::current_exe().map_err(|error| Failure::usage(format!("this program: {error}")))?;
        let mut command = Command::new(program);
        let filter = format!("^{}$", regex::escape(&format!("{}/{}", self.scene.suite, self.scene.scene)));
        command.args(["run", &self.suite, "-f", &filter, "-b", backend]);
        command.args(["--level", self.args.selector.level.name()]).arg("--out").arg(run);
        if let Some(permutations) = self.args.permutations {
            command.args(["--permutations", &permutations.to_string()]);
        }
        if let Some(threads) = self.args.threads {
            command.args(["--threads", &threads.to_string()]);
        }
        if let Some(cache) = &self.args.selector.cache {
            command.arg("--cache").arg(cache);
        }
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(stderr);
        command.spawn().map_err(|error| Failure::usage(format!("a worker did not start: {error}")))
    }

    /// Waits for the end, and makes one where the time is over.
    fn wait(&self, child: &mut Child) -> End {
        let start = Instant::now();
        loop {
            let end = match child.try_wait() {
                Ok(Some(status)) => return End::Exit(status.code()),
                Ok(None) if interrupt::flag().load(Ordering::Relaxed) => End::Interrupt,
                Ok(None) if start.elapsed() > self.limit => End::Limit,
                Ok(None) => {
                    std::thread::sleep(Duration::from_millis(2));
                    continue;
                }
                Err(_) => End::Exit(None),
            };
            let _ = child.kill();
            let _ = child.wait();
            return end;
        }
    }

    /// The rows of a worker that left none.
    fn fate(&self, backend: &str, class: Class, check: &str, said: String) -> Found {
        let scene = self.scene;
        let finding = Finding::plain(class, check, Vec::new(), said, String::new());
        let mut summary = SummaryRow::new(scene, backend, scene.queries, Status::Unexpected);
        *summary.count_mut(class) = 1;
        let finding = crate::rows::finding(scene, backend, &finding, finding_id(&scene.scene_id, backend, &finding));
        Found { summary: vec![summary], findings: vec![finding], stages: Vec::new(), more: Vec::new() }
    }
}
