//! The algorithms.
//!
//! * [`overlay`]: two meshes cut where they meet, and Boolean operations on solids.
//! * [`limit`], [`rounding`], [`cascade`]: the results as meshes of doubles, step after step.
//! * [`resolve`]: a mesh that crosses itself, without that.
//! * [`sessions`]: sessions of scenes that an algorithm makes itself.

pub mod cascade;
pub mod limit;
pub mod overlay;
pub mod resolve;
pub mod rounding;
pub mod sessions;
