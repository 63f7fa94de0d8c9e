//! A run in parts by engines that start commands: GNU parallel, HyperQueue and Slurm, each for real, on this machine.
//!
//! For each engine, one running part is killed from outside without a warning; for Slurm with two nodes, all processes
//! of one node. The engine must start it again, and the merged result must equal the run of one process, byte for byte.
//! A missing engine is a failure that says so.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::command::{answers, cargo, fresh, root, step, target_directory};

/// The folder of the work, beside the build.
const SPREAD: &str = "target/spread";
/// The folder for HyperQueue if Python does not have it.
const PYTHON: &str = "target/hyperqueue";
/// The arguments of the run: some seconds per part, so that one can be killed while it runs.
const WHAT: [&str; 5] = ["classics", "families", "constructed", "-b", "exact,sos,naive"];
const PARTS: u32 = 5;
/// The part that is killed.
const VICTIM: u32 = 2;
/// The files of a run that record machine and duration, and may differ.
const DIFFER: [&str; 2] = ["env.json", "costs.csv"];
/// The processes that are killed.
#[derive(Clone, Copy)]
enum Loss {
    /// The process that runs a part.
    Process,
    /// All processes of the node that runs a part; the folder has a file with the process that holds its namespace.
    Node,
}

/// The time limit for Slurm: it holds a requeued job for two minutes.
const PATIENCE: Duration = Duration::from_secs(600);

/// Runs the embedded scenes in parts by each engine.
///
/// # Errors
/// For each engine, that it is missing, or that something was lost, duplicated or not started again.
pub fn check() -> Result<(), String> {
    cargo("build the tool", &["build", "--profile", "ci"])?;
    let folder = root().join(fresh(SPREAD)?);
    let folder = folder.canonicalize().map_err(|error| format!("{}: {error}", folder.display()))?;
    let tool = target_directory()?.join("ci").join("predicament");
    let spread = Spread { one: folder.join("one"), folder, tool };
    let (tool, one) = (shown(&spread.tool), shown(&spread.one));
    let run: Vec<String> =
        [tool.as_str(), "run", "--quiet", "--out", &one].iter().chain(&WHAT).map(|&word| word.to_owned()).collect();
    step("the run of one process", &run, &[])?;
    let done = [spread.parallel(), spread.hyperqueue(), spread.slurm(Loss::Process), spread.slurm(Loss::Node)];
    let failed: Vec<String> = done.into_iter().filter_map(Result::err).collect();
    if failed.is_empty() { Ok(()) } else { Err(failed.join("; ")) }
}

struct Spread {
    folder: PathBuf,
    tool: PathBuf,
    /// The folder of the run of one process.
    one: PathBuf,
}

impl Spread {
    fn parallel(&self) -> Result<(), String> {
        if !answers("parallel", &["--version"]) {
            return Err("GNU parallel is not there, so nothing was spread by it; `apt install parallel`".to_owned());
        }
        self.by("GNU parallel", "parallel", &[&script("parallel.sh")], &[], kill, || Ok(()))
    }

    fn hyperqueue(&self) -> Result<(), String> {
        let has = |python: &str| answers(python, &["-c", "import hyperqueue"]);
        let own = shown(&root().join(PYTHON).join("bin/python"));
        if !has("python3") && !has(&own) {
            let venv = ["python3", "-m", "venv", PYTHON].map(str::to_owned);
            let install = [own.as_str(), "-m", "pip", "install", "--quiet", "hyperqueue"].map(str::to_owned);
            let installed =
                step("a place for HyperQueue", &venv, &[]).and_then(|()| step("install HyperQueue", &install, &[]));
            installed.map_err(|why| format!("HyperQueue is not there, so nothing was spread by it: {why}"))?;
        }
        let python = if has("python3") { "python3".to_owned() } else { own };
        self.by("HyperQueue", "hyperqueue", &[&python, &script("hyperqueue_parts.py")], &[], kill, || Ok(()))
    }

    fn slurm(&self, loss: Loss) -> Result<(), String> {
        // Without a configuration its programs do not even print their version.
        if !answers(
            "sh",
            &["-c", "PATH=$PATH:/usr/sbin; command -v sbatch && command -v slurmd && command -v slurmctld"],
        ) {
            return Err("Slurm is not there, so nothing was spread by it; `apt install slurm-wlm`".to_owned());
        }
        let (engine, name, nodes) = match loss {
            Loss::Process => ("Slurm", "slurm", "1"),
            Loss::Node => ("Slurm with two nodes", "slurm-nodes", "2"),
        };
        let place = self.folder.join(format!("{name}-here"));
        let here = script("slurm-here.sh");
        let [start, stop] = [nodes, "stop"].map(|what| [&here, &shown(&place), what].map(str::to_owned));
        let conf = shown(&place.join("slurm.conf"));
        let env = [("SLURM_CONF", conf.as_str())];
        let lose = |part: &Path| match loss {
            Loss::Process => kill(part),
            Loss::Node => kill_node(part, &place),
        };
        let done = step(&format!("start {engine}"), &start, &[]).and_then(|()| {
            self.by(engine, name, &[&script("slurm.sh")], &env, lose, || {
                let start = Instant::now();
                while start.elapsed() < PATIENCE {
                    let told = Command::new("squeue").arg("--noheader").envs(env).output();
                    if told.is_ok_and(|told| told.status.success() && told.stdout.is_empty()) {
                        return Ok(());
                    }
                    sleep(Duration::from_secs(1));
                }
                Err(format!("Slurm had jobs left after {} s", PATIENCE.as_secs()))
            })
        });
        done.and(step(&format!("stop {engine}"), &stop, &[]))
    }

    /// Runs the parts by an engine, kills the victim, and compares the merged result with the run of one process.
    fn by(
        &self,
        engine: &str,
        name: &str,
        start: &[&str],
        env: &[(&str, &str)],
        lose: impl Fn(&Path) -> Option<String> + Sync,
        wait: impl Fn() -> Result<(), String>,
    ) -> Result<(), String> {
        let folder = shown(&self.folder.join(name));
        let (parts, tool, one) = (PARTS.to_string(), shown(&self.tool), shown(&self.one));
        let more = [parts.as_str(), &folder].into_iter().chain(WHAT).chain(["--costs", &one]);
        let words: Vec<String> = start.iter().copied().chain(more).map(str::to_owned).collect();
        let env = env.iter().map(|&(name, value)| (name, value.to_owned())).chain([("PREDICAMENT", tool.clone())]);
        let env: Vec<_> = env.collect();
        let is_over = AtomicBool::new(false);
        let (done, killed) = std::thread::scope(|scope| {
            let killer = scope.spawn(|| once_begun(&Path::new(&folder).join(VICTIM.to_string()), &is_over, &lose));
            let done = step(&format!("{PARTS} parts by {engine}"), &words, &env).and_then(|()| wait());
            is_over.store(true, Ordering::Relaxed);
            (done, killer.join().unwrap_or(None))
        });
        done?;
        let Some(killed) = killed else {
            return Err(format!("{engine}: part {VICTIM} was over before it could be killed"));
        };
        let whole = Path::new(&folder).join("whole");
        same(&self.one, &whole).map_err(|why| format!("{engine}: {why}"))?;
        let env = read(&whole.join("env.json"))?;
        let named = env.matches(&format!("/{PARTS} on ")).count();
        if named != PARTS as usize {
            return Err(format!("{engine}: env.json names the machines of {named} parts"));
        }
        let pages = shown(&self.folder.join(format!("{name}-pages")));
        let report = [tool.as_str(), "report", &shown(&whole), "--out", &pages].map(str::to_owned);
        step(&format!("report of the parts by {engine}"), &report, &[])?;
        if !read(&Path::new(&pages).join("report.md"))?.contains(&format!("1/{PARTS} on ")) {
            return Err(format!("{engine}: the report names no machines"));
        }
        println!(
            "== {engine}: part {VICTIM} was lost with {killed} and started again; the whole is that of one process"
        );
        Ok(())
    }
}

/// Kills the process of a part once it has committed something; returns what was killed, or `None` if the part had
/// ended.
fn once_begun(part: &Path, is_over: &AtomicBool, lose: impl Fn(&Path) -> Option<String>) -> Option<String> {
    while !is_over.load(Ordering::Relaxed) {
        let rows = std::fs::read_to_string(part.join("segments.csv")).unwrap_or_default();
        if rows.lines().count() > 3
            && let Some(lost) = lose(part)
        {
            return Some(lost);
        }
        sleep(Duration::from_millis(5));
    }
    None
}

/// Kills the process that writes a part.
fn kill(part: &Path) -> Option<String> {
    let pid = writer_of(part)?.to_string();
    answers("kill", &["-9", &pid]).then(|| format!("process {pid}"))
}

/// Kills all processes of the node where a part is written.
fn kill_node(part: &Path, nodes: &Path) -> Option<String> {
    let environment = std::fs::read(format!("/proc/{}/environ", writer_of(part)?)).ok()?;
    let node = environment.split(|&byte| byte == 0).find_map(|entry| entry.strip_prefix(b"SLURMD_NODENAME="))?;
    let node = String::from_utf8_lossy(node).into_owned();
    let pid = std::fs::read_to_string(nodes.join(format!("{node}.pid"))).ok()?;
    answers("kill", &["-9", pid.trim()]).then(|| format!("all processes of {node}"))
}

/// The process that runs into a folder.
fn writer_of(part: &Path) -> Option<u32> {
    let part = shown(part);
    for entry in std::fs::read_dir("/proc").ok()?.flatten() {
        let Some(pid) = entry.file_name().to_str().and_then(|name| name.parse().ok()) else { continue };
        let line = std::fs::read(entry.path().join("cmdline")).unwrap_or_default();
        let words: Vec<String> =
            line.split(|&byte| byte == 0).map(|word| String::from_utf8_lossy(word).into_owned()).collect();
        let is_tool = words.first().is_some_and(|program| program.ends_with("/predicament"));
        if is_tool && words.windows(2).any(|pair| pair == ["--out", &part]) {
            return Some(pid);
        }
    }
    None
}

/// Checks that two run folders have the same files, except those that may differ.
fn same(one: &Path, other: &Path) -> Result<(), String> {
    let (ours, theirs) = (files(one, one)?, files(other, other)?);
    if ours != theirs {
        let differ: Vec<&String> = ours.symmetric_difference(&theirs).collect();
        return Err(format!("{} and {} have other files: {differ:?}", one.display(), other.display()));
    }
    let bytes = |path: PathBuf| std::fs::read(&path).map_err(|error| format!("{}: {error}", path.display()));
    for file in &ours {
        if bytes(one.join(file))? != bytes(other.join(file))? {
            return Err(format!("{file} is not that of the run of one process"));
        }
    }
    Ok(())
}

/// The files of a folder by name, without those that may differ.
fn files(folder: &Path, here: &Path) -> Result<BTreeSet<String>, String> {
    let mut all = BTreeSet::new();
    for entry in std::fs::read_dir(here).map_err(|error| format!("{}: {error}", here.display()))?.flatten() {
        let path = entry.path();
        if path.is_dir() {
            all.extend(files(folder, &path)?);
        } else if let Ok(name) = path.strip_prefix(folder) {
            let name = shown(name);
            all.extend((!DIFFER.contains(&name.as_str())).then_some(name));
        }
    }
    Ok(all)
}

fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn script(name: &str) -> String {
    shown(&root().join("tools/shards").join(name))
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_differs_is_named() {
        let folder = std::env::temp_dir().join(format!("predicament-spread-{}", std::process::id()));
        let [one, other] = ["one", "other"].map(|name| folder.join(name));
        let write = |place: &Path, name: &str, text: &str| {
            let path = place.join(name);
            std::fs::create_dir_all(path.parent().expect("a folder")).expect("it can be made");
            std::fs::write(path, text).expect("it can be written");
        };
        for (place, time) in [(&one, "1"), (&other, "2")] {
            write(place, "costs.csv", time);
            write(place, "maps/a.png", "a");
        }
        assert_eq!(same(&one, &other), Ok(()));
        write(&other, "maps/a.png", "b");
        assert!(same(&one, &other).is_err_and(|why| why.contains("maps/a.png is not that")));
        write(&other, "summary.csv", "");
        assert!(same(&one, &other).is_err_and(|why| why.contains("summary.csv")));
        std::fs::remove_dir_all(folder).expect("it is removed");
    }
}
