//! The packages of test vectors for npm and pip; the workspace has the one for cargo.

use crate::command::{answers, fresh, root, step, words};
use crate::python::interpreter;

/// The test of the package for npm, from the folder of the workspace.
const NPM: &str = "vectors/npm/test.js";
/// The tests of the package for pip.
const PIP: &str = "vectors/pip/tests/test_vectors.py";

/// Runs their tests, which say themselves if a peer is missing; prints which do not run.
///
/// # Errors
/// If a test fails.
pub fn check() -> Result<(), String> {
    let python = interpreter();
    let env = [("PYTHONPATH", "vectors/pip".to_owned()), ("PYTHONDONTWRITEBYTECODE", "1".to_owned())];
    for (language, program, arguments) in [("JavaScript", "node", vec![NPM]), ("Python", &python, vec![PIP, "-v"])] {
        if answers(program, &["--version"]) {
            step(&format!("test vectors in {language}"), &words(program, &arguments), &env)?;
        } else {
            println!("\n== test vectors in {language}: NOT RUN: there is no `{program}` here");
        }
    }
    Ok(())
}

/// Installs the peers and the package for pip, and runs the tests.
///
/// # Errors
/// If a package can't be installed, or a test fails.
pub fn check_with_peers() -> Result<(), String> {
    let install = ["install", "--prefix", "vectors/npm", "--no-package-lock", "--no-audit", "--no-fund"];
    step("peer of the test vectors in JavaScript", &words("npm", &install), &[])?;
    step("test vectors in JavaScript", &words("node", &[NPM]), &[])?;
    let folder = root().join(fresh("target/vectors")?);
    step("an environment of Python", &words(&interpreter(), &["-m", "venv", &folder.display().to_string()]), &[])?;
    let python = folder.join(if cfg!(windows) { "Scripts" } else { "bin" }).join("python").display().to_string();
    let install = ["-m", "pip", "install", "--quiet", "./vectors/pip[test]"];
    step("the package of test vectors and its peer", &words(&python, &install), &[])?;
    step("test vectors in Python", &words(&python, &[PIP, "-v"]), &[])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loaders_have_thirty_lines() {
        for loader in ["cargo/src/lib.rs", "npm/index.js", "pip/predicament_vectors/__init__.py"] {
            let text = std::fs::read_to_string(root().join("vectors").join(loader)).expect("a loader");
            assert!(text.lines().count() <= 30, "{loader}: {} lines", text.lines().count());
        }
    }
}
