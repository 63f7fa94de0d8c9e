//! Tasks: what can be asked of a scene, one folder each.
//!
//! A [`Task`] is everything about one question: its keys in suites, its
//! generators, its truth, how it is solved by any backend, how answers are
//! judged and explained, and its section of a report. The other crates see a
//! task only as [`AnyTask`]; none of them names one. A new task is a new folder
//! here (or in anybody's crate) and one line in a list: `docs/TASKS.md` walks
//! through one.
//!
//! This crate never names a backend. What runs tasks on backends, with time
//! limits and expectations, is the crate `oracle`.
//!
//! * [`Task`], [`Case`], [`Asked`]: what a task implements and is handed.
//! * [`Contestant`], [`Entry`], [`Solver`]: a backend picked at run time, on the tasks of a [`TaskList`].
//! * [`Outcome`], [`Finding`], [`ClassCounts`]: what judging gives.
//! * [`Check`]: what a judge can report. [`Spoiled`]: answers that prove that it does.
//! * [`Compared`], [`Knob`]: the scenes on which a task is compared, and the ways in which they can be made harder.
//! * [`output`]: answers as files for other programs, vertices exactly.
//! * [`signs`], [`interval`], [`polygon_locate`], [`cube_union`], [`contacts`],
//!   [`crossings`], [`triangulate`], [`hull`], [`mod@slice`], [`delaunay`],
//!   [`overlay`], [`snap`], [`mesh_locate`], [`mesh_intersect`]: the tasks.

mod any;
mod budget;
mod case;
mod checks;
mod compared;
mod contestant;
mod counts;
mod digest;
mod knob;
mod list;
mod map_loops;
mod map_source;
mod outcome;
mod phases;
mod rounding;
mod rounds;
mod run;
mod segment_source;
mod solids;
mod solver;
mod spoiled;
mod task;
mod watch;

pub mod contacts;
pub mod crossings;
pub mod cube_union;
pub mod delaunay;
pub mod hull;
pub mod interval;
pub mod mesh_intersect;
pub mod mesh_locate;
pub mod output;
pub mod overlay;
pub mod polygon_locate;
pub mod signs;
pub mod slice;
pub mod snap;
pub mod triangulate;

pub use any::{AnyCase, AnyTask};
pub use budget::Budget;
pub use case::{Asked, Case, Dispute};
pub use checks::{Check, ON_EVERY_TASK, is_declared};
pub use compared::{Compared, Kind};
pub use contestant::{Contestant, Entry};
pub use counts::ClassCounts;
pub use digest::digest;
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
pub use watch::{Stop, Watch};
