//! The scoreboard: libraries side by side on the tasks that are open to other programs.
//!
//! * `figures`: what the runs say about each library, by task and suite.
//! * `page`, `html`: the pages, one for each task, in Markdown and in HTML, and the table of all figures.
//! * `smallest`: the smallest scene behind a cell, as a suite and as a picture.
//!
//! What a cell says about a library depends on that library's own rows alone. Times are compared on families of scenes
//! that a bench has timed on both libraries, and the number of these stands beside the ratio.

mod figures;
pub mod html;
mod page;
mod smallest;

pub use figures::Board;
pub use page::{csv, index, page};
pub use smallest::shown;
