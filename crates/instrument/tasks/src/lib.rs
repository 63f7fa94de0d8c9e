//! Tasks: the questions that can be asked about a scene.
//!
//! A [`Task`] is everything about one question: its keys in suites, its generators, its truth, the solution by any
//! backend, judging and explaining of answers, and its section of a report. The other crates see a task only as
//! [`AnyTask`]; none of them names one. A new task is a crate and one line in a list: `docs/TASKS.md` is a tutorial.
//!
//! This crate never names a backend. The crate `oracle` runs tasks on backends, with time limits and expectations.
//!
//! * [`Task`], [`Case`], [`Asked`]: the trait of a task and its arguments.
//! * [`Contestant`], [`Entry`], [`Solver`]: a backend selected at run time, on the tasks of a [`TaskList`].
//! * [`AnswerError`], [`ExplainError`]: reasons why a backend gives no answer, and why a query cannot be repeated.
//! * [`Outcome`], [`Finding`], [`ClassCounts`]: the results of judging.
//! * [`Agreement`]: the answers that agree with the doubles, and with the decimals that were written.
//! * [`Check`]: a check that a judge can report. [`Spoiled`]: answers that prove that it does.
//! * [`Compared`], [`Knob`]: the scenes on which a task is compared, and the transformations that make them harder.
//! * [`output`]: answers as files for other programs, vertices exactly.
//! * [`signs`]: the tasks that ask for single signs. Every other task is a separate crate.
//! * [`map_source`], [`map_loops`], [`segment_source`], [`solids`], [`typed`]: input shared by several tasks.
//! * [`rounding`]: violations that the rounding of output coordinates excuses.

mod any;
mod budget;
mod case;
mod checks;
mod compared;
mod contestant;
mod counts;
mod decimals;
mod digest;
mod error;
mod knob;
mod list;
pub mod map_loops;
pub mod map_source;
mod once;
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
pub mod typed;
mod watch;

pub mod output;
pub mod replies;
pub mod signs;

pub use any::{AnyCase, AnyTask};
pub use budget::Budget;
pub use case::{Asked, Case, Dispute};
pub use checks::{Check, ON_EVERY_TASK, is_declared};
pub use compared::{Compared, Kind};
pub use contestant::{Contestant, Entry};
pub use counts::ClassCounts;
pub use decimals::Agreement;
pub use digest::digest;
pub use error::{AnswerError, ExplainError};
pub use knob::{Knob, RoundsScene, SHIFTED_BITS, Turns};
pub use list::{TaskList, vocabulary, with_signs};
pub use once::bits;
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
