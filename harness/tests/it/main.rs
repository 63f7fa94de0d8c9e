//! The tool from outside, as a user runs it.

mod bad_input;
mod bad_meshes;
mod bounds;
mod common;
mod conformance;
mod diff;
mod engines;
mod habits;
mod isolation;
mod judged;
mod lecture;
mod limits;
mod lines_and_cubes;
mod merge;
mod mesh_intersections;
mod mesh_points;
mod output;
mod own_data;
mod own_files;
mod paths;
#[cfg(feature = "peers")]
mod peers;
mod pictures;
mod resolve;
mod runs;
mod scorecard;
mod show;
mod studies;
mod threads;
mod tutorial;
