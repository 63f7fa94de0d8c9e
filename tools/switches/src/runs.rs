//! Runs of the built tool: what a suite reaches, and whether it notices a change.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// The time limit of a hunt.
const HUNT: Duration = Duration::from_secs(60);

/// The built tool, and the folder of its runs.
pub struct Tool {
    pub program: PathBuf,
    pub out: PathBuf,
    /// Evaluations of a hunt for a change that the quick run has not noticed.
    pub evaluations: u32,
}

/// A suite with the switches that it reaches, and the time that it takes.
pub struct Suite {
    pub name: String,
    /// System, number, and the bits of its outcomes: false, true, and another change.
    pub reached: BTreeSet<(String, usize, u8)>,
    pub took: Duration,
}

/// The step that noticed a change.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Notice {
    Run,
    Gate,
    /// The run did not end in twenty times its time.
    Endless,
    /// Only a hunt for other scenes.
    Hunt,
    /// Nothing, and the quick run reaches the place.
    Nothing,
    /// Nothing, and the quick run does not reach the place.
    Unreached,
}

impl Tool {
    /// Runs the tool with a switch on; returns its exit code, or `None` after the limit.
    fn call(&self, words: &[&str], variable: [&str; 2], limit: Duration) -> Result<Option<i32>, String> {
        let mut command = Command::new(&self.program);
        command.args(words).env(variable[0], variable[1]).stdout(Stdio::null()).stderr(Stdio::null());
        let mut child = command.spawn().map_err(|why| format!("{}: {why}", self.program.display()))?;
        let started = Instant::now();
        loop {
            if let Some(status) = child.try_wait().map_err(|why| why.to_string())? {
                // (A crash has no code.)
                return Ok(Some(status.code().unwrap_or(-1)));
            }
            if started.elapsed() > limit {
                child.kill().and_then(|()| child.wait()).map_err(|why| why.to_string())?;
                return Ok(None);
            }
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    fn folder(&self, name: &str) -> Result<PathBuf, String> {
        let folder = self.out.join(name);
        if folder.exists() {
            std::fs::remove_dir_all(&folder).map_err(|why| format!("{}: {why}", folder.display()))?;
        }
        Ok(folder)
    }

    /// The embedded suites that need no download.
    pub fn suites(&self) -> Result<Vec<String>, String> {
        let output = Command::new(&self.program).args(["corpus", "list"]).output().map_err(|why| why.to_string())?;
        let told = String::from_utf8_lossy(&output.stdout).into_owned();
        let lines = told.lines().filter(|line| !line.contains("corpus fetch"));
        Ok(lines.filter_map(|line| line.split_whitespace().next()).map(str::to_owned).collect())
    }

    /// Runs a suite without a change.
    ///
    /// # Errors
    /// If the run has unexpected findings.
    pub fn reach(&self, suite: &str) -> Result<Suite, String> {
        let [folder, seen] = [self.folder("run")?, self.out.join(format!("{suite}.seen"))];
        let _ = std::fs::remove_file(&seen);
        let started = Instant::now();
        let out = folder.display().to_string();
        let variable = ["PREDICAMENT_SEEN", &seen.display().to_string()];
        let code = self.call(&["run", suite, "--quiet", "--out", &out], variable, Duration::from_secs(600))?;
        if code != Some(0) {
            return Err(format!("switches: without a change, the run of {suite} ends with {code:?}"));
        }
        let text = std::fs::read_to_string(&seen).unwrap_or_default();
        let read = |line: &str| {
            let mut words = line.split(' ');
            Some((words.next()?.to_owned(), words.next()?.parse().ok()?, words.next()?.parse().ok()?))
        };
        Ok(Suite { name: suite.to_owned(), reached: text.lines().filter_map(read).collect(), took: started.elapsed() })
    }

    /// The first step that notices a change: the quick run of these suites, or the gate.
    pub fn notices(&self, change: &str, suites: &[&Suite]) -> Result<Notice, String> {
        let variable = ["PREDICAMENT_SWITCH", change];
        for suite in suites {
            let out = self.folder("run")?.display().to_string();
            let limit = 20 * suite.took + Duration::from_secs(20);
            match self.call(&["run", &suite.name, "--quiet", "--out", &out], variable, limit)? {
                None => return Ok(Notice::Endless),
                Some(0) => {}
                Some(_) => return Ok(Notice::Run),
            }
            if self.call(&["gate", &out], variable, limit)? != Some(0) {
                return Ok(Notice::Gate);
            }
        }
        Ok(Notice::Nothing)
    }

    /// The classes and checks that a hunt for scenes of a task finds.
    pub fn hunted(&self, change: &str, task: &str) -> Result<BTreeSet<String>, String> {
        let folder = self.folder("hunt")?;
        let [out, evaluations] = [folder.display().to_string(), self.evaluations.to_string()];
        let words =
            ["hunt", task, "-b", "exact", "--evaluations", &evaluations, "--seconds", "10", "-q", "--out", &out];
        match self.call(&words, ["PREDICAMENT_SWITCH", change], HUNT)? {
            Some(_) => Ok(finds(&folder)),
            // (One scene may take long without a change, too.)
            None => Ok(BTreeSet::new()),
        }
    }
}

fn finds(folder: &Path) -> BTreeSet<String> {
    let table = std::fs::read_to_string(folder.join("hunt.csv")).unwrap_or_default();
    table.lines().skip(1).map(|line| line.split(',').skip(2).take(2).collect::<Vec<_>>().join(" ")).collect()
}
