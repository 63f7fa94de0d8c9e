//! Searches among scenes: from a finding to the smallest scene that shows it, and from any scenes to a finding.
//!
//! Both searches edit scenes as they are [written out](predicament_corpus::Spelled), so they do not depend on a task.
//! They query a [`Witness`] about each scene, so they do not depend on a backend. The result is a scene of a suite.
//!
//! * [`hunt`]: scenes that show a finding, from any scenes.
//! * [`shrink`]: the smallest scene that still shows a finding.
//! * [`files`]: the smallest files on which a command still fails.
//! * [`snippets`]: such a scene as a test in Rust, C++, Python and JavaScript.
//! * [`Witness`], [`Wanted`]: the finding that a scene must show.
//! * [`SearchError`]: errors that prevent or end a search.

pub mod files;
pub mod hunt;
pub mod shrink;
pub mod snippets;

mod edit;
mod error;
mod rows;
mod witness;

pub use edit::{drop_constructions, drop_points, drop_unnamed, merge};
pub use error::SearchError;
pub use witness::{Backends, Wanted, Witness};
