//! Checks of triangulations of polygons, decided in integers.
//!
//! [`Polygon`] holds the truth about a set of loops: which of them are holes, the area, the number of triangles, where
//! loops cross, and where they touch. [`flaws`] compares triangles with it. Neither knows how triangles are made; both
//! see coordinates as integers in a common unit.
//!
//! # The checks
//! * `loops do not cross`: of the polygon, before any check of triangles;
//! * `vertices`: three different vertices of the polygon;
//! * `count`: n + 2h − 2c, two fewer for each further loop that passes through a vertex from inside another loop;
//! * `positive`: no triangle is clockwise, and a flat triangle occurs only where loops touch;
//! * `area`: areas add up to the polygon's;
//! * `boundary`: each edge of a loop is a side of one triangle, in its direction;
//! * `diagonals`: each other side is a side of two triangles, in both directions;
//! * `overlap`: no two triangles have an inner point in common. The other checks imply it; this check compares all
//!   pairs, if there are few.
//!
//! [`uncovered`] holds triangles of other programs against the polygon: they need not use all of its vertices.

mod cover;
mod flaws;
mod nesting;
mod plane;
mod polygon;
mod touches;

pub use cover::uncovered;
pub use flaws::{Flat, Flaw, flaws};
pub use polygon::Polygon;
pub use touches::{Touch, Touches};
