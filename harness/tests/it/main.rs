//! The tool from outside, as a user runs it.

mod bad_input;
mod bounds;
mod common;
mod judged;
mod limits;
mod lines_and_cubes;
mod output;
mod own_data;
mod paths;
#[cfg(feature = "peers")]
mod peers;
mod runs;
mod studies;
mod threads;
