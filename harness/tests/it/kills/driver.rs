//! The runs that are killed and compared: a small run in several shapes, and the ways to resume it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::{TempDir, tempdir};

use crate::common::{Told, told, tool};

/// The file that may differ, because it has the machine and the command line.
pub const OF_THE_MACHINE: &str = "env.json";
/// The file with the times of scenes, which differs from run to run.
const OF_TIMES: &str = "costs.csv";
/// The number of parts of a run that is split.
pub const PARTS: u32 = 2;

/// The shapes of a run.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Shape {
    /// In one process.
    Plain,
    /// Each scene and backend in a separate process.
    Apart,
    /// A part of a run.
    Part(u32),
}

impl Shape {
    /// The arguments of the run, without the folder.
    pub fn words(self) -> Vec<String> {
        // Signs, ties, a mesh and a map of a plane; or a picture of single signs, which is written with its rows. The
        // last two take long enough to be killed.
        let many = "ties/(grid-(4x4|3x3x3)-(compare|orient)|cube)|lecture/(ear|cascade|split)|tilings/bricks$";
        let some = "ties/(grid-4x4-(compare|orient)|cube)|lecture/(ear|cascade|split)|tilings/bricks$";
        let scenes = match self {
            Shape::Apart => "kettner-(a1|pixels-a)$",
            _ if predicament_effort::whole() => many,
            _ => some,
        };
        let suites: &[&str] = if self == Shape::Apart { &["classics"] } else { &["ties", "lecture", "tilings"] };
        let mut words = [&["run"], suites, &["-f", scenes, "-b", "exact,sos,naive", "--quiet"]].concat();
        let part = if let Shape::Part(k) = self { format!("{k}/{PARTS}") } else { String::new() };
        match self {
            Shape::Plain => words.push("--answers"),
            Shape::Apart => words.push("--isolate=always"),
            Shape::Part(_) => words.extend(["--answers", "--shard", &part]),
        }
        words.into_iter().map(str::to_owned).collect()
    }

    /// The arguments that resume the run.
    pub fn resume(self, folder: &str) -> Vec<String> {
        let mut words = vec!["run".to_owned(), "--quiet".to_owned(), "--resume".to_owned(), folder.to_owned()];
        words.extend((self == Shape::Apart).then(|| "--isolate=always".to_owned()));
        words
    }
}

/// The number of bytes of all files of a folder.
pub fn size(folder: &Path) -> u64 {
    let mut all = 0;
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        all += match entry.metadata() {
            Ok(found) if found.is_dir() => size(&entry.path()),
            Ok(found) => found.len(),
            Err(_) => 0,
        };
    }
    all
}

/// The bytes of all files of a folder, by path.
pub type Files = BTreeMap<String, Vec<u8>>;

/// The files that have to be the same as in an undisturbed run.
pub fn files(folder: &Path) -> Files {
    let mut all = Files::new();
    let mut left = vec![folder.to_owned()];
    while let Some(here) = left.pop() {
        for entry in std::fs::read_dir(&here).unwrap_or_else(|error| panic!("{}: {error}", here.display())) {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(folder).unwrap().display().to_string();
            if path.is_dir() {
                left.push(path);
            } else if name != OF_THE_MACHINE && name != OF_TIMES {
                all.insert(name, std::fs::read(&path).unwrap());
            }
        }
    }
    all
}

/// The names of the files that differ.
pub fn differing(one: &Files, other: &Files) -> Vec<String> {
    let names = one.keys().chain(other.keys());
    let mut names: Vec<String> = names.filter(|&name| one.get(name) != other.get(name)).cloned().collect();
    names.sort();
    names.dedup();
    names
}

/// The tool with these arguments.
pub fn words_of(words: &[String]) -> Command {
    tool(&words.iter().map(String::as_str).collect::<Vec<_>>())
}

/// Starts the tool without output, as the leader of a process group.
pub fn start(words: &[String]) -> Child {
    let mut command = words_of(words);
    command.stdout(Stdio::null()).stderr(Stdio::null());
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    command.spawn().expect("the tool starts")
}

/// Sends a signal to a process, or to a process group if the number is negative. The process may have ended.
pub fn signal(name: &str, process: i64) {
    let status = Command::new("kill")
        .args([&format!("-{name}"), "--", &process.to_string()])
        .stderr(Stdio::null())
        .status()
        .expect("there is `kill`");
    let _ = status;
}

/// The running child processes of a process.
pub fn children(of: u32) -> Vec<u32> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir("/proc").into_iter().flatten().flatten() {
        let Some(id) = entry.file_name().to_str().and_then(|name| name.parse().ok()) else { continue };
        let stat = std::fs::read_to_string(entry.path().join("stat")).unwrap_or_default();
        // The state and the parent follow the name in brackets.
        let parent = stat.rsplit_once(')').and_then(|(_, rest)| rest.split_whitespace().nth(1)?.parse().ok());
        if parent == Some(of) {
            found.push(id);
        }
    }
    found
}

/// The undisturbed runs, and a folder for the disturbed ones.
pub struct Bench {
    folder: TempDir,
    whole: BTreeMap<Shape, (Files, Duration)>,
}

impl Bench {
    /// Makes undisturbed runs of these shapes.
    pub fn new(shapes: &[Shape]) -> Bench {
        let folder = tempdir().unwrap();
        let mut bench = Bench { folder, whole: BTreeMap::new() };
        for &shape in shapes {
            let out = bench.place(&format!("whole {shape:?}"));
            let begun = Instant::now();
            let told = bench.run(&with_out(shape.words(), &out));
            assert!([0, 100].contains(&told.code), "{shape:?}: {}", told.stderr);
            let taken = begun.elapsed();
            bench.whole.insert(shape, (files(&out), taken));
        }
        bench
    }

    /// Makes undisturbed runs of a whole run, its parts and more shapes, and merges the parts once.
    pub fn with_parts(more: &[Shape]) -> Bench {
        let parts = (1..=PARTS).map(Shape::Part);
        let shapes: Vec<Shape> = [Shape::Plain].into_iter().chain(parts).chain(more.iter().copied()).collect();
        let bench = Bench::new(&shapes);
        let out = bench.place("merged");
        let told = bench.run(&bench.merge(&out));
        assert!([0, 100].contains(&told.code), "{}", told.stderr);
        assert_eq!(differing(&files(&out), bench.whole(Shape::Plain)), [""; 0], "merged is the whole");
        bench
    }

    /// A path in the folder of disturbed runs.
    pub fn place(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The files of an undisturbed run.
    pub fn whole(&self, shape: Shape) -> &Files {
        &self.whole[&shape].0
    }

    /// The time of an undisturbed run.
    pub fn time(&self, shape: Shape) -> Duration {
        self.whole[&shape].1
    }

    /// The number of bytes of the files of an undisturbed run.
    pub fn size(&self, shape: Shape) -> u64 {
        self.whole(shape).values().map(|bytes| bytes.len() as u64).sum()
    }

    /// The arguments that merge the undisturbed parts.
    pub fn merge(&self, out: &Path) -> Vec<String> {
        let parts = (1..=PARTS).map(|k| self.place(&format!("whole {:?}", Shape::Part(k))).display().to_string());
        with_out(["merge".to_owned()].into_iter().chain(parts).collect(), out)
    }

    /// Runs the tool until it ends.
    pub fn run(&self, words: &[String]) -> Told {
        told(words_of(words).output().expect("the tool starts"))
    }

    /// Resumes the run in a folder, or starts it if there is no plan, as a script would.
    pub fn go_on(&self, shape: Shape, out: &Path) -> Told {
        let words = if out.join("plan.json").exists() {
            shape.resume(&out.display().to_string())
        } else {
            with_out(shape.words(), out)
        };
        self.run(&words)
    }

    /// Resumes the run in a folder; returns the state before and the result.
    ///
    /// # Panics
    /// If the final files differ from those of the undisturbed run.
    pub fn settle(&self, shape: Shape, out: &Path, case: &str) -> (&'static str, &'static str) {
        let was = left(out);
        let told = self.go_on(shape, out);
        let became = match told.code {
            2 if was == "complete" && told.stderr.contains("there is nothing to resume") => "was complete",
            0 | 100 => "resumed: identical",
            code => panic!("{case}: what was left ({was}) is not gone on with: code {code}: {}", told.stderr),
        };
        let differ = differing(&files(out), self.whole(shape));
        assert!(differ.is_empty(), "{case}: after a folder with {was}, {became}, these files differ: {differ:?}");
        (was, became)
    }

    /// Merges again after a killed merge; returns the state before and the result.
    pub fn settle_merge(&self, out: &Path, case: &str) -> (&'static str, &'static str) {
        if out.exists() {
            assert!(
                differing(&files(out), self.whole(Shape::Plain)).is_empty(),
                "{case}: a merge is whole or not there"
            );
            return ("complete", "was complete");
        }
        let beside = merging(out);
        let was = if beside.exists() { "a folder beside" } else { "no folder" };
        let told = self.run(&self.merge(out));
        assert!([0, 100].contains(&told.code), "{case}: {}", told.stderr);
        assert!(!beside.exists(), "{case}: nothing is left beside it");
        let differ = differing(&files(out), self.whole(Shape::Plain));
        assert!(differ.is_empty(), "{case}: after {was} these files differ: {differ:?}");
        (was, "merged again: identical")
    }
}

/// The folder in which a merge collects its files.
pub fn merging(out: &Path) -> PathBuf {
    out.with_file_name(format!("{}.merging", out.file_name().unwrap().to_str().unwrap()))
}

/// The arguments with `--out`.
pub fn with_out(mut words: Vec<String>, out: &Path) -> Vec<String> {
    words.extend(["--out".to_owned(), out.display().to_string()]);
    words
}

/// The state of the folder of an ended run.
pub fn left(out: &Path) -> &'static str {
    let state = std::fs::read_to_string(out.join("state.json")).unwrap_or_default();
    if !out.join("plan.json").exists() {
        "no plan"
    } else if state.is_empty() {
        "a plan and no state"
    } else if state.contains("\"complete\"") {
        "complete"
    } else if state.contains("\"interrupted\"") {
        "interrupted"
    } else {
        "unfinished"
    }
}
