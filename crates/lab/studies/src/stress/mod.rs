//! Where do backends break? One knob at a time.
//!
//! A scene is made for a task, and its points are moved as a knob says: by noise, away from the origin, larger, flatter, rounded, turned. The
//! content stays, so that one knows what has changed; what is true is found anew for each scene. The *break point* of a backend is where it
//! begins to answer against its promise, and what it did before.
//!
//! * [`Stress`]: the study.
//! * [`Knob`](predicament_tasks::Knob): what is turned, and how far; each task says how far its scenes can be.
//! * [`Limit`]: a knob that does not fit a task.
//! * [`BreakPoint`]: where a backend breaks.
//! * `laws.rs`: what must not change where points move exactly (metamorphic laws).

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
