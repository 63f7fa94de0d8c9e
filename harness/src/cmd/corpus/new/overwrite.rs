//! Whether a file that is there may be overwritten: by an option, or by a person at a terminal.

use std::io::{BufRead as _, IsTerminal as _, Write as _};
use std::path::Path;

use crate::exit::Failure;

/// Asks before a file is overwritten; without a terminal that is refused.
///
/// # Errors
/// If the file is there and nobody allows it.
pub fn allowed(file: &Path, force: bool) -> Result<(), Failure> {
    if force || !file.exists() {
        return Ok(());
    }
    let shown = file.display();
    if !(std::io::stdin().is_terminal() && std::io::stderr().is_terminal()) {
        return Err(Failure::usage(format!("{shown}: the file is there; name another, or overwrite it with --force")));
    }
    let mut stderr = std::io::stderr();
    let _ = write!(stderr, "{shown} is there. Overwrite it? [y/N] ").and_then(|()| stderr.flush());
    let mut answer = String::new();
    std::io::stdin().lock().read_line(&mut answer).map_err(|error| Failure::usage(format!("stdin: {error}")))?;
    if is_yes(&answer) { Ok(()) } else { Err(Failure::usage(format!("{shown}: the file stays as it is"))) }
}

/// Whether an answer is yes: everything else, an empty line or the end of input too, is no.
fn is_yes(answer: &str) -> bool {
    matches!(answer.trim().to_lowercase().as_str(), "y" | "yes")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_is_the_default() {
        for (answer, yes) in
            [("y\n", true), ("YES\r\n", true), ("\n", false), ("", false), ("n\n", false), ("yy\n", false)]
        {
            assert_eq!(is_yes(answer), yes, "{answer:?}");
        }
    }
}
