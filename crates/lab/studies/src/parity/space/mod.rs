//! The same in space: do registrations break the curves in which closed surfaces cross?
//!
//! Two closed surfaces cross in closed curves, and the boundary of a triangle
//! of the one passes through the other an even number of times. Where
//! registrations say otherwise, they contradict each other. Surfaces are
//! embedded, decided exactly; that each is closed is in its triangles.
//!
//! * [`SurfacePair`]: two closed surfaces; [`random_surfaces`]: those of the recipes.
//! * [`examine`]: what a backend's registrations make of a pair.
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
