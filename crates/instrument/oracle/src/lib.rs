//! The oracle: runs backends on tasks and compares every answer with the truth.
//!
//! It reports which answers are wrong, under which promise, and whether that was expected. It makes no geometric
//! decisions itself: the crate `judge` computes the truth, the crate `tasks` defines the meaning of answers, the crate
//! `report` writes pages, and the crate `studies` handles questions across many scenes.
//!
//! * [`roster`]: all backends by name.
//! * [`run`]: one backend on one scene, including panics and refusals (of the crate `tasks`).
//! * [`expect`]: the expected findings.
//! * [`pattern`]: the scenes that an expectation is about.
//! * [`known`]: the scenes that expectations can refer to.
//! * [`faults`]: faulty backends, and the checks that must detect them.
//! * [`guards`]: faults in judging and in reading, and the checks that compare both with known facts.

pub mod expect;
pub mod faults;
pub mod guards;
pub mod known;
pub mod pattern;
pub mod roster;

mod boxed;
mod lacking;
mod program;
mod shortcut;
mod twice;
mod visit;

pub use predicament_tasks::{caught, run, run_spoiled};
