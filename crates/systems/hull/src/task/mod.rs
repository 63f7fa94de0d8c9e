//! `hull2d` and `hull3d`: convex hulls of points.
//!
//! These are the smallest algorithms in which signs alone steer the loops: a wrong turn cuts a vertex off, a wrong side
//! opens the surface. Each task has two methods, which give the same answer if signs do not contradict each other.

mod answer;
mod checks;
mod cloud;
mod generate;
mod judge;
mod plane;
mod replies;
mod space;
mod spoiled;

pub use answer::{Hull2d, Hull3d, Polygon, Surface};
pub use cloud::{Cloud, Method};

/// The suite that `new` writes, with points for hulls of four or five vertices, the first method and a family with
/// ties.
fn template(points: &str, method: &str, family: &str) -> String {
    let template = include_str!("template.txt").replace("{points}", points);
    template.replace("{method}", method).replace("{family}", family)
}
