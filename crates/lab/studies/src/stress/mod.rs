//! The stress study: the position of each knob at which backends break, one knob at a time.
//!
//! A scene is made for a task, and its points are moved as a knob says: by noise, away from the origin, larger,
//! flatter, rounded, turned. The content stays, so that only the moves change; the truth is computed again for each
//! scene. The *break point* of a backend is the position where it begins to answer against its promise.
//!
//! * [`Stress`]: the study.
//! * [`Knob`](predicament_tasks::Knob): the change and its range; each task limits the range of its scenes.
//! * [`Limit`]: a knob that does not fit a task.
//! * [`BreakPoint`]: the position at which a backend breaks.
//! * `laws.rs`: answers that must not change if points move exactly (metamorphic laws).

mod breaks;
mod laws;
mod limits;
mod plots;
mod scenes;
mod section;
mod study;
mod suites;
mod table;
mod turned;

pub(crate) use breaks::Asked;
pub use breaks::BreakPoint;
pub use laws::{Law, Violations};
pub use limits::Limit;
pub use section::section;
pub use study::{Stress, Stressed};
pub(crate) use turned::turned;
