//! The page about results as data: DuckDB and pandas, in a separate environment, run its blocks, and R does if it has
//! the packages.

use crate::command::{answers, fresh, root, step};

/// The folder of the Python environment.
const FOLDER: &str = "target/data";
/// The packages of the environment: DuckDB, pandas and pyarrow, with digests.
pub const REQUIREMENTS: &str = "crates/xtask/python/requirements.txt";

/// An R program that fails if a package of the page is not installed.
const PACKAGES_OF_R: &str = "library(nanoparquet); library(dplyr)";

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
    let install =
        [&python, "-m", "pip", "install", "--quiet", "--require-hashes", "--only-binary=:all:", "-r", REQUIREMENTS];
    step("install what the page uses", &words(&install), &[])?;
    let test =
        ["cargo", "test", "--profile", "ci", "-p", "predicament", "--test", "it", "--", "--ignored", "page_of_data"];
    step("blocks of the page about data", &words(&test), &[("PREDICAMENT_PYTHON", python)])?;
    if !answers("Rscript", &["-e", PACKAGES_OF_R]) {
        println!(
            "\n== R's block of the page about data: NOT RUN: there is no R with nanoparquet and dplyr here; type \
             `install.packages(c(\"nanoparquet\", \"dplyr\"))` in R"
        );
        return Ok(());
    }
    let test = [&test[..test.len() - 1], &["page_in_r"]].concat();
    step("R's block of the page about data", &words(&test), &[])
}
