//! The tool with one more task and one more backend.

use std::process::ExitCode;

use leftmost::{ByDifference, Leftmost};

fn main() -> ExitCode {
    predicament::cli()
        .task(Leftmost)
        .backend(ByDifference)
        .suites(concat!(env!("CARGO_MANIFEST_DIR"), "/corpora"))
        .expected(concat!(env!("CARGO_MANIFEST_DIR"), "/expected.toml"))
        .main()
}
