//! `map`: draws a square of queries as a picture, one tile per backend.

use std::path::{Path, PathBuf};

use predicament_corpus::LoadedScene;
use predicament_predicates::{Axis, Plane, Query};
use predicament_records::{RunDir, replace};
use predicament_report::{sheet, side_by_side};
use predicament_tasks::Watch;
use predicament_tasks::signs::truth;

use crate::exit::{self, Failure};
use crate::found::{find, load};
use crate::interrupt;
use crate::pixels::{Raster, Step, Tile, Walk, axes, columns, exact, square, tile};
use crate::progress;
use crate::select::Selector;
use crate::tool::Tool;

const EXAMPLES: &str = "\
A scene with a square number of queries is drawn as it is. With --query, or for a finding, one vertex of one query \
moves over a square of neighbouring doubles (--step) along two axes (--plane); the rest of the scene does not change.

A .png file has the backends side by side. An .svg file also has their names and counts, and starts with the exact \
signs. Under each map it shows where the map differs from them: pale where the backend's contract allows the \
difference, dark where it is wrong.

Examples:
  predicament draw map -f 'kettner-pixels-a$' --out map.png
  predicament draw map -f 'kettner-pixels-a$' -b naive,naive:first,exact,tolerance --zoom 2 --out map.png
  predicament draw map mine.toml -f neighbours --out map.png
  predicament draw map -f kettner-a1-global --query 'orient2d(xy; 0 1 2)' --out around.svg
  predicament draw map -f '/near-orient3d$' --query 'orient3d(0 1 2 3)' --plane yz --step 4ulp --out slice.svg
  predicament draw map --finding 3fa9 --run out/run --side 128 --out finding.svg";

/// Draw a square grid of queries, one pixel per query: red/yellow/blue for -/0/+, dark where the answer is wrong
///
/// The first queries are the lowest row. An answer is wrong if the backend's contract does not allow it. If a backend
/// promises to break ties, its broken ties keep their colour; if it has a tolerance band, so do its zeros within the
/// band.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    #[command(flatten)]
    pub selector: Selector,

    /// Backends, from left to right
    #[arg(
        short = 'b',
        long = "backend",
        value_name = "BACKEND",
        default_value = "naive,naive:first,epsilon:1e-10,exact"
    )]
    pub backends: Vec<String>,

    /// A query about vertices of the scene, one of which moves
    #[arg(long, value_name = "QUERY")]
    pub query: Option<Query>,

    /// The id of a finding about one query of a predicate, or a prefix of it
    #[arg(long, value_name = "ID", requires = "run", conflicts_with_all = ["suites", "filter", "query"])]
    pub finding: Option<String>,

    /// The run that found it
    #[arg(long, value_name = "DIR", requires = "finding")]
    pub run: Option<PathBuf>,

    /// The position in the query of the vertex that moves, from 0; default: the last
    #[arg(long = "move", value_name = "PLACE")]
    pub place: Option<usize>,

    /// The axes along which it moves; default: those of the predicate, or xy
    #[arg(long, value_name = "xy|yz|zx")]
    pub plane: Option<Plane>,

    /// The step from pixel to pixel: a number of doubles, such as 1ulp, or a length, such as 1e-9
    #[arg(long, default_value = "1ulp", value_name = "STEP", value_parser = step)]
    pub step: Step,

    /// The number of pixels in a row
    #[arg(long, default_value_t = 96, value_name = "N", value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(1..=2048))]
    pub side: usize,

    /// The number of screen pixels per query
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub zoom: usize,

    /// The PNG or SVG file to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: Args, tool: &Tool) -> exit::Outcome {
    let _working = progress::working("drawing the map");
    let is_svg = is_svg(&args.out)?;
    let backends = tool.pick(&args.backends)?;
    let (loaded, query) = what(&args, tool)?;
    let Raster { scene, content, side } = match &query {
        None => square(&loaded)?,
        Some(query) => walk(&args, &loaded, query)?.raster()?,
    };
    let quiet = |_: u64| {};
    let stopped = |_| Failure { message: "interrupted".to_owned(), code: exit::INCOMPLETE };
    let signs = truth(&scene, &content.queries, &Watch::new(interrupt::flag(), None, &quiet)).map_err(stopped)?;
    let mut tiles: Vec<(String, Tile)> = Vec::new();
    if is_svg {
        tiles.push(("exact signs".to_owned(), exact(&signs, side)?));
    }
    for backend in &backends {
        let tile = tile(&scene, &content, &signs, side, backend.as_ref())?;
        say!("{:<24} {}", backend.name(), tile.caption());
        tiles.push((backend.name(), tile));
    }
    let bytes = if is_svg {
        let what = query.map_or_else(String::new, |query| format!(" {query}"));
        let title = format!("{}/{}{what}", loaded.suite, loaded.name);
        let zoom = if args.zoom == 1 { (192 / side).max(1) } else { args.zoom };
        sheet(&title, &columns(tiles), zoom).map_err(Failure::usage)?.into_bytes()
    } else {
        let maps: Vec<_> = tiles.into_iter().map(|(_, tile)| tile.map).collect();
        side_by_side(&maps, args.zoom, 8).map_err(Failure::usage)?
    };
    replace(&args.out, &bytes).map_err(Failure::usage)?;
    say!("{}", args.out.display());
    Ok(exit::OK)
}

/// True if the file is an SVG sheet, false if it is a PNG picture, by its name.
fn is_svg(out: &Path) -> Result<bool, Failure> {
    match out.extension().and_then(|extension| extension.to_str()) {
        Some("svg") => Ok(true),
        Some("png") => Ok(false),
        _ => Err(Failure::usage(format!("--out {}: name a file that ends in .png or .svg", out.display()))),
    }
}

/// The scene, and the query whose vertex moves.
fn what(args: &Args, tool: &Tool) -> Result<(LoadedScene, Option<Query>), Failure> {
    if let (Some(id), Some(folder)) = (&args.finding, &args.run) {
        let run = RunDir::open(folder).map_err(Failure::usage)?;
        let finding = find(&run, id, folder)?;
        let loaded = load(&run, finding, None, tool)?;
        let query = finding.query.split(" | ").next().unwrap_or_default();
        let query = query.parse().map_err(|_| {
            Failure::usage(format!(
                "finding {} is about a whole scene; `show --finding` draws those",
                finding.finding_id
            ))
        })?;
        return Ok((loaded, Some(query)));
    }
    let selection = args.selector.clone().with_names(tool)?.select(tool)?;
    match selection.defs().as_slice() {
        [def] => Ok((selection.load(def)?, args.query.clone())),
        [] => Err(selection.nothing()),
        [first, second, ..] => {
            let message = format!("{}/{} and {}/{} are selected", first.suite, first.name, second.suite, second.name);
            Err(Failure::usage(format!("{message}; choose one scene with -f")))
        }
    }
}

fn walk<'a>(args: &Args, loaded: &'a LoadedScene, query: &'a Query) -> Result<Walk<'a>, Failure> {
    let Some((question, vertices)) = query.question() else {
        return Err(Failure::usage(format!(
            "`{query}` does not ask for a sign; name a query such as 'orient2d(xy; 0 1 2)'"
        )));
    };
    let axes: [Axis; 2] = args.plane.map_or_else(|| axes(question, &loaded.scene), Plane::axes);
    let place = args.place.unwrap_or(vertices.len() - 1);
    Ok(Walk { scene: &loaded.scene, query, place, axes, step: args.step, side: args.side })
}

fn step(text: &str) -> Result<Step, String> {
    let bad = || "write a number of doubles, such as 1ulp, or a length, such as 1e-9".to_owned();
    if let Some(ulps) = text.strip_suffix("ulp") {
        return ulps.trim().parse().ok().filter(|&ulps| ulps > 0).map(Step::Ulps).ok_or_else(bad);
    }
    let length = text.parse::<f64>().ok().filter(|length| *length > 0.0 && length.is_finite());
    length.map(Step::Length).ok_or_else(bad)
}
