//! The library of scenes: suites, what they define, and content ids.
//!
//! A [`Library`] holds [`Suite`]s, a suite holds [`SceneDef`]s, and
//! [`SceneDef::load`] makes one a [`LoadedScene`]: points, what is asked about
//! them, and an id that depends on nothing else. What a task's keys mean comes
//! from the task ([`SceneFormat`]); this crate names no task and no backend, and
//! never says what is true. How files are read is the crate `formats`; the tasks
//! are the crate `tasks`. `docs/FORMAT.md` describes the files.

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
mod random;
mod spelled;
mod suite;

pub use content::{Content, Elsewhere, Parts, Source};
pub use data::{LocatedPoints, Origin, PointSource};
pub use fmt::fmt;
pub use format::{Family, Making, Recipe, SceneFormat, Vocabulary};
pub use homogeneous::{homogeneous, integer, lowest_exponent, meet};
pub use id::{Canon, SeenIds, content_id};
pub use level::Level;
pub use library::Library;
pub use loaded::{LoadedScene, MoveError};
pub use numbering::{Unnumbered, numbered, unnumbered};
pub use random::Random;
pub use spelled::{Heading, Items, List, Spelled, coordinate, spelled_points};
pub use suite::{Context, SceneDef, Suite};
