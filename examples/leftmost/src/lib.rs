//! A task, a backend and a study in a crate of your own, outside of the workspace.
//!
//! `docs/TASKS.md` explains the task, `docs/BACKENDS.md` the backend, `docs/STUDIES.md` the study.

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
