//! The tool with one more task, one more backend and one more study.

use std::process::ExitCode;

use leftmost::{ByDifference, Column, Leftmost};

fn main() -> ExitCode {
    predicament::cli()
        .task(Leftmost)
        .study::<Column>()
        .backend(ByDifference)
        .suites(concat!(env!("CARGO_MANIFEST_DIR"), "/corpora"))
        .expected(concat!(env!("CARGO_MANIFEST_DIR"), "/expected.toml"))
        .main()
}
