//! Writes the seeds of the fuzz targets: `cargo run --release --example seeds`, in the folder of the fuzz targets.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    match predicament_fuzz::seeds::write(&Path::new(env!("CARGO_MANIFEST_DIR")).join("corpus")) {
        Ok(written) => {
            for (target, count) in written {
                println!("{target:<12} {count:>4} seeds");
            }
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("seeds: {error}");
            ExitCode::FAILURE
        }
    }
}
