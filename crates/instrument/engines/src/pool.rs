//! The processes of an engine: one process while queries are about one scene at a time.
//!
//! Studies query many small scenes from many threads. Sending the scene again before each query would cost a thread
//! more than the query, so a scene that finds all processes busy with other scenes gets its own process.

use std::sync::{Condvar, Mutex, PoisonError};

use predicament_predicates::{Broken, Class, Declined};

use crate::Message;
use crate::process::Process;

/// A pool of processes, with the scene that each has.
pub struct Pool {
    state: Mutex<State>,
    changed: Condvar,
    most: usize,
}

#[derive(Default)]
struct State {
    idle: Vec<Live>,
    /// The scenes with a question in progress.
    busy: Vec<u64>,
    /// The number of times that a process has broken since the last answered batch, and the last failure.
    broken: (usize, Option<Broken>),
}

/// The number of consecutive failures after which an engine is not started again. Whole tasks on which a process fails
/// do not count.
const PATIENCE: usize = 5;

/// A process, its scene, and the reason why it declined that scene, if it did.
struct Live {
    process: Process,
    scene: Option<u64>,
    declined: Option<String>,
}

impl Live {
    fn new(process: Process) -> Live {
        Live { process, scene: None, declined: None }
    }

    /// Sends the scene, unless it is the process' current scene.
    fn turn_to(&mut self, message: &Message, scene: u64) -> Result<(), Broken> {
        if self.scene == Some(scene) {
            return Ok(());
        }
        let answer = self.process.ask(message)?;
        self.declined = match answer.kind().as_str() {
            "ready" => None,
            "declined" => Some(answer.text("reason").unwrap_or_else(|| "no reason given".to_owned())),
            other => {
                let message = format!("a scene was answered by `{other}`");
                return Err(self.process.broken(Class::Panic, "protocol", message));
            }
        };
        self.scene = Some(scene);
        Ok(())
    }
}

impl Pool {
    /// A pool with its first process.
    pub fn with(process: Process) -> Pool {
        let state = State { idle: vec![Live::new(process)], ..State::default() };
        let most = std::thread::available_parallelism().map_or(1, usize::from);
        Pool { state: Mutex::new(state), changed: Condvar::new(), most }
    }

    /// Asks a process about a scene, given by its number; two questions about one scene run one after the other. The
    /// message is sent to the process first, unless it has the scene already; without a message, the question holds the
    /// scene. The inner error is the reason for declining the scene. A process that breaks is dropped, and another
    /// process is started for the next question.
    pub fn ask<R>(
        &self,
        (message, scene): (Option<&Message>, u64),
        start: impl FnOnce() -> Result<Process, Broken>,
        ask: impl FnOnce(&mut Process) -> Result<R, Broken>,
    ) -> Result<Result<R, Declined>, Broken> {
        let taken = self.take(scene)?;
        let mut has_process = taken.is_some();
        let asked = || -> Result<(Live, Result<R, Declined>), Broken> {
            let mut live = match taken {
                Some(live) => live,
                None => Live::new(start()?),
            };
            has_process = true;
            if let Some(message) = message {
                live.turn_to(message, scene)?;
            }
            let answer = match &live.declined {
                Some(reason) if message.is_some() => Err(Declined::scene(reason.clone())),
                _ => Ok(ask(&mut live.process)?),
            };
            Ok((live, answer))
        };
        let asked = asked();
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(at) = state.busy.iter().position(|&busy| busy == scene) {
            state.busy.swap_remove(at);
        }
        let answer = match asked {
            Ok((live, answer)) => {
                state.idle.push(live);
                Ok(answer)
            }
            // A process that declines is not broken.
            Err(broken) if broken.class == Class::Declined => Err(broken),
            // A question that holds its scene is a whole task. A library may fail on many scenes and answer the next
            // one.
            Err(broken) if message.is_none() && has_process => Err(broken),
            Err(broken) => {
                state.broken = (state.broken.0 + 1, Some(broken.clone()));
                Err(broken)
            }
        };
        drop(state);
        self.changed.notify_all();
        answer
    }

    /// Records that a batch was answered: the engine works.
    pub fn works(&self) {
        self.state.lock().unwrap_or_else(PoisonError::into_inner).broken = (0, None);
    }

    /// A process for the scene: the process that has the scene, else an idle one; `None` if a new process is needed. An
    /// error if the engine was given up.
    fn take(&self, scene: u64) -> Result<Option<Live>, Broken> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        loop {
            if let (PATIENCE.., Some(last)) = &state.broken {
                let message = format!("given up after {PATIENCE} failures in a row; the last: {last}");
                return Err(Broken { message, ..last.clone() });
            }
            if !state.busy.contains(&scene) {
                let has_it = state.idle.iter().position(|live| live.scene == Some(scene));
                let idle = has_it.or_else(|| state.idle.len().checked_sub(1));
                if idle.is_some() || state.busy.len() < self.most {
                    state.busy.push(scene);
                    return Ok(idle.map(|at| state.idle.swap_remove(at)));
                }
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}
