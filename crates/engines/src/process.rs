//! The process of an engine: one question, one answer, or what went wrong.
//!
//! Threads write, read and listen to stderr, so that an engine that neither
//! reads nor answers cannot hold up the tool for longer than its silence lasts.

use std::collections::{BTreeSet, VecDeque};
use std::io::{BufRead, BufReader, Read, Write};
#[cfg(unix)]
use std::process::Command;
use std::process::{Child, ChildStderr, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use predicament_predicates::{Broken, Class};

use crate::command::{command, printable};
use crate::{Config, Message};

/// Lines of stderr that are kept.
const LAST_LINES: usize = 6;
/// Bytes that are kept of a line.
const LINE_BYTES: u64 = 400;
/// How often a silent process is looked at.
const LOOK: Duration = Duration::from_millis(200);
/// How long a process that has closed its stdout may take to end.
const FAREWELL: Duration = Duration::from_secs(2);

/// The processes that are running, each the first of a group of its own.
static RUNNING: Mutex<BTreeSet<u32>> = Mutex::new(BTreeSet::new());

/// Ends all engines of this process and what they have started, for a process that is about to exit without
/// dropping them. An engine that waits for input would end by itself; one that loops would not.
pub fn end_all() {
    let running = std::mem::take(&mut *RUNNING.lock().unwrap_or_else(PoisonError::into_inner));
    running.into_iter().for_each(end_group);
}

/// Ends a group of processes, by the number of its first. The standard library can only end one process.
fn end_group(first: u32) {
    #[cfg(unix)]
    let _ = Command::new("kill")
        .args(["-KILL", "--", &format!("-{first}")])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status();
    #[cfg(not(unix))]
    let _ = first;
}

/// The process of an engine.
pub struct Process {
    child: Child,
    to: Sender<Vec<u8>>,
    from: Receiver<Result<Message, String>>,
    said: Arc<Mutex<VecDeque<String>>>,
    listener: Option<JoinHandle<()>>,
    silence: Duration,
}

impl Process {
    /// Starts the engine.
    pub fn start(config: &Config) -> Result<Process, Broken> {
        let shown = config.run.join(" ");
        let broken = |message: String| Broken { class: Class::Panic, check: "start", message };
        let mut command = command(config, &config.run).map_err(broken)?;
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // A group of its own: what it starts ends with it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn().map_err(|error| {
            let build = if config.build.is_empty() { "" } else { "; is it built? `engines build` builds it" };
            broken(format!("`{shown}` in {} did not start: {error}{build}", config.folder.display()))
        })?;
        let (to, outgoing) = channel::<Vec<u8>>();
        // Bounded: an engine that writes without being asked waits, and its messages take no memory.
        let (incoming, from) = sync_channel(1);
        RUNNING.lock().unwrap_or_else(PoisonError::into_inner).insert(child.id());
        let said = Arc::new(Mutex::new(VecDeque::new()));
        let pipes = (child.stdin.take(), child.stdout.take(), child.stderr.take());
        let (Some(mut stdin), Some(stdout), Some(stderr)) = pipes else {
            return Err(broken(format!("`{shown}`: no pipes to the process")));
        };
        std::thread::spawn(move || {
            // Where the engine has gone, the reader sees it too, and says how.
            while outgoing.recv().is_ok_and(|bytes| stdin.write_all(&bytes).and_then(|()| stdin.flush()).is_ok()) {}
        });
        std::thread::spawn(move || {
            let mut stdout = BufReader::new(stdout);
            loop {
                let (message, last) = match Message::read(&mut stdout) {
                    Ok(Some(message)) => (Ok(message), false),
                    Ok(None) => return,
                    Err(error) => (Err(error.to_string()), true),
                };
                if incoming.send(message).is_err() || last {
                    return;
                }
            }
        });
        let heard = Arc::clone(&said);
        let listener = Some(std::thread::spawn(move || listen(stderr, &heard)));
        Ok(Process { child, to, from, said, listener, silence: config.silence() })
    }

    /// Sends a message and waits for the answer. After an error the process is gone.
    pub fn ask(&mut self, message: &Message) -> Result<Message, Broken> {
        let bytes = message.encode().map_err(|message| Broken { class: Class::Panic, check: "protocol", message })?;
        // An answer to nothing would be taken for the next one.
        if let Ok(unasked) = self.from.try_recv() {
            let what = unasked.map_or_else(|garbage| garbage, |message| format!("a message `{}`", message.kind()));
            let message = format!("it wrote more than the answer to the message before: {}", printable(&what));
            return Err(self.broken(Class::Panic, "protocol", message));
        }
        // A writer that has stopped shows as an end of the answers.
        let _ = self.to.send(bytes);
        let error = match self.hear() {
            Ok(Ok(answer)) if answer.kind() == "error" => {
                let message = answer.text("message").unwrap_or_else(|| "an error without a message".to_owned());
                (Class::Panic, "engine error", message)
            }
            Ok(Ok(answer)) => return Ok(answer),
            Ok(Err(garbage)) => (Class::Panic, "protocol", garbage),
            Err(RecvTimeoutError::Timeout) => {
                (Class::Timeout, "silence", format!("no answer to `{}` within {:?}", message.kind(), self.silence))
            }
            Err(RecvTimeoutError::Disconnected) => {
                let status = self.ended();
                (Class::Panic, "crashed", status.map_or_else(|| "stdout was closed".to_owned(), fate))
            }
        };
        Err(self.broken(error.0, error.1, error.2))
    }

    /// The next answer; an end where the process has ended, also if a process that it started keeps its stdout open.
    fn hear(&mut self) -> Result<Result<Message, String>, RecvTimeoutError> {
        let start = Instant::now();
        let mut ended = None;
        loop {
            match self.from.recv_timeout(LOOK.min(self.silence)) {
                Err(RecvTimeoutError::Timeout) if start.elapsed() >= self.silence => {
                    return Err(RecvTimeoutError::Timeout);
                }
                Err(RecvTimeoutError::Timeout) => {
                    let gone = matches!(self.child.try_wait(), Ok(Some(_)));
                    let since = *ended.get_or_insert_with(Instant::now);
                    if !gone {
                        ended = None;
                    } else if since.elapsed() >= LOOK {
                        // What it had written has been read by now.
                        return Err(RecvTimeoutError::Disconnected);
                    }
                }
                heard => return heard,
            }
        }
    }

    /// Ends the process, and gives what went wrong with the last lines of its stderr.
    pub fn broken(&mut self, class: Class, check: &'static str, message: String) -> Broken {
        self.end();
        let message = printable(&message);
        let said = self.said.lock().unwrap_or_else(PoisonError::into_inner);
        let said: Vec<&str> = said.iter().map(String::as_str).collect();
        let message = if said.is_empty() { message } else { format!("{message}; stderr: {}", said.join(" / ")) };
        Broken { class, check, message }
    }

    fn ended(&mut self) -> Option<ExitStatus> {
        let start = Instant::now();
        while start.elapsed() < FAREWELL {
            if let Ok(Some(status)) = self.child.try_wait() {
                return Some(status);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        None
    }

    fn end(&mut self) {
        let Some(listener) = self.listener.take() else { return };
        if RUNNING.lock().unwrap_or_else(PoisonError::into_inner).remove(&self.child.id()) {
            end_group(self.child.id());
        }
        let _ = self.child.kill();
        let _ = self.child.wait();
        // All of stderr is heard once the process is gone, unless a child of its own holds on to it.
        let start = Instant::now();
        while !listener.is_finished() && start.elapsed() < FAREWELL {
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.end();
    }
}

/// Keeps the last lines of stderr.
fn listen(stderr: ChildStderr, said: &Mutex<VecDeque<String>>) {
    let mut stderr = BufReader::new(stderr);
    let mut line = Vec::new();
    loop {
        line.clear();
        // A long line comes in pieces.
        match (&mut stderr).take(LINE_BYTES).read_until(b'\n', &mut line) {
            Ok(0) | Err(_) => return,
            Ok(_) => {
                let text = printable(&String::from_utf8_lossy(&line));
                let mut said = said.lock().unwrap_or_else(PoisonError::into_inner);
                said.extend((!text.is_empty()).then_some(text));
                while said.len() > LAST_LINES {
                    said.pop_front();
                }
            }
        }
    }
}

/// How a process has ended, in words.
fn fate(status: ExitStatus) -> String {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        let name = match signal {
            4 => " (illegal instruction)",
            6 => " (abort)",
            8 => " (arithmetic)",
            9 => " (kill)",
            11 => " (segmentation fault)",
            _ => "",
        };
        return format!("the process was ended by signal {signal}{name}");
    }
    match status.code() {
        Some(code) => format!("the process ended with code {code}"),
        None => "the process ended".to_owned(),
    }
}
