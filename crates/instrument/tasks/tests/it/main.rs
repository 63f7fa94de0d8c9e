//! The integration tests, as one binary: more binaries would link the crate and compile shared code again.

mod bad_files;
mod check_names;
mod common;
mod constructed;
mod contacts;
mod corpora;
mod fmt;
mod hostile;
mod mesh_points;
mod output;
mod outside;
mod own_data;
mod pages;
mod replies;
mod sign_scenes;
mod sizes;
mod spelled;
mod sphere;
mod tables;
mod ties;
mod timed;
