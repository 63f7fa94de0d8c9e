//! Triangulations of polygons, decided in integers.
//!
//! [`Polygon`] is what is true about a set of loops by itself: which of them are holes, the area, how many triangles there
//! are, where loops cross, and where they touch. [`flaws`] holds triangles against it. Neither knows how triangles are made;
//! both see coordinates as integers in a common unit.
//!
//! # The checks
//! * `loops do not cross`: of the polygon, before anything is said about triangles;
//! * `vertices`: three different vertices of the polygon;
//! * `count`: n + 2h − 2c, two fewer for each further loop that passes through a vertex from inside another;
//! * `positive`: no triangle is clockwise, and none is flat but where loops touch;
//! * `area`: areas add up to the polygon's;
//! * `boundary`: each edge of a loop is a side of one triangle, in its direction;
//! * `diagonals`: each other side is one of two triangles, in both directions;
//! * `overlap`: no two triangles have an inner point in common. The others imply it; this one looks at pairs, where they are
//!   few.

mod flaws;
mod nesting;
mod plane;
mod polygon;
mod touches;

pub use flaws::{Flat, Flaw, flaws};
pub use polygon::Polygon;
pub use touches::{Touch, Touches};
