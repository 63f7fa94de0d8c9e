//! The study of borders: where exactly does a backend begin to be wrong?
//!
//! A wrong answer has right answers near it. Along a line of inputs that differ in one coordinate, bisection ends at
//! two neighbouring doubles: the backend is right at one and wrong at the other. No test of a fix, or of a bound, is
//! sharper, because no double lies between the two.

mod search;
mod study;
mod suite;

pub use search::{Border, border};
pub use study::Borders;
