//! The study of parity in space: whether registrations break the curves in which closed surfaces cross.
//!
//! Two closed surfaces cross in closed curves, and the boundary of a triangle of one passes through the other an even
//! number of times. If registrations say otherwise, they contradict each other. Surfaces are embedded, decided exactly;
//! their triangles show that each is closed.
//!
//! * [`SurfacePair`]: two closed surfaces; [`random_surfaces`]: random pairs of each recipe.
//! * [`examine`]: merges a pair by a backend's registrations and counts contradictions.
//! * [`search`]: many pairs, counted; [`shrink_broken`]: the smallest that a find can be reduced to.

mod examine;
mod kind;
mod pair;
mod random;
mod search;
mod shapes;
mod table;

pub use examine::{Broken, Examined, examine};
pub use kind::Kind;
pub use pair::{Surface, SurfacePair, shrink_broken};
pub use random::{Recipe, random_surfaces};
pub use search::{Census, Found, Row, search};

pub(super) use table::{csv, page, scene_name, ways};
