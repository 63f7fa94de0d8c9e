//! Tasks: what can be asked of a scene.
//!
//! A [`Task`] is everything about one question: its keys in suites, its
//! generators, its truth, how it is solved by any backend, how answers are
//! judged and explained, and its section of a report. The other crates see a
//! task only as [`AnyTask`]; none of them names one. A new task is a crate
//! and one line in a list: `docs/TASKS.md` walks through one.
//!
//! This crate never names a backend. What runs tasks on backends, with time
//! limits and expectations, is the crate `oracle`.
//!
//! * [`Task`], [`Case`], [`Asked`]: what a task implements and is handed.
//! * [`Contestant`], [`Entry`], [`Solver`]: a backend picked at run time, on the tasks of a [`TaskList`].
//! * [`AnswerError`], [`ExplainError`]: why a backend gives no answer, and why a query cannot be asked again.
//! * [`Outcome`], [`Finding`], [`ClassCounts`]: what judging gives.
//! * [`Check`]: what a judge can report. [`Spoiled`]: answers that prove that it does.
//! * [`Compared`], [`Knob`]: the scenes on which a task is compared, and the ways in which they can be made harder.
//! * [`output`]: answers as files for other programs, vertices exactly.
//! * [`signs`]: the tasks that ask for single signs. All others are crates of their own.
//! * [`map_source`], [`map_loops`], [`segment_source`], [`solids`]: what scenes of several tasks are made of.
//! * [`rounding`]: what the rounding of output coordinates excuses.

mod any;
mod budget;
mod case;
mod checks;
mod compared;
mod contestant;
mod counts;
mod digest;
mod error;
mod knob;
mod list;
pub mod map_loops;
pub mod map_source;
mod outcome;
mod phases;
pub mod rounding;
mod rounds;
mod run;
pub mod segment_source;
pub mod solids;
mod solver;
mod spoiled;
mod task;
mod threads;
mod watch;

pub mod output;
pub mod signs;

pub use any::{AnyCase, AnyTask};
pub use budget::Budget;
pub use case::{Asked, Case, Dispute};
pub use checks::{Check, ON_EVERY_TASK, is_declared};
pub use compared::{Compared, Kind};
pub use contestant::{Contestant, Entry};
pub use counts::ClassCounts;
pub use digest::digest;
pub use error::{AnswerError, ExplainError};
pub use knob::{Knob, RoundsScene, SHIFTED_BITS, Turns};
pub use list::{TaskList, vocabulary, with_signs};
pub use outcome::{AnswerLine, Finding, Outcome, finding_id, ids, symbol};
pub use phases::Phase;
pub use predicament_predicates::{Class, Status};
pub use rounds::{PLENTY, Rounds};
pub use run::{caught, run, run_spoiled};
pub use solver::{Halt, How, OnTask, Purpose, Refusal, Solver, Stopwatch};
pub use spoiled::{AnySpoiled, Catch, Spoiled};
pub use task::{Answer, Explanation, Task};
pub use threads::on_threads;
pub use watch::{Stop, Watch};
