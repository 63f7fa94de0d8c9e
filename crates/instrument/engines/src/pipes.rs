//! The pipes of an engine: threads that write questions, read answers and collect stderr.
//!
//! An engine that neither reads nor answers blocks these threads, but not the tool.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, ErrorKind, Read, Write};
use std::process::{ChildStderr, ChildStdin, ChildStdout};
use std::sync::mpsc::{Receiver, SyncSender};
use std::sync::{Mutex, PoisonError};

use crate::command::printable;
use crate::{Bound, Message, ProtocolError};

/// The number of stderr lines to keep.
const LAST_LINES: usize = 6;
/// The number of bytes to keep of a line.
const LINE_BYTES: u64 = 400;

/// Writes questions. If the engine has ended, the reader detects it too, and reports how.
pub fn write(mut stdin: ChildStdin, questions: &Receiver<Vec<u8>>) {
    while questions.recv().is_ok_and(|bytes| stdin.write_all(&bytes).and_then(|()| stdin.flush()).is_ok()) {}
}

/// Reads answers, each within the bound of its question, until one is wrong. Bytes that arrive before a question are
/// not an answer.
pub fn read(stdout: ChildStdout, bounds: &Receiver<Bound>, answers: &SyncSender<Result<Message, ProtocolError>>) {
    let mut stdout = BufReader::new(stdout);
    loop {
        match stdout.fill_buf() {
            Ok([]) => return,
            Err(error) if error.kind() == ErrorKind::Interrupted => continue,
            Ok(_) | Err(_) => {}
        }
        let bound = bounds.try_recv();
        let read = Message::read(&mut stdout, bound.unwrap_or(Bound::answer(0)));
        let Some(read) = read.map_err(wrong).transpose() else { return };
        let answer = read.and_then(|message| if bound.is_ok() { Ok(message) } else { Err(unasked(&message)) });
        let was_last = answer.is_err();
        if answers.send(answer).is_err() || was_last {
            return;
        }
    }
}

/// The error for an engine that has written this message without a question.
pub fn unasked(message: &Message) -> ProtocolError {
    ProtocolError::Unasked(message.kind())
}

/// The error for a message that cannot be read.
fn wrong(error: std::io::Error) -> ProtocolError {
    let said = error.to_string();
    error.downcast().unwrap_or(ProtocolError::Unread(said))
}

/// Stores the last lines of stderr.
pub fn listen(stderr: ChildStderr, said: &Mutex<VecDeque<String>>) {
    let mut stderr = BufReader::new(stderr);
    let mut line = Vec::new();
    loop {
        line.clear();
        // A long line arrives in pieces.
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
