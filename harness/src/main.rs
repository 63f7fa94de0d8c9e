//! The tool as it comes: the backends and tasks of the house.

use std::process::ExitCode;

fn main() -> ExitCode {
    predicament::cli().main()
}
