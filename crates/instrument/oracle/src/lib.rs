//! The oracle: runs backends on tasks and holds every answer against the truth.
//!
//! It says which answers are wrong, under which promise, and whether that was
//! expected. It decides nothing about geometry itself: truth is the crate
//! `judge`, what an answer means is the crate `tasks`, pages are the crate
//! `report`, and questions across many scenes are the crate `studies`.
//!
//! * [`roster`]: all backends by name.
//! * [`run`]: one backend on one scene, panics and refusals included (of the crate `tasks`).
//! * [`expect`]: which findings are expected.
//! * [`pattern`]: which scenes an expectation is about.
//! * [`known`]: which scenes there are for it to be about.
//! * [`faults`]: wrong backends that have to be caught, and by which check.
//! * [`guards`]: faults in what judges and what reads, and the checks that hold both to known facts.

pub mod expect;
pub mod faults;
pub mod guards;
pub mod known;
pub mod pattern;
pub mod roster;

mod boxed;
mod twice;
mod visit;

pub use predicament_tasks::{caught, run, run_spoiled};
