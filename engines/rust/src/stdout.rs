//! The program's own end of stdout.

use std::io::Write;

/// The program's end of stdout. Whatever a library prints goes to stderr.
#[cfg(unix)]
pub fn own_stdout() -> Result<impl Write, String> {
    let claimed = rustix::io::dup(std::io::stdout()).and_then(|own| {
        rustix::stdio::dup2_stdout(std::io::stderr())?;
        Ok(std::fs::File::from(own))
    });
    claimed.map_err(|error| format!("engine: stdout can't be duplicated: {error}"))
}

/// Stdout: this system has no safe call to claim it, and a library that prints breaks the protocol.
#[cfg(not(unix))]
pub fn own_stdout() -> Result<impl Write, String> {
    Ok(std::io::stdout())
}
