//! One run of a command on files, and the conditions under which it fails.

use std::fmt;
use std::fs::File;
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use predicament_engines::Group;

use crate::exit::Failure;
use crate::interrupt;
use crate::temporary::Temporary;

/// The files of a run with the output of the command.
const OUTPUT: [&str; 2] = [".stdout", ".stderr"];

/// The meaning of "fails".
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum When {
    /// The exit code is not zero, or a signal ends the command.
    Nonzero,
    Code(i32),
    Timeout,
    Signal,
    /// A line of stdout or stderr contains a text.
    Prints(String),
}

impl When {
    /// Parses the value of `--when`.
    pub fn parse(text: &str) -> Result<When, String> {
        let wrong = || format!("`{text}` is not a condition; write nonzero, code=N, timeout, signal or prints=TEXT");
        match text.split_once('=') {
            Some(("code", code)) => code.parse().map(When::Code).map_err(|_| wrong()),
            Some(("prints", text)) if !text.is_empty() => Ok(When::Prints(text.to_owned())),
            None if text == "nonzero" => Ok(When::Nonzero),
            None if text == "timeout" => Ok(When::Timeout),
            None if text == "signal" => Ok(When::Signal),
            _ => Err(wrong()),
        }
    }
}

/// The end of a run: an exit status, or `None` at the time limit.
pub struct End {
    status: Option<ExitStatus>,
    has_text: bool,
}

impl End {
    /// True if this end is the failure.
    pub fn fails(&self, when: &When) -> bool {
        match (when, self.status) {
            (When::Timeout, status) => status.is_none(),
            (_, None) => false,
            (When::Nonzero, Some(status)) => !status.success(),
            (When::Code(code), Some(status)) => status.code() == Some(*code),
            (When::Signal, Some(status)) => status.code().is_none(),
            (When::Prints(_), Some(_)) => self.has_text,
        }
    }

    /// True if a shell did not find the command, or may not run it.
    pub fn is_not_found(&self) -> bool {
        self.status.and_then(|status| status.code()).is_some_and(|code| [126, 127].contains(&code))
    }
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.status {
            None => f.write_str("it runs into the time limit"),
            Some(status) => match status.code() {
                Some(code) => write!(f, "its exit code is {code}"),
                None => write!(f, "it is ended by a {status}"),
            },
        }
    }
}

/// A command with placeholders for its files.
pub struct Trial {
    words: Vec<String>,
    pub when: When,
    limit: Duration,
    /// The names of the files, in order.
    pub names: Vec<String>,
}

impl Trial {
    /// Checks the placeholders of a command for files with these names.
    pub fn new(words: &[String], when: When, limit: Duration, names: Vec<String>) -> Result<Trial, Failure> {
        let trial = Trial { words: words.to_vec(), when, limit, names };
        let shown = trial.filled(Path::new("D"))?;
        let misses = (0..trial.names.len()).find(|&at| !shown.iter().any(|word| word.contains(&trial.at(at, "D"))));
        match misses {
            None => Ok(trial),
            Some(at) => {
                let cure = "write {} for all files, or {1} for the first one, {2} for the second one and so on";
                let name = &trial.names[at];
                Err(Failure::usage(format!("the command after `--` has no place for {name}; {cure}")))
            }
        }
    }

    fn at(&self, file: usize, folder: &str) -> String {
        format!("{folder}/{}", self.names[file])
    }

    /// The words of the command for files in this folder.
    fn filled(&self, folder: &Path) -> Result<Vec<String>, Failure> {
        let folder = folder.display().to_string();
        let paths: Vec<String> = (0..self.names.len()).map(|file| self.at(file, &folder)).collect();
        let mut filled = Vec::new();
        for word in &self.words {
            if word == "{}" {
                filled.extend(paths.iter().cloned());
                continue;
            }
            if word.contains("{}") && paths.len() > 1 {
                let cure = "write {1}, {2} and so on inside of a word";
                return Err(Failure::usage(format!("`{word}`: {} files do not fit; {cure}", paths.len())));
            }
            let numbered = |word: String, (at, path): (usize, &String)| word.replace(&format!("{{{}}}", at + 1), path);
            let word = word.replace("{}", &paths[0]).replace("{dir}", &folder);
            filled.push(paths.iter().enumerate().fold(word, numbered));
        }
        Ok(filled)
    }

    /// Runs the command on the contents of its files; `None` if the run became moot. The error is a message, or `None`
    /// for an interrupt.
    pub fn run(&self, files: &[Vec<u8>], is_moot: &dyn Fn() -> bool) -> Result<Option<End>, Option<String>> {
        let temporary = |error| Some(format!("a temporary folder: {error}"));
        let folder = Temporary::new("predicament-shrink").map_err(temporary)?;
        for (name, bytes) in self.names.iter().zip(files) {
            std::fs::write(folder.path.join(name), bytes).map_err(temporary)?;
        }
        let words = self.filled(&folder.path).map_err(|failure| Some(failure.message))?;
        let mut command = Command::new(&words[0]);
        command.args(&words[1..]).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
        if matches!(self.when, When::Prints(_)) {
            let [stdout, stderr] = OUTPUT.map(|name| File::create(folder.path.join(name)));
            command.stdout(stdout.map_err(temporary)?).stderr(stderr.map_err(temporary)?);
        }
        let start = Instant::now();
        let mut group = Group::start(&mut command, None)
            .map_err(|error| Some(format!("`{}` does not start: {error}", words[0])))?;
        let mut pause = Duration::from_micros(200);
        let status = loop {
            match group.child.try_wait() {
                Ok(Some(status)) => break Some(status),
                Ok(None) if interrupt::flag().load(Ordering::Relaxed) => return Err(None),
                Ok(None) if is_moot() => return Ok(None),
                Ok(None) if start.elapsed() >= self.limit => break None,
                Ok(None) => std::thread::sleep(pause),
                Err(error) => return Err(Some(format!("`{}`: {error}", words[0]))),
            }
            pause = (pause * 2).min(Duration::from_millis(10));
        };
        // Processes that the command started end with it.
        drop(group);
        let has = |name: &&str, text: &str| {
            let bytes = std::fs::read(folder.path.join(name)).unwrap_or_default();
            String::from_utf8_lossy(&bytes).lines().any(|line| line.contains(text))
        };
        let has_text = matches!(&self.when, When::Prints(text) if OUTPUT.iter().any(|name| has(name, text)));
        Ok(Some(End { status, has_text }))
    }
}
