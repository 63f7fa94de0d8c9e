//! The end of a child process that did not finish its work: its last words, and the cause.

use std::io::Read;
use std::process::ExitStatus;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use crate::child::FAREWELL;
use crate::exit::{CORPUS, Failure, NOTHING_SELECTED, USAGE};
use crate::out::program;

/// The exit codes of a child that could not work, because the disk is full or the suite has changed.
const UNABLE: [u8; 3] = [USAGE, NOTHING_SELECTED, CORPUS];

/// A stream of a child, read through a pipe. A file could not record that the disk is full.
pub struct Said {
    bytes: Arc<Mutex<Vec<u8>>>,
    listener: Option<JoinHandle<()>>,
}

impl Said {
    /// Reads all text.
    pub fn all(stream: Option<impl Read + Send + 'static>) -> Said {
        Said::of(stream, usize::MAX)
    }

    /// Reads all text and keeps its end.
    pub fn last(stream: Option<impl Read + Send + 'static>) -> Said {
        Said::of(stream, 1 << 16)
    }

    /// Reads until the other end is closed, and keeps at most so many bytes.
    fn of(stream: Option<impl Read + Send + 'static>, most: usize) -> Said {
        let bytes = Arc::new(Mutex::new(Vec::new()));
        let heard = Arc::clone(&bytes);
        let listener = stream.map(|mut stream| {
            std::thread::spawn(move || {
                let mut piece = [0; 4096];
                while let Ok(count @ 1..) = stream.read(&mut piece) {
                    let mut heard = heard.lock().unwrap_or_else(PoisonError::into_inner);
                    heard.extend_from_slice(&piece[..count]);
                    let old = heard.len().saturating_sub(most);
                    heard.drain(..old);
                }
            })
        });
        Said { bytes, listener }
    }

    /// The text, once the child has ended. A process that the child left behind may keep the pipe open; this does not
    /// wait for it.
    pub fn text(&self) -> String {
        let start = Instant::now();
        while self.listener.as_ref().is_some_and(|listener| !listener.is_finished()) && start.elapsed() < FAREWELL {
            std::thread::sleep(Duration::from_millis(1));
        }
        String::from_utf8_lossy(&self.bytes.lock().unwrap_or_else(PoisonError::into_inner)).into_owned()
    }
}

/// The failure that a child reported itself, which is not a row of a backend.
pub fn unable(status: Option<ExitStatus>, said: &str) -> Option<Failure> {
    let code = status.and_then(|status| status.code());
    let code = UNABLE.into_iter().find(|&unable| code == Some(i32::from(unable)))?;
    let line = said.lines().rfind(|line| !line.trim().is_empty())?;
    let message = line.strip_prefix(&program())?.strip_prefix(": ")?;
    Some(Failure { message: message.to_owned(), code })
}

/// The cause of a child's death: the name of the check, and a message.
pub fn death(status: Option<ExitStatus>, said: &str) -> (&'static str, String) {
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
        // Only the system sends this signal, when memory runs out.
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

/// A line that is safe to print: control characters are escaped and long lines are cut.
fn printable(line: &str) -> String {
    const MOST: usize = 300;
    let escaped: String = line.trim().chars().take(MOST).flat_map(char::escape_debug).collect();
    if line.chars().nth(MOST).is_some() { escaped + "…" } else { escaped }
}

/// True if a process was ended by one of these signals.
pub fn was_signalled(status: Option<ExitStatus>, signals: &[i32]) -> bool {
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
