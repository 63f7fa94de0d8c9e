//! The library of scenes: suites, their definitions, and content ids.
//!
//! A [`Library`] holds [`Suite`]s, and a suite holds [`SceneDef`]s. [`SceneDef::load`] returns a [`LoadedScene`]:
//! points, the questions about them, and an id that depends on nothing else. The task defines the meaning of its keys
//! ([`SceneFormat`]); this crate refers to no particular task or backend, and does not compute correct answers. The
//! crate `formats` reads files; the tasks are in the crate `tasks`. `docs/FORMAT.md` describes the files.

mod content;
mod data;
mod fmt;
mod format;
mod homogeneous;
mod id;
mod level;
mod library;
mod loaded;
mod numbering;
mod spelled;
mod suite;

pub use content::{Content, Elsewhere, Parts, Source};
pub use data::{LocatedPoints, Origin, PointSource};
pub use fmt::fmt;
pub use format::{Family, InDecimals, Making, Recipe, SceneFormat, Vocabulary};
pub use homogeneous::{homogeneous, integer, lowest_exponent, meet};
pub use id::{Canon, SeenIds, content_id};
pub use level::Level;
pub use library::Library;
pub use loaded::{LoadedScene, MoveError};
pub use numbering::{Unnumbered, numbered, unnumbered};
pub use predicament_families::Random;
pub use spelled::{Heading, Items, List, Spelled, coordinate, spelled_points};
pub use suite::{Context, SceneDef, Suite};
