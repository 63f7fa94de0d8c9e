//! Checks of triangulations of polygons, decided in integers.
//!
//! [`Polygon`] holds the truth about a set of loops: which of them are holes, the area, the number of triangles, where
//! loops cross, and where they touch. [`flaws`] compares triangles with a polygon without a
//! [fault](Polygon::fault). Neither knows how triangles are made; both
//! see coordinates as integers in a common unit.
//!
//! # The checks
//! * `vertices`: three different vertices of the polygon;
//! * `count`: n + 2h − 2c, two fewer for each further loop that passes through a vertex from inside another loop;
//! * `positive`: no triangle is clockwise, and a flat triangle occurs only where loops touch;
//! * `area`: areas add up to the polygon's;
//! * `boundary`: each edge of a loop is a side of one triangle, in its direction;
//! * `diagonals`: each other side is a side of two triangles, in both directions;
//! * `overlap`: no two triangles have an inner point in common. The other checks imply it; this check compares all
//!   pairs, if there are few.
//!
//! If two vertices in a row are at one place, the edge between them has no length, and triangles without area at it can
//! be more or fewer. Then `count` is not checked, and `boundary` and `diagonals` are those of [`uncovered`].
//!
//! [`limit_flaws`] holds triangles of a perturbed polygon whose loops cross against the polygon itself:
//! * `area of the limit`: areas, each without its sign, add up to the polygon's;
//! * `inside of the limit`: each point off the border is inside or outside as the polygon says.
//!
//! [`uncovered`] holds triangles of other programs against the polygon: they need not use all of its vertices.

mod cover;
mod fault;
mod flaws;
mod nesting;
mod plane;
mod polygon;
mod strands;
mod touches;

pub use cover::{limit_flaws, uncovered};
pub use fault::{Fault, FaultKind};
pub use flaws::{Flat, Flaw, flaws};
pub use polygon::Polygon;
pub use touches::{Touch, Touches};
