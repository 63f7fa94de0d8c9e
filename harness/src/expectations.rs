//! Where the expectations come from: the ones that ship with the corpora, or a file.

use std::path::{Path, PathBuf};

use predicament_oracle::expect::Expectations;

use crate::exit::{CORPUS, Failure};
use crate::tool::Tool;

/// The expectations that ship with the embedded corpora.
const SHIPPED: &str = include_str!("../../corpora/expected.toml");

/// Reads the expectations of `file`; without one the shipped ones, and those of the tool's maker.
pub fn load(tool: &Tool, file: Option<&PathBuf>) -> Result<Expectations, Failure> {
    if let Some(file) = file {
        return read(file);
    }
    let shipped = Expectations::parse(Path::new("corpora/expected.toml"), SHIPPED);
    let shipped = shipped.map_err(|message| Failure { message, code: CORPUS })?;
    match &tool.expected {
        None => Ok(shipped),
        Some(own) => Ok(shipped.and(read(own)?)),
    }
}

fn read(file: &Path) -> Result<Expectations, Failure> {
    let text = std::fs::read_to_string(file).map_err(|error| {
        Failure::usage(format!("{}: {error}; give a readable TOML file with --expected", file.display()))
    })?;
    Expectations::parse(file, &text).map_err(|message| Failure { message, code: CORPUS })
}
