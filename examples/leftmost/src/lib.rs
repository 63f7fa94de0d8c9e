//! A task and a backend outside of the workspace: what a crate of your own looks like.
//!
//! `docs/TASKS.md` walks through the task, `docs/BACKENDS.md` through the backend.

mod backend;
mod content;
mod judge;
mod section;
mod task;

pub use backend::ByDifference;
pub use content::Among;
pub use section::LeftmostRow;
pub use task::{Found, Leftmost};
