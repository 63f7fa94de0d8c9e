//! Rustdoc with a folder for each crate.
//!
//! Cargo writes the pages of all crates into one folder, and each call of rustdoc reads and writes the index for searching
//! of all that were there before: with 40 crates this is most of its time. A page that is only checked needs no common index. Cargo
//! calls this program in rustdoc's place ([`REAL`] is set), and it calls rustdoc.

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::process::{Command, ExitCode};

/// The variable with the real rustdoc; where it is set, this program stands for it.
pub const REAL: &str = "PREDICAMENT_XTASK_RUSTDOC";

/// Calls rustdoc with these arguments, but for the folder.
pub fn run(real: &OsStr, arguments: impl Iterator<Item = OsString>) -> ExitCode {
    match Command::new(real).args(apart(arguments.collect())).status() {
        Ok(status) if status.success() => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("xtask: {}: {error}", Path::new(real).display());
            ExitCode::FAILURE
        }
    }
}

/// The arguments, with the name of the crate after the folder.
fn apart(mut arguments: Vec<OsString>) -> Vec<OsString> {
    let after =
        |arguments: &[OsString], option: &str| arguments.iter().position(|word| word == option).map(|at| at + 1);
    let name = after(&arguments, "--crate-name").and_then(|at| arguments.get(at).cloned());
    if let (Some(name), Some(folder)) = (name, after(&arguments, "-o").and_then(|at| arguments.get_mut(at))) {
        *folder = Path::new(&*folder).join("each").join(name).into();
    }
    arguments
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crate_has_a_folder_of_its_own() {
        let words = |words: &[&str]| words.iter().map(OsString::from).collect::<Vec<_>>();
        let given = words(&["--crate-name", "hull", "lib.rs", "-o", "doc", "--cfg", "a"]);
        let folder = Path::new("doc").join("each").join("hull");
        let expected = words(&["--crate-name", "hull", "lib.rs", "-o", folder.to_str().unwrap(), "--cfg", "a"]);
        assert_eq!(apart(given), expected);
        assert_eq!(apart(words(&["-vV"])), words(&["-vV"]));
    }
}
