//! `shrink FILE… -- COMMAND {}`: the smallest files on which a command fails, in a folder.
//!
//! The folder has copies of the original files, the smallest files so far, the condition, and a journal with the digest
//! and the result of each run. A search that was ended is repeated from the original files: runs in the journal are not
//! made again. So the result is the same, byte for byte, as without the end.

mod trial;

use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use predicament_formats::{hex, read_bytes};
use predicament_records::replace;
use predicament_search::files::{Command, Counts, Digest, Halt, MOST_SINGLE, Search, Sketch, counts, digest};
use serde::{Deserialize, Serialize};

use crate::exit::{self, Failure};
use crate::out::{program, word};
use crate::progress::{Working, working};
use crate::{interrupt, planning};
use trial::Trial;
pub use trial::When;

/// The file with the condition; it makes a folder the folder of shrunk files.
pub const STATE: &str = "files.json";
const JOURNAL: &str = "journal.csv";
const ORIGINAL: &str = "original";

/// The options.
pub struct Ask<'a> {
    pub files: &'a [String],
    pub command: &'a [String],
    pub when: Option<&'a str>,
    pub timeout: Duration,
    pub out: Option<&'a Path>,
    pub resume: Option<&'a Path>,
}

/// The condition that a search keeps, and the digest of its original files.
#[derive(PartialEq, Serialize, Deserialize)]
struct State {
    command: Vec<String>,
    when: String,
    timeout: f64,
    names: Vec<String>,
    digest: String,
}

/// The folder of a search, as the record of a command's runs.
struct Folder<'t> {
    path: &'t Path,
    trial: Trial,
    journal: Mutex<File>,
    /// The number of runs in the journal.
    runs: AtomicUsize,
    /// The number of runs that an earlier process made.
    repeated: usize,
    /// The number of pieces at the last note.
    noted: AtomicUsize,
    spinner: Working,
}

impl Command for Folder<'_> {
    fn fails(&self, files: &[Vec<u8>], is_moot: &(dyn Fn() -> bool + Sync)) -> Result<Option<bool>, Halt> {
        match self.trial.run(files, is_moot) {
            Ok(end) => Ok(end.map(|end| end.fails(&self.trial.when))),
            Err(None) => Err(Halt::Interrupted),
            Err(Some(message)) => Err(Halt::Error(message)),
        }
    }

    fn record(&self, digest: &Digest, fails: bool) -> Result<(), Halt> {
        let mut journal = self.journal.lock().unwrap_or_else(PoisonError::into_inner);
        let line = format!("{},{}\n", hex(digest), u8::from(fails));
        self.runs.fetch_add(1, Ordering::Relaxed);
        let unwritten = |error| Halt::Error(format!("{}: {error}", self.path.join(JOURNAL).display()));
        journal.write_all(line.as_bytes()).map_err(unwritten)
    }

    fn kept(&self, files: &[Vec<u8>], sizes: Counts) -> Result<(), Halt> {
        let Counts { items, points, pieces, .. } = sizes;
        let runs = self.runs.load(Ordering::Relaxed);
        // While an earlier search is repeated, the folder has smaller files.
        if runs > self.repeated {
            save(self.path, &self.trial.names, files).map_err(|failure| Halt::Error(failure.message))?;
        }
        let text = format!("{items} items, {points} points, {} bytes after {runs} runs", bytes(files));
        if 2 * pieces <= self.noted.load(Ordering::Relaxed) {
            self.noted.store(pieces, Ordering::Relaxed);
            note!("{text}");
        }
        self.spinner.now(text);
        Ok(())
    }
}

fn bytes(files: &[Vec<u8>]) -> usize {
    files.iter().map(Vec::len).sum()
}

fn save(folder: &Path, names: &[String], files: &[Vec<u8>]) -> Result<(), Failure> {
    let write = |(name, bytes): (&String, &Vec<u8>)| replace(&folder.join(name), bytes).map_err(Failure::usage);
    names.iter().zip(files).try_for_each(write)
}

/// The names of files in one folder: names of files, with a number before a name that an earlier file has.
fn names(files: &[String]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for (at, file) in files.iter().enumerate() {
        let name = Path::new(file).file_name().map_or(file.clone(), |name| name.to_string_lossy().into_owned());
        let is_taken = names.contains(&name) || [STATE, JOURNAL, ORIGINAL].contains(&name.as_str());
        names.push(if is_taken { format!("{}-{name}", at + 1) } else { name });
    }
    names
}

fn read(paths: &[PathBuf]) -> Result<Vec<Vec<u8>>, Failure> {
    paths.iter().map(|path| read_bytes(path).map_err(Failure::usage)).collect()
}

/// Runs the command.
pub fn run(ask: &Ask<'_>) -> exit::Outcome {
    let start = Instant::now();
    let old = ask.resume.map(recorded).transpose()?;
    let names = old.as_ref().map_or_else(|| names(ask.files), |old| old.names.clone());
    let paths: Vec<PathBuf> = match ask.resume {
        Some(folder) => names.iter().map(|name| folder.join(ORIGINAL).join(name)).collect(),
        None => ask.files.iter().map(PathBuf::from).collect(),
    };
    let originals = read(&paths)?;
    let sketch = |(path, bytes): (&PathBuf, &Vec<u8>)| Sketch::read(&path.display().to_string(), bytes.clone());
    let sketches: Vec<Sketch> =
        paths.iter().zip(&originals).map(sketch).collect::<Result<_, _>>().map_err(Failure::usage)?;
    let when = ask.when.unwrap_or("nonzero");
    let parsed = When::parse(when).map_err(|error| Failure::usage(format!("--when: {error}")))?;
    let trial = Trial::new(ask.command, parsed, ask.timeout, names.clone())?;
    let state = State {
        command: ask.command.to_vec(),
        when: when.to_owned(),
        timeout: ask.timeout.as_secs_f64(),
        names,
        digest: hex(&digest(&originals)),
    };
    let path = ask.resume.or(ask.out).map_or_else(|| planning::free_folder("predicament-shrink"), Path::to_owned);
    if let Some(old) = old.filter(|old| *old != state) {
        let changed = if old.digest == state.digest { "the command or its condition" } else { ORIGINAL };
        let cure = format!("restore it, or start anew; the folder was begun by `{}`", old.line(&path));
        return Err(Failure::usage(format!("{}: {changed} is not the same; {cure}", path.display())));
    }
    interrupt::listen();
    let spinner = working("running the command on the files");
    let written: Vec<Vec<u8>> = sketches.iter().map(Sketch::written).collect();
    if ask.resume.is_none() {
        first_check(&trial, &state, &originals, &written)?;
    }
    let (journal, known) = begun(&path, &state, &originals, ask.resume.is_some())?;
    let before = counts(&sketches);
    let [runs, noted] = [known.len(), before.pieces].map(AtomicUsize::new);
    let is_new = ask.resume.is_none();
    let repeated = known.len();
    let folder = Folder { path: &path, trial, journal: Mutex::new(journal), runs, repeated, noted, spinner };
    let mut search = Search::new(sketches, &folder, known);
    let first = || {
        folder.record(&digest(&originals), true)?;
        folder.kept(&written, before)?;
        if written == originals { Ok(()) } else { folder.record(&digest(&written), true) }
    };
    let halt = if is_new { first() } else { Ok(()) }.and_then(|()| search.run());
    let (best, has_long) = (search.best.clone(), search.has_long_coordinates());
    let smallest: Vec<Vec<u8>> = best.iter().map(Sketch::written).collect();
    save(&path, &state.names, &smallest)?;
    let runs = folder.runs.load(Ordering::Relaxed);
    drop(folder);
    let end = match halt {
        Ok(()) => "nothing smaller was found".to_owned(),
        Err(Halt::Interrupted) => format!("interrupted; `{}` continues", state.line(&path)),
        Err(Halt::Error(message)) => {
            return Err(Failure::usage(format!("{message}; {} has the files", path.display())));
        }
    };
    state.names.iter().for_each(|name| say!("{}", path.join(name).display()));
    if has_long {
        note!("coordinates were shortened together only: there are more than {MOST_SINGLE}");
    }
    let after = counts(&best);
    say!(
        "{} to {} items, {} to {} points, {} to {} bytes; {runs} runs of the command, {:.1} s; {end}",
        before.items,
        after.items,
        before.points,
        after.points,
        bytes(&originals),
        bytes(&smallest),
        start.elapsed().as_secs_f64(),
    );
    Ok(if end.starts_with("interrupted") { exit::INCOMPLETE } else { exit::OK })
}

impl State {
    /// The command line that continues the search.
    fn line(&self, folder: &Path) -> String {
        let words: Vec<String> = self.command.iter().map(|text| word(text)).collect();
        let (folder, when) = (word(&folder.display().to_string()), word(&self.when));
        let options = format!("--when {when} --timeout {}", self.timeout);
        format!("{} shrink --resume {folder} {options} -- {}", program(), words.join(" "))
    }
}

/// Checks that the command fails on the original files, and on the files as this tool writes them.
fn first_check(trial: &Trial, state: &State, originals: &[Vec<u8>], written: &[Vec<u8>]) -> Result<(), Failure> {
    let end = |files: &[Vec<u8>]| match trial.run(files, &|| false) {
        Ok(Some(end)) => Ok(end),
        Ok(None) | Err(None) => {
            Err(Failure { message: "interrupted before the first run ended".into(), code: exit::INCOMPLETE })
        }
        Err(Some(message)) => Err(Failure::usage(format!("{message}; name a program after `--`"))),
    };
    let names = state.names.join(", ");
    let first = end(originals)?;
    if first.is_not_found() && trial.when == When::Nonzero {
        let cure = "correct the command, or write --when code=N if you mean this code";
        return Err(Failure::usage(format!("a shell may not have found the command: {first}; {cure}")));
    }
    if !first.fails(&trial.when) {
        let cure = "check the command, --when and --timeout";
        let condition = &state.when;
        return Err(Failure::usage(format!("the command does not fail on {names} ({condition}): {first}; {cure}")));
    }
    let second = end(written)?;
    if !second.fails(&trial.when) {
        let lost = "normals, colours, properties, names, comments, or digits beyond those of a double";
        let message = format!("the command fails on {names}, but not on the points and faces alone: {second}");
        return Err(Failure::usage(format!("{message}; the failure needs what this tool does not keep: {lost}")));
    }
    Ok(())
}

/// Reads the condition of a folder. The folder may be a stranger's: its names must not lead out of it.
fn recorded(folder: &Path) -> Result<State, Failure> {
    let file = folder.join(STATE);
    let text = std::fs::read(&file).map_err(Failure::io(&file))?;
    let state: State = serde_json::from_slice(&text)
        .map_err(|error| Failure::usage(format!("{}: {error}; start anew", file.display())))?;
    match state.names.iter().find(|name| Path::new(name).file_name() != Some(name.as_ref())) {
        None => Ok(state),
        Some(name) => Err(Failure::usage(format!("{}: `{name}` is not a name of a file; start anew", file.display()))),
    }
}

/// Makes the folder, or opens it again: its journal, and the results in the journal.
fn begun(
    folder: &Path,
    state: &State,
    originals: &[Vec<u8>],
    resumes: bool,
) -> Result<(File, HashMap<Digest, bool>), Failure> {
    let journal = folder.join(JOURNAL);
    let mut known = HashMap::new();
    let mut length = 0;
    if resumes {
        let text = std::fs::read_to_string(&journal).map_err(Failure::io(&journal))?;
        // A kill may have cut the last line off.
        for (at, line) in text.split_inclusive('\n').enumerate().filter(|(_, line)| line.ends_with('\n')) {
            let row = row(line.trim_end()).ok_or_else(|| {
                Failure::usage(format!("{}:{}: not a digest and a result; start anew", journal.display(), at + 1))
            })?;
            known.insert(row.0, row.1);
            length += line.len();
        }
    } else {
        if folder.read_dir().is_ok_and(|mut entries| entries.next().is_some()) {
            let cure = "continue a search with --resume, or name another folder with --out";
            return Err(Failure::usage(format!("{}: the folder is not empty; {cure}", folder.display())));
        }
        let original = folder.join(ORIGINAL);
        std::fs::create_dir_all(&original).map_err(Failure::io(&original))?;
        save(&original, &state.names, originals)?;
        let text = serde_json::to_string_pretty(state).map_err(Failure::usage)?;
        replace(&folder.join(STATE), text.as_bytes()).map_err(Failure::usage)?;
    }
    let file = OpenOptions::new().create(true).append(true).open(&journal).map_err(Failure::io(&journal))?;
    file.set_len(length.try_into().unwrap_or(u64::MAX)).map_err(Failure::io(&journal))?;
    Ok((file, known))
}

/// The digest and the result in a line of the journal.
fn row(line: &str) -> Option<(Digest, bool)> {
    let (digits, fails) = line.split_once(',').filter(|(digits, _)| digits.len() == 64 && digits.is_ascii())?;
    let mut digest = [0; 32];
    for (at, byte) in digest.iter_mut().enumerate() {
        *byte = u8::from_str_radix(&digits[2 * at..2 * at + 2], 16).ok()?;
    }
    Some((digest, matches!(fails, "0" | "1").then_some(fails == "1")?))
}
