//! The tool with this task added.

fn main() -> std::process::ExitCode {
    predicament::cli()
        .task(convexity::Convexity)
        .suites(concat!(env!("CARGO_MANIFEST_DIR"), "/corpora"))
        .expected(concat!(env!("CARGO_MANIFEST_DIR"), "/expected.toml"))
        .main()
}
