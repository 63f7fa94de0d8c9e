//! `map`: a square of queries as a picture, one tile per backend.

use std::path::PathBuf;

use predicament_oracle::{Case, Contestant, Truth, Watch};
use predicament_predicates::Sign;
use predicament_report::{PixelMap, side_by_side};

use crate::exit::{self, Failure};
use crate::select::Selector;
use crate::{interrupt, roster};

const EXAMPLES: &str = "\
Examples:
  predicament map kettner-map-1 --out map.png
  predicament map kettner-map-1 -b naive,naive:first,exact,tolerance --zoom 2 --out map.png";

/// Draw a square grid of queries: one pixel a query, blue/yellow/red for -/0/+, wrong ones dark
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// The scene's name; its number of queries has to be a square
    pub scene: String,

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
pub fn run(args: Args) -> exit::Outcome {
    let backends = roster::pick(&args.backends)?;
    let everything =
        Selector { suites: Vec::new(), filter: None, level: predicament_corpus::Level::Quick, cache: None };
    let selection = everything.select()?;
    let Some(def) = selection.defs().into_iter().find(|def| def.name == args.scene) else {
        return Err(Failure::nothing(format!(
            "no scene is called `{}`; `predicament corpus list --scenes` names them",
            args.scene
        )));
    };
    let loaded = selection.load(def)?;
    let quiet = |_: u64| {};
    let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    let case = Case::new(&loaded, &Watch::new(interrupt::flag(), None, &quiet)).map_err(stopped)?;
    let mut maps = Vec::new();
    for backend in &backends {
        let tile = tile(&case, backend.as_ref())?;
        println!("{:<24} {}", backend.name(), tile.caption);
        maps.push(tile.map);
    }
    let png = side_by_side(&maps, args.zoom, 8).map_err(Failure::usage)?;
    std::fs::write(&args.out, png).map_err(|error| Failure::usage(format!("{}: {error}", args.out.display())))?;
    println!("{}", args.out.display());
    Ok(exit::OK)
}

/// One backend's picture.
pub struct Tile {
    /// The pixels.
    pub map: PixelMap,
    /// How many of each sign, and how many wrong.
    pub caption: String,
}

/// Draws one backend's answers to a square of queries.
pub fn tile(case: &Case, backend: &dyn Contestant) -> Result<Tile, Failure> {
    let loaded = case.loaded();
    let Truth::Signs { queries, signs: truth } = case.truth() else {
        return Err(Failure::usage(format!("`{}` asks for no signs; only sign scenes can be drawn", loaded.name)));
    };
    let side = queries.len().isqrt();
    if side == 0 || side * side != queries.len() {
        return Err(Failure::usage(format!("`{}` has {} queries, which is no square", loaded.name, queries.len())));
    }
    let answers =
        backend.answers(&loaded.scene, queries).map_err(|why| Failure::usage(format!("{}: {why}", backend.name())))?;
    let wrong: Vec<bool> = answers.iter().zip(truth).map(|(got, truth)| got != truth).collect();
    let count = |sign: Sign| answers.iter().filter(|&&answer| answer == sign).count();
    let caption = format!(
        "{:>8} -  {:>8} 0  {:>8} +  {:>8} differ from the exact sign",
        count(Sign::Negative),
        count(Sign::Zero),
        count(Sign::Positive),
        wrong.iter().filter(|&&wrong| wrong).count()
    );
    let signs: Vec<i8> = answers.iter().map(|sign| sign.as_i8()).collect();
    Ok(Tile { map: PixelMap::new(side, side, &signs, &wrong).map_err(Failure::usage)?, caption })
}
