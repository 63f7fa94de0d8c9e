//! Searching among scenes: from a finding to the smallest scene that shows it, and from any scenes to a finding.
//!
//! Both edit scenes as they are [written out](predicament_corpus::Spelled), so they know no task, and ask a
//! [`Witness`] what a backend does on each, so they know no backend. What is found is a scene of a suite.
//!
//! * [`hunt`]: scenes that show a finding, from any scenes.
//! * [`shrink`]: the smallest scene that still shows a finding.
//! * [`snippets`]: such a scene as a test in Rust, C++ and Python.
//! * [`Witness`], [`Wanted`]: what is asked of a scene.
//! * [`SearchError`]: why a search does not begin, or cannot go on.

pub mod hunt;
pub mod shrink;
pub mod snippets;

mod edit;
mod error;
mod witness;

pub use edit::{drop_constructions, drop_points, drop_unnamed, merge};
pub use error::SearchError;
pub use witness::{Backends, Wanted, Witness};
