//! The process of an engine: each question returns its answer or a failure.
//!
//! Threads write, read and collect stderr, so that an engine that neither reads nor answers cannot block the tool for
//! longer than its silence limit.
//!
//! # Matching answers to questions
//! Every question has a number, its `id`. An engine whose answer to `hello` has that number repeats the number in each
//! answer. An engine that does not is greeted again after each batch. If its next message is not a greeting, the
//! message before it may have been the answer to another question.

use std::collections::VecDeque;
use std::process::{ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use predicament_predicates::{Broken, Class};

use crate::command::{command, printable};
use crate::group::Group;
use crate::{Bound, Config, Message, ProtocolError, pipes};

/// The interval at which a silent process is checked.
const LOOK: Duration = Duration::from_millis(200);
/// The time within which a process that has closed its stdout must end.
const FAREWELL: Duration = Duration::from_secs(2);

/// The process of an engine.
pub struct Process {
    group: Group,
    questions: Sender<Vec<u8>>,
    bounds: Sender<Bound>,
    answers: Receiver<Result<Message, ProtocolError>>,
    said: Arc<Mutex<VecDeque<String>>>,
    listener: Option<JoinHandle<()>>,
    silence: Duration,
    /// The number of the last question.
    asked: u64,
    /// The greeting sent after each batch; `None` if the engine repeats the numbers of questions.
    fence: Option<Message>,
}

impl Process {
    /// Starts the engine.
    pub fn start(config: &Config) -> Result<Process, Broken> {
        let shown = config.run.join(" ");
        let broken = |message: String| Broken { class: Class::Panic, check: "start", message };
        let mut command = command(config, &config.run).map_err(|why| broken(why.to_string()))?;
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut group = Group::start(&mut command, config.memory()).map_err(|error| {
            let build = if config.build.is_empty() { "" } else { "; is it built? `engines build` builds it" };
            broken(format!("`{shown}` in {} did not start: {error}{build}", config.folder.display()))
        })?;
        let child = &mut group.child;
        let pipes = (child.stdin.take(), child.stdout.take(), child.stderr.take());
        let (Some(stdin), Some(stdout), Some(stderr)) = pipes else {
            return Err(broken(format!("`{shown}`: no pipes to the process")));
        };
        let (questions, outgoing) = channel();
        let (bounds, bounded) = channel();
        // Bounded: an engine that writes without a question blocks, and its messages take no memory.
        let (incoming, answers) = sync_channel(1);
        let said = Arc::new(Mutex::new(VecDeque::new()));
        let heard = Arc::clone(&said);
        std::thread::spawn(move || pipes::write(stdin, &outgoing));
        std::thread::spawn(move || pipes::read(stdout, &bounded, &incoming));
        let listener = Some(std::thread::spawn(move || pipes::listen(stderr, &heard)));
        let silence = config.silence();
        Ok(Process { group, questions, bounds, answers, said, listener, silence, asked: 0, fence: None })
    }

    /// Greets the engine and waits for its greeting. After an error the process has ended.
    pub fn greet(&mut self, hello: Message) -> Result<Message, Broken> {
        let answer = self.ask(&hello)?;
        self.fence = answer.bytes("id").is_none().then_some(hello);
        Ok(answer)
    }

    /// Sends a message and waits for the answer. After an error the process has ended.
    pub fn ask(&mut self, question: &Message) -> Result<Message, Broken> {
        let id = self.send(question, Bound::answer(0))?;
        let answer = self.answer(question, id)?;
        self.unless_error(answer)
    }

    /// Sends a batch and waits for the answer, which has a bound. After an error the process has ended.
    pub fn ask_batch(&mut self, batch: &Message, bound: Bound) -> Result<Message, Broken> {
        let answer = self.ask_within(batch, bound)?;
        self.unless_error(answer)
    }

    /// Sends a batch or the scene of a task and waits for the answer, which has a bound; the answer may report an error
    /// of the library. After an error of the protocol the process has ended.
    pub fn ask_within(&mut self, batch: &Message, bound: Bound) -> Result<Message, Broken> {
        let id = self.send(batch, bound)?;
        let Some(fence) = self.fence.clone() else {
            return self.answer(batch, id);
        };
        let after = self.send(&fence, Bound::answer(0))?;
        let answer = self.answer(batch, id)?;
        let behind = self.answer(&fence, after)?;
        // A second greeting may be refused. A refusal without a question comes before the answer to the next greeting,
        // which is not an answer to a batch.
        if ["hello", "declined", "error"].contains(&behind.kind().as_str()) {
            return Ok(answer);
        }
        Err(self.broken(Class::Panic, "protocol", pipes::unasked(&behind).to_string()))
    }

    /// Sends a message and returns its number; the answer must not exceed the bound.
    fn send(&mut self, question: &Message, bound: Bound) -> Result<u64, Broken> {
        self.asked += 1;
        let bytes = question.encode_as(self.asked);
        let bytes =
            bytes.map_err(|error| Broken { class: Class::Panic, check: "protocol", message: error.to_string() })?;
        // The bound goes first: the answer may arrive before this thread continues. A stopped reader or writer appears
        // as an end of the answers.
        let _ = self.bounds.send(bound);
        let _ = self.questions.send(bytes);
        Ok(self.asked)
    }

    /// The next message, which answers the question with this number.
    fn answer(&mut self, question: &Message, id: u64) -> Result<Message, Broken> {
        let error = match self.hear() {
            Ok(Ok(answer)) => match self.is_to(&answer, id) {
                Ok(()) => return Ok(answer),
                Err(other) => (Class::Panic, "protocol", other.to_string()),
            },
            Ok(Err(garbage)) => (Class::Panic, "protocol", garbage.to_string()),
            Err(RecvTimeoutError::Timeout) => {
                (Class::Timeout, "silence", format!("no answer to `{}` within {:?}", question.kind(), self.silence))
            }
            Err(RecvTimeoutError::Disconnected) => {
                let status = self.ended();
                (Class::Panic, "crashed", status.map_or_else(|| "stdout was closed".to_owned(), fate))
            }
        };
        Err(self.broken(error.0, error.1, error.2))
    }

    /// The answer, or an error if it reports that the engine failed.
    fn unless_error(&mut self, answer: Message) -> Result<Message, Broken> {
        if answer.kind() != "error" {
            return Ok(answer);
        }
        let message = answer.text("message").unwrap_or_else(|| "an error without a message".to_owned());
        Err(self.broken(Class::Panic, "engine error", message))
    }

    /// Checks that an answer belongs to the question with this number, as far as the answer has a number.
    fn is_to(&self, answer: &Message, id: u64) -> Result<(), ProtocolError> {
        match answer.text("id") {
            Some(of) if of.trim() != id.to_string() => Err(ProtocolError::OtherQuestion { of, id }),
            None if self.asked > 1 && self.fence.is_none() => Err(ProtocolError::NoId(answer.kind())),
            _ => Ok(()),
        }
    }

    /// The next answer. It reports an end if the process has ended, even if a process that it started keeps its stdout
    /// open.
    fn hear(&mut self) -> Result<Result<Message, ProtocolError>, RecvTimeoutError> {
        let start = Instant::now();
        let mut ended = None;
        loop {
            match self.answers.recv_timeout(LOOK.min(self.silence)) {
                Err(RecvTimeoutError::Timeout) if start.elapsed() >= self.silence => {
                    return Err(RecvTimeoutError::Timeout);
                }
                Err(RecvTimeoutError::Timeout) => {
                    let gone = matches!(self.group.child.try_wait(), Ok(Some(_)));
                    let since = *ended.get_or_insert_with(Instant::now);
                    if !gone {
                        ended = None;
                    } else if since.elapsed() >= LOOK {
                        // By now everything that it wrote has been read.
                        return Err(RecvTimeoutError::Disconnected);
                    }
                }
                heard => return heard,
            }
        }
    }

    /// Ends the process; returns the failure with the last lines of its stderr.
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
            if let Ok(Some(status)) = self.group.child.try_wait() {
                return Some(status);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        None
    }

    fn end(&mut self) {
        let Some(listener) = self.listener.take() else { return };
        self.group.end();
        // All of stderr is read once the process has ended, unless one of its children keeps stderr open.
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

/// A description of how a process ended.
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
