//! Where the expectations come from: the ones that ship with the corpora, or a file.

use std::path::{Path, PathBuf};

use predicament_corpus::Suite;
use predicament_formats::{hex, read_suite};
use predicament_oracle::expect::{Expectations, Known, Unused};
use predicament_records::{Error, ExpectedFile, Plan};
use sha2::{Digest, Sha256};

use crate::exit::{CORPUS, Failure};
use crate::tool::Tool;

/// The file of the corpora that has the expectations.
const SHIPPED: &str = "expected.toml";

/// Reads the expectations of `file`; without one the shipped ones, and those of the tool's maker.
pub fn load(tool: &Tool, file: Option<&PathBuf>) -> Result<Expectations, Failure> {
    if let Some(file) = file {
        return read(file);
    }
    let (name, text) = tool.library()?.companion(SHIPPED)?.unwrap_or_default();
    let shipped = Expectations::parse(Path::new(&name), &text);
    let shipped = shipped.map_err(|message| Failure { message, code: CORPUS })?;
    match &tool.expected {
        None => Ok(shipped),
        Some(own) => Ok(shipped.and(read(own)?)),
    }
}

/// What a plan says of a file of expectations.
pub fn file(file: &Path) -> Result<ExpectedFile, Failure> {
    let cannot = |error: std::io::Error| Failure::usage(Error::io(file)(error));
    let text = std::fs::read(file).map_err(cannot)?;
    let place = std::path::absolute(file).map_err(cannot)?;
    Ok(ExpectedFile { file: place.display().to_string(), sha256: hex(&Sha256::digest(text)) })
}

fn read(file: &Path) -> Result<Expectations, Failure> {
    let text = read_suite(file).map_err(|error| {
        let message = error.message.replace("the suite", "the file");
        Failure::usage(format!("{}: {message}; give a readable TOML file with --expected", file.display()))
    })?;
    Expectations::parse(file, &text).map_err(|message| Failure { message, code: CORPUS })
}

/// The expectations that the run of this plan has not put to the test.
pub fn unused(expected: &Expectations, tool: &Tool, plan: &Plan) -> Result<Unused, Failure> {
    let library = tool.library()?;
    let mut scenes: Vec<(String, String)> = Vec::new();
    let mut add = |suite: &Suite| {
        scenes.extend(suite.scenes.iter().map(|def| (def.suite.clone(), def.name.clone())));
    };
    library.suites().iter().chain(&tool.own_suites()?).for_each(&mut add);
    // All scenes of a suite that was named by file, also those that a filter left out.
    for file in plan.paths.values().filter(|file| Path::new(file).exists()) {
        add(&library.suite(file)?);
    }
    let planned: Vec<(String, String)> =
        plan.scenes.iter().map(|scene| (scene.suite.clone(), scene.scene.clone())).collect();
    scenes.extend(planned.iter().cloned());
    let known = Known {
        scenes: &scenes,
        planned: &planned,
        backend: &|name| plan.backends.iter().any(|planned| planned == name) || tool.knows_backend(name),
        backends: &plan.backends,
        level: &plan.level.to_string(),
    };
    let mut unused = expected.unused(&known);
    let is_own =
        |suite: &String| plan.paths.contains_key(suite) || !library.suites().iter().any(|of| of.name == *suite);
    if plan.suites.iter().all(is_own) {
        // What ships with the tool is about none of the user's suites.
        unused.here.retain(|place| !place.starts_with(&format!("corpora/{SHIPPED}:")));
    }
    Ok(unused)
}
