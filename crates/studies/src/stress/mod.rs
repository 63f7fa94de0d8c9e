//! Where do backends break? One knob at a time.
//!
//! A scene is made for a task, and its points are moved as a knob says: by noise, away from the origin, larger, flatter, rounded, turned. The
//! content stays, so that one knows what has changed; what is true is found anew for each scene. The *break point* of a backend is where it
//! begins to answer against its promise, and what it did before.
//!
//! * [`Stress`]: the study.
//! * [`Knob`]: what is turned, and how far.
//! * [`BreakPoint`]: where a backend breaks.
//! * `laws.rs`: what must not change where points move exactly (metamorphic laws).

mod breaks;
mod knob;
mod laws;
mod moved;
mod plots;
mod study;
mod table;

pub use breaks::BreakPoint;
pub use knob::Knob;
pub use laws::{Law, Violations};
pub(crate) use moved::moved;
pub use study::{Stress, Stressed};
