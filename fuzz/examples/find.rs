//! Prints the finds of a fuzz target as scenes of a suite.
//!
//! Usage: `cargo run --release --example find -- TARGET artifacts/TARGET/crash-… NAME`.

use std::process::ExitCode;

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [target, file, name] = args.as_slice() else {
        eprintln!("usage: find TARGET FILE NAME: a file of artifacts/TARGET, and the name that the scene gets");
        return ExitCode::from(2);
    };
    let bytes = std::fs::read(file).map_err(|error| format!("{file}: {error}"));
    match bytes.and_then(|bytes| predicament_fuzz::finds::scene(target, name, &bytes)) {
        Ok(tables) => {
            print!("{tables}");
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("find: {file}: {why}");
            ExitCode::from(2)
        }
    }
}
