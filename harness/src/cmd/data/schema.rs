//! `schema`: the meaning of the columns of all tables.

use std::path::PathBuf;

use clap::ValueEnum;
use predicament_export::{FRONT, OWN_TABLES};
use predicament_records::{TableSpec, replace, schema_json, schema_markdown};

use crate::exit::{self, Failure};
use crate::out::hold;
use crate::planning::every_table;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament data schema                              every table with its columns, types, units and meanings
  predicament data schema --format json | jq '.tables[] | select(.table == \"throughput\")'
  predicament data schema --splice docs/DATA.md        the same between the marks of a page of your own: \
                                                  <!-- predicament: schema --> and <!-- /predicament -->";

/// Print the columns of all tables: names, types, units, meanings
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Markdown for people, JSON for programs
    #[arg(long, value_enum, default_value_t = As::Md)]
    pub format: As,

    /// Put the schema into a Markdown page instead of printing it
    #[arg(long, value_name = "FILE", conflicts_with = "format")]
    pub splice: Option<PathBuf>,
}

/// The output format.
#[derive(Clone, Copy, PartialEq, Eq, Debug, ValueEnum)]
pub enum As {
    /// Markdown
    Md,
    /// One JSON object
    Json,
}

/// The marks in a page around the schema.
const MARKS: [&str; 2] = ["<!-- predicament: schema -->", "<!-- /predicament -->"];

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    let front = TableSpec { file: "front", columns: &[], about: ABOUT_FRONT, schema: &FRONT };
    let tables: Vec<TableSpec> = [front].into_iter().chain(OWN_TABLES).chain(every_table(tool)).collect();
    let markdown = || schema_markdown(&tables).trim().to_owned();
    match (&args.splice, args.format) {
        (Some(page), _) => {
            let named = |why: &dyn std::fmt::Display| Failure::usage(format!("{}: {why}", page.display()));
            let _hold = hold(page)?;
            let text = std::fs::read_to_string(page).map_err(|why| named(&why))?;
            let [open, close] = MARKS;
            let parts = text.split_once(open).and_then(|(before, rest)| Some((before, rest.split_once(close)?.1)));
            let (before, after) =
                parts.ok_or_else(|| named(&format!("there is no `{open}` with `{close}` after it")))?;
            let text = format!("{before}{open}\n{}\n{close}{after}", markdown());
            replace(page, text.as_bytes()).map_err(Failure::usage)?;
        }
        (None, As::Md) => say!("{}", markdown()),
        (None, As::Json) => {
            let json = serde_json::to_string_pretty(&schema_json(&tables)).map_err(Failure::usage)?;
            say!("{json}");
        }
    }
    Ok(exit::OK)
}

const ABOUT_FRONT: &str = "Every exported table begins with these columns. Files in run folders do not have them.";
