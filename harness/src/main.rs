//! The tool with the built-in backends and tasks.

use std::process::ExitCode;

fn main() -> ExitCode {
    predicament::cli().main()
}
