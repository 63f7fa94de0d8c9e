//! The study of repetition: does a backend give the same answer twice?
//!
//! An answer that depends on more than the question cannot be tested, cached or debugged. The law `repeat` needs no
//! truth: a backend is asked again in several [ways](Way), and every answer must be equal. An answer that is not is
//! `unstable`, whatever the right answer is.

mod answers;
mod row;
mod study;
mod table;
mod way;

pub use row::Row;
pub use study::Repeat;
pub use way::Way;
