//! `map`: a square of queries as a picture, one tile per backend.

use std::path::PathBuf;

use predicament_predicates::Sign;
use predicament_records::replace;
use predicament_report::{PixelMap, side_by_side};
use predicament_tasks::signs::{SignQueries, classes};
use predicament_tasks::{AnyCase, Class, Contestant, Watch};

use crate::exit::{self, Failure};
use crate::interrupt;
use crate::out::program;
use crate::select::Selector;
use crate::tool::Tool;

const EXAMPLES: &str = "\
Examples:
  predicament map kettner-pixels-a --out map.png
  predicament map kettner-pixels-a -b naive,naive:first,exact,tolerance --zoom 2 --out map.png
  predicament map neighbours --suite mine.toml --out map.png";

/// Draw a square grid of queries, one pixel a query: red/yellow/blue for -/0/+, dark where it is wrong
///
/// The first queries are the lowest row. Wrong is what the backend's promise does not allow. Ties that are broken by
/// a backend that promises to break them, and zeros within the band of one that has a band, are drawn as they are
/// answered.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene's name; its number of queries has to be a square
    pub scene: String,

    /// The suite, by name or as a TOML file of your own; all that need no download if left out
    #[arg(long, value_name = "SUITE")]
    pub suite: Option<String>,

    /// Backends from left to right
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        default_value = "naive,naive:first,epsilon:1e-10,exact"
    )]
    pub backends: Vec<String>,

    /// Screen pixels to a query
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub zoom: usize,

    /// The PNG file to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    let backends = tool.pick(&args.backends)?;
    let suites = args.suite.iter().cloned().collect();
    let selection = Selector { suites, ..Selector::everything() }.select(tool)?;
    let Some(def) = selection.defs().into_iter().find(|def| def.name == args.scene) else {
        return Err(Failure::nothing(format!(
            "no scene is called `{}`; `{} corpus list --scenes` names them",
            args.scene,
            program()
        )));
    };
    let loaded = selection.load(def)?;
    let quiet = |_: u64| {};
    let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    let case = tool.task(loaded.task).case(&loaded, &Watch::new(interrupt::flag(), None, &quiet)).map_err(stopped)?;
    let mut maps = Vec::new();
    for backend in &backends {
        let tile = tile(case.as_ref(), backend.as_ref())?;
        say!("{:<24} {}", backend.name(), tile.caption);
        maps.push(tile.map);
    }
    let png = side_by_side(&maps, args.zoom, 8).map_err(Failure::usage)?;
    replace(&args.out, &png).map_err(Failure::usage)?;
    say!("{}", args.out.display());
    Ok(exit::OK)
}

/// One backend's picture.
pub struct Tile {
    /// The pixels.
    pub map: PixelMap,
    /// How many of each sign, how many that differ from the exact one, and how many that are wrong.
    pub caption: String,
}

/// Draws one backend's answers to a square of queries.
pub fn tile(case: &dyn AnyCase, backend: &dyn Contestant) -> Result<Tile, Failure> {
    let loaded = case.loaded();
    let asked = loaded.content::<SignQueries>().zip(case.truth().downcast_ref::<Vec<Sign>>());
    let Some((content, truth)) = asked else {
        return Err(Failure::usage(format!("`{}` asks for no signs; only sign scenes can be drawn", loaded.name)));
    };
    let queries = &content.queries;
    let side = queries.len().isqrt();
    if side == 0 || side * side != queries.len() {
        return Err(Failure::usage(format!("`{}` has {} queries, which is no square", loaded.name, queries.len())));
    }
    let answers = classes(backend, &loaded.scene, content, truth)
        .map_err(|why| Failure::usage(format!("{}: {why}", backend.name())))?;
    let count = |sign: Sign| answers.iter().filter(|(answer, _)| *answer == sign).count();
    let differ = answers.iter().zip(truth).filter(|((answer, _), truth)| answer != *truth).count();
    // The first queries are those of the lowest row: y grows upwards, as in every plot.
    let answers: Vec<(Sign, Class)> = answers.chunks(side).rev().flatten().copied().collect();
    let wrong: Vec<bool> = answers.iter().map(|(_, class)| !class.is_legal()).collect();
    let caption = format!(
        "{:>8} -  {:>8} 0  {:>8} +  {:>8} differ from the exact sign, {} wrong",
        count(Sign::Negative),
        count(Sign::Zero),
        count(Sign::Positive),
        differ,
        wrong.iter().filter(|&&wrong| wrong).count()
    );
    let signs: Vec<i8> = answers.iter().map(|(sign, _)| sign.as_i8()).collect();
    Ok(Tile { map: PixelMap::new(side, side, &signs, &wrong).map_err(Failure::usage)?, caption })
}
