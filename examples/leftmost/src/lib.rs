//! A task, a backend and a study outside of the workspace: what a crate of your own looks like.
//!
//! `docs/TASKS.md` walks through the task, `docs/BACKENDS.md` through the backend, `docs/STUDIES.md` through the study.

mod backend;
mod content;
mod judge;
mod section;
mod study;
mod task;

pub use backend::ByDifference;
pub use content::Among;
pub use section::LeftmostRow;
pub use study::Column;
pub use task::{Found, Leftmost};
