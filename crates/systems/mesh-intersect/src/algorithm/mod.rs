//! The algorithms of this crate.
//!
//! * [`overlay`]: two meshes cut where they meet, and Boolean operations on solids.
//! * [`limit`], [`rounding`], [`cascade`]: the results as meshes of doubles, step after step.
//! * [`resolve`]: the resolution of a mesh that crosses itself.
//! * [`sessions`]: sessions of scenes that an algorithm makes itself.

pub mod cascade;
pub mod limit;
pub mod overlay;
mod planar;
mod ray;
pub mod resolve;
pub mod rounding;
pub mod sessions;
