//! An engine that answers whole tasks: its greeting lists them, and each of them has a solver of its own.
//!
//! For the other tasks the engine is an ordinary backend, whose predicates an algorithm of this project calls.

use std::sync::Arc;

use predicament_engines::{Engine, Message, ProtocolError};
use predicament_predicates::{Broken, Class, Declined, Dimension};
use predicament_tasks::replies::{Array, Arrays, ByProgram, Program, Reply};
use predicament_tasks::{AnyTask, Contestant, Entry, Solver, TaskList, with_signs};

use crate::boxed::Boxed;

/// The prefixes of keys that hold arrays, by the type of the array.
const WORD: &str = "word:";
const IDS: &str = "ids:";
const NUMBERS: &str = "numbers:";

/// An engine as a contestant.
pub(crate) fn contestant<L: TaskList>(engine: Engine, tasks: &L) -> Box<dyn Contestant> {
    let whole: Vec<&'static dyn AnyTask> = with_signs(tasks)
        .into_iter()
        .filter(|task| task.parts_of_replies().is_some() && engine.tasks().iter().any(|name| name == task.name()))
        .collect();
    if whole.is_empty() {
        return Box::new(Entry::shared(Arc::new(Boxed::new(engine)), None, tasks.clone()));
    }
    let program = Arc::new(Whole(engine.clone()));
    let solver = |task| Box::new(ByProgram::new(Arc::clone(&program) as Arc<dyn Program>, task)) as Box<dyn Solver>;
    let solvers = whole.into_iter().map(solver).collect();
    Box::new(Entry::shared(Arc::new(Boxed::new(engine)), None, tasks.clone()).with_solvers(solvers))
}

/// An engine, asked for whole answers.
struct Whole(Engine);

impl Program for Whole {
    fn answer(&self, task: &str, dimension: Dimension, question: &Arrays) -> Result<Result<Reply, Declined>, Broken> {
        let dimension = if dimension == Dimension::Two { "2" } else { "3" };
        let mut message = Message::new("task").with("task", task).with("dimension", dimension);
        for (name, array) in question.iter() {
            message = match array {
                Array::Word(word) => message.with(&format!("{WORD}{name}"), word.as_bytes()),
                Array::Ids(ids) => message
                    .with(&format!("{IDS}{name}"), ids.iter().flat_map(|id| id.to_le_bytes()).collect::<Vec<u8>>()),
                Array::Numbers(numbers) => {
                    let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
                    message.with(&format!("{NUMBERS}{name}"), bytes)
                }
            };
        }
        let (answer, nanoseconds) = match self.0.ask_task(&message)? {
            Ok(answered) => answered,
            Err(declined) => return Ok(Err(declined)),
        };
        let arrays = read(&answer).map_err(|error| Broken {
            class: Class::Panic,
            check: "protocol",
            message: error.to_string(),
        })?;
        let bytes = answer.number("bytes").ok();
        Ok(Ok(Reply { arrays, nanoseconds, bytes }))
    }
}

/// The arrays of an answer.
fn read(answer: &Message) -> Result<Arrays, ProtocolError> {
    let mut arrays = Arrays::default();
    for (key, value) in answer.iter() {
        let ragged = || ProtocolError::Ragged { key: key.to_owned(), bytes: value.len() };
        if let Some(name) = key.strip_prefix(WORD) {
            arrays.add(name, Array::Word(String::from_utf8_lossy(value).into_owned()));
        } else if let Some(name) = key.strip_prefix(IDS) {
            let (ids, rest) = value.as_chunks::<4>();
            rest.is_empty().then_some(()).ok_or_else(ragged)?;
            arrays.add(name, Array::Ids(ids.iter().map(|id| u32::from_le_bytes(*id)).collect()));
        } else if let Some(name) = key.strip_prefix(NUMBERS) {
            let (numbers, rest) = value.as_chunks::<8>();
            rest.is_empty().then_some(()).ok_or_else(ragged)?;
            arrays.add(name, Array::Numbers(numbers.iter().map(|x| f64::from_le_bytes(*x)).collect()));
        }
    }
    Ok(arrays)
}
