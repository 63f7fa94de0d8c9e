//! `predicament`: is my predicate right, when does it break, and what does being right cost?
//!
//! The tool is a library, so that your own crate can test its predicates with it. A binary with all commands, and with
//! your backend next to the built-in ones:
//!
//! ```no_run
//! # use predicament::example::Mine;
//! fn main() -> std::process::ExitCode {
//!     predicament::cli().backend(Mine).main()
//! }
//! ```
//!
//! And a test that fails with the first findings, their coordinates and a line that replays them:
//!
//! ```no_run
//! # use predicament::example::Mine;
//! #[test]
//! fn holds() {
//!     predicament::conformance(Mine).level(predicament::Level::Quick).assert();
//! }
//! ```
//!
//! A predicate that is a function of points needs no backend: [`check`] tests it. The crate `predicament-conformance`
//! has this module alone, with few dependencies.
//!
//! `docs/BACKENDS.md` explains how to write a backend, `docs/TASKS.md` how to write a task. This crate parses command
//! lines and writes rows into folders; the crate `tasks` decides what is judged, `oracle` what is run, and `report`
//! what is drawn.

#[macro_use]
mod out;

mod adding;
mod answer_files;
mod baseline;
mod child;
mod citing;
mod cli;
mod cmd;
mod colour;
mod columns;
mod comment;
mod conformance;
mod death;
mod details;
pub mod example;
mod exit;
mod expect_file;
mod expectations;
mod failure;
mod formulas;
mod found;
mod host;
mod hunting;
mod interrupt;
mod judged;
mod layout;
mod ledger;
mod line_ends;
mod memory;
mod names;
mod one_scene;
mod pixels;
mod places;
mod planning;
mod precision;
mod programs;
mod progress;
mod reducing;
mod rows;
mod scoreboard;
mod scorecard;
mod select;
mod shared;
mod shrinking;
mod stopwatch;
mod temporary;
mod timing;
mod told;
mod tool;
mod vectors;
mod worker;

pub use cli::{BackendList, Cli, cli};
pub use conformance::{Conformance, conformance};
pub use exit::{CORPUS, INCOMPLETE, NOTHING_SELECTED, OK, SLOWER, UNEXPECTED, UNEXPECTED_PASS, USAGE};
pub use host::{Called, Host, interrupt};
/// The built-in systems.
pub use predicament_bundle::Systems;
/// Checks of predicates that are functions of points; they need no backend.
pub use predicament_conformance::check;
pub use predicament_corpus::{self as corpus, Level};
pub use predicament_formats as formats;
pub use predicament_judge as judge;
pub use predicament_oracle::roster::Roster;
pub use predicament_predicates as predicates;
pub use predicament_records as records;
pub use predicament_report as report;
pub use predicament_studies as studies;
pub use predicament_tasks as tasks;
pub use tool::ReportSection;

/// The code blocks of `docs/BACKENDS.md`, compiled as doc tests.
#[cfg(doctest)]
#[doc = include_str!("../../docs/BACKENDS.md")]
struct Backends;
