//! Where the expectations come from: the ones that ship with the corpora, or a file.

use std::path::{Path, PathBuf};

use predicament_oracle::expect::Expectations;

use crate::exit::{CORPUS, Failure};

/// The expectations that ship with the embedded corpora.
const SHIPPED: &str = include_str!("../../corpora/expected.toml");

/// Reads the expectations of `file`, or the shipped ones.
pub fn load(file: Option<&PathBuf>) -> Result<Expectations, Failure> {
    let (path, text) = match file {
        None => (Path::new("corpora/expected.toml"), SHIPPED.to_owned()),
        Some(file) => {
            let text = std::fs::read_to_string(file).map_err(|error| {
                Failure::usage(format!("{}: {error}; give a readable TOML file with --expected", file.display()))
            })?;
            (file.as_path(), text)
        }
    };
    Expectations::parse(path, &text).map_err(|message| Failure { message, code: CORPUS })
}
