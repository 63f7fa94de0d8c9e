//! Scenes: the format, lossless coordinates, content ids, generators,
//! importers and the fetch manifest.
//!
//! A [`Library`] holds [`Suite`]s, a suite holds [`SceneDef`]s, and
//! [`SceneDef::load`] turns one into a [`LoadedScene`]: points, questions, and
//! an id that depends on nothing else. This crate knows no backend; what the
//! right answers are is not its business. `docs/FORMAT.md` describes the files.

mod bits;
mod cache;
mod coordinate;
mod degeneracy;
mod document;
mod error;
mod fetch;
mod fmt;
mod generate;
pub mod hexfloat;
mod homogeneous;
mod id;
mod import;
mod library;
mod loaded;
mod manifest;
mod probes;
mod sigma;
mod suite;
mod tables;
mod task;
mod thresholds;

pub use cache::Cache;
pub use coordinate::{CoordinateError, exact as exact_coordinate};
pub use degeneracy::{Histogram, degeneracy};
pub use error::{CorpusError, ErrorKind};
pub use fetch::fetch;
pub use fmt::fmt;
pub use generate::{FamilyInfo, Random, families};
pub use homogeneous::homogeneous;
pub use id::{SeenIds, content_id};
pub use import::ImportNotes;
pub use library::Library;
pub use loaded::{LoadedScene, Probe, ProbeKind, Work};
pub use manifest::{Entry, Manager, Manifest};
pub use suite::{SceneDef, Suite};
pub use task::{Level, Task};
pub use thresholds::{ThresholdPairs, Thresholds};
