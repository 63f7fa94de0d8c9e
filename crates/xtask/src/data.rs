//! The page about results as data: its blocks are run by DuckDB and pandas, in an environment of their own.

use crate::steps::{answers, fresh, root, step};

/// Where the environment of Python is.
const FOLDER: &str = "target/data";
/// What is installed in it.
const PACKAGES: [&str; 3] = ["duckdb", "pandas", "pyarrow"];

/// Makes the environment and runs the tests that need it.
///
/// # Errors
/// If there is no Python, a package can't be installed, or a test fails.
pub fn check() -> Result<(), String> {
    if !answers("python3", &["-m", "venv", "--help"]) {
        return Err("the page about data needs python3 with venv, so it was not tested".to_owned());
    }
    let folder = root().join(fresh(FOLDER)?).join("python").display().to_string();
    let words = |words: &[&str]| words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>();
    step("an environment of Python", &words(&["python3", "-m", "venv", &folder]), &[])?;
    let python = format!("{folder}/bin/python");
    let install = [&[&python[..], "-m", "pip", "install", "--quiet"][..], &PACKAGES].concat();
    step("install what the page uses", &words(&install), &[])?;
    let test =
        ["cargo", "test", "--profile", "ci", "-p", "predicament", "--test", "it", "--", "--ignored", "page_of_data"];
    step("blocks of the page about data", &words(&test), &[("PREDICAMENT_PYTHON", &python)])
}
