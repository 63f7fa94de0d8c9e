//! `corpus fmt`: decimals with digits that no double holds, written as hex floats.

use std::path::{Path, PathBuf};

use predicament_corpus::fmt;
use predicament_formats::{Columns, CorpusError, fmt_csv, read_as_it_is};
use predicament_records::replace;

use crate::columns;
use crate::exit::{self, CORPUS, Failure};
use crate::out::hold;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Each such decimal becomes the hex float of its nearest double, with the decimal as a comment. The rest of a file stays as it \
is. The result is a new file beside the old one: NAME.hex.toml or NAME.hex.csv. An earlier file of that name is replaced. \
Files without such decimals need no new file.

Examples:
  predicament corpus fmt mine.toml points.csv           writes mine.hex.toml and points.hex.csv
  predicament corpus fmt --in-place mine.toml
  predicament corpus fmt --check corpora/*.toml         exit code 104 if a file has such decimals
  predicament corpus fmt towns.csv --columns lon,lat    other columns stay as they are";

/// Write decimals with digits that no double holds as hex floats of the nearest doubles, into a file beside
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// TOML and CSV files
    #[arg(required = true)]
    files: Vec<PathBuf>,

    /// Write nothing; fail if a file has such decimals
    #[arg(long)]
    check: bool,

    /// Rewrite the files themselves
    #[arg(long, conflicts_with = "check")]
    in_place: bool,

    /// The columns of x and y (and z) in CSV files, by names in the header or numbers from 1; all if left out, or those
    /// that the header names without doubt
    #[arg(long, value_name = "COLUMNS", value_parser = columns::parse)]
    columns: Option<Columns>,
}

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let mut changed = 0;
    for file in &args.files {
        let name = file.display().to_string();
        let target = if args.in_place { file.clone() } else { beside(file) };
        let _hold = if args.check { None } else { Some(hold(&target)?) };
        let (text, tidy) = tidied(args, tool, file, &name)?;
        if tidy == text {
            if !args.check {
                note!("{name}: every decimal is read as it is; nothing is written");
            }
            continue;
        }
        changed += 1;
        if args.check {
            say!("would change: {name}");
            continue;
        }
        replace(&target, tidy.as_bytes()).map_err(Failure::usage)?;
        match args.in_place {
            true => say!("changed: {name}"),
            false => say!("written: {}", target.display()),
        }
    }
    Ok(if args.check && changed > 0 { CORPUS } else { exit::OK })
}

/// The name of the new file: `.hex` before the extension.
fn beside(file: &Path) -> PathBuf {
    let extension = file.extension().map_or_else(String::new, |extension| extension.to_string_lossy().into_owned());
    file.with_extension(format!("hex.{extension}"))
}

/// The text of a file before and after tidying.
fn tidied(args: &Args, tool: &Tool, file: &Path, name: &str) -> Result<(String, String), Failure> {
    let extension = file.extension().map(|extension| extension.to_string_lossy().to_lowercase());
    let by_lines = match extension.as_deref() {
        Some("toml") => false,
        Some("csv" | "txt") => true,
        _ => {
            let cure = "name a .toml, .csv or .txt file; for other data write `round = true` in the scene";
            return Err(CorpusError::usage(name, "only suites and CSV files can be rewritten", cure).into());
        }
    };
    if !by_lines && args.columns.is_some() {
        return Err(CorpusError::usage(name, "only CSV files have columns", "leave --columns out").into());
    }
    let text = read_as_it_is(file)?;
    let tidy = match by_lines {
        true => fmt_csv(name, &text, args.columns.as_ref())?,
        false => fmt(tool.vocabulary(), name, &text)?,
    };
    Ok((text, tidy))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_new_file_is_beside() {
        for (file, new) in [("a/p.csv", "a/p.hex.csv"), ("mine.v2.toml", "mine.v2.hex.toml"), ("P.CSV", "P.hex.CSV")] {
            assert_eq!(beside(Path::new(file)), Path::new(new));
        }
    }
}
