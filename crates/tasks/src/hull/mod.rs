//! `hull2d` and `hull3d`: convex hulls of points.
//!
//! The smallest algorithms whose loops are steered by signs alone: a wrong turn cuts a vertex off, a wrong side opens the
//! surface. Each has two methods, which give the same answer where signs do not contradict each other.

mod cloud;
mod generate;
mod judge;
mod plane;
mod space;
mod write;

pub use cloud::{Cloud, Method};
pub use judge::Truth;
pub use plane::{Hull2d, Polygon};
pub use space::{Hull3d, Surface};
