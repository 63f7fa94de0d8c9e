//! The tool with the built-in backends and tasks.

use std::process::ExitCode;

/// The judges' numbers are many small allocations, which take a seventh of a run by the C library's allocator.
#[cfg(target_os = "linux")]
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> ExitCode {
    predicament::cli().main()
}
