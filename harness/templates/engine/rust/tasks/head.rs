//! The engine {name}. It answers the task {task}, in plain doubles: near a degenerate case the answer is wrong.
//!
//! REPLACE the body of `{function}` by a call of your library. The trait `Engine` in `predicament_engine/mod.rs` has
//! the parameters and the results of all tasks. Stdout belongs to the protocol: print with `eprintln!`.

// An engine does not use all of the helper.
#[allow(dead_code)]
mod predicament_engine;

use predicament_engine::*;

#[derive(Default)]
struct Mine;

impl Engine for Mine {
    const NAME: &'static str = "{name}";
    const TASKS: &'static [Task] = &[Task::{variant}];

    /// The version of your library.
    fn version() -> String {
        "1.0".to_owned()
    }
