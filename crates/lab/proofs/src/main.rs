//! Proves the constants of filters and the bounds of tolerances: `prove FOLDER`, called by `cargo xtask prove`.

use std::path::PathBuf;
use std::process::ExitCode;

use predicament_proofs::{gappa, report};

fn main() -> ExitCode {
    let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) else {
        eprintln!("prove: name a folder for the scripts");
        return ExitCode::from(2);
    };
    if !gappa::is_here("gappa") {
        println!("NOT RUN: there is no `gappa` here, so no constant was proved; Debian's package is `gappa`");
        return ExitCode::SUCCESS;
    }
    let made = std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()));
    match made.and_then(|()| report::all(&folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("prove: {message}");
            ExitCode::FAILURE
        }
    }
}
