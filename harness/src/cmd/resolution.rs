//! `resolution`: the smallest feature that a backend's contacts can tell, and
//! how far off they place a shallow crossing.

use std::path::{Path, PathBuf};

use predicament_oracle::Contestant;
use predicament_oracle::resolution::{FEATURES, Feature, Location, Survey, length, location, precision, survey};
use predicament_predicates::Dimension;
use predicament_report::{Bar, Curve, Curves, curves, ranges};
use serde::Serialize;

use crate::exit::{self, Failure};
use crate::{interrupt, progress, roster};

const EXAMPLES: &str = "\
Each feature (a gap, a tooth through an edge, a cell around a vertex ...) is made in sizes from
1e-9 to 0.4, in units of L, and put in random positions. It survives where it is registered as
what it is, and nothing more degenerate beside it.

Written to the folder: resolution.csv (share that survives, by size), location.csv (distance along
the edge between a crossing and where it is registered, by angle), resolution.svg, location.svg.

Examples:
  predicament resolution --out target/resolution
  predicament resolution -b tolerance,exact --trials 1000 --out target/resolution";

/// Measure what tolerances cost: the smallest feature that survives, in units of L
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Backends
    #[arg(short = 'b', long = "backend", value_name = "BACKEND", default_value = "tolerance,tolerance:f32,exact")]
    pub backends: Vec<String>,

    /// Positions to a size, and pairs of edges to an angle
    #[arg(long, default_value_t = 200, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub trials: u32,

    /// The seed of the positions
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    let backends = roster::pick(&args.backends)?;
    let failed = |error: std::io::Error| Failure::usage(format!("{}: {error}", args.out.display()));
    std::fs::create_dir_all(&args.out).map_err(failed)?;
    let bar = progress::bar((backends.len() * (FEATURES.len() + 1)) as u64, "features");
    let mut surveys = Vec::new();
    for feature in FEATURES {
        for backend in &backends {
            if interrupt::flag().load(std::sync::atomic::Ordering::Relaxed) {
                return Err(Failure { message: "interrupted; nothing was written".into(), code: exit::INCOMPLETE });
            }
            surveys.push((feature, backend.name(), ask(feature, backend.as_ref(), args)?));
            bar.inc(1);
        }
    }
    let mut locations = Vec::new();
    for backend in &backends {
        locations.push((backend.name(), locate(backend.as_ref(), args)?));
        bar.inc(1);
    }
    bar.finish_and_clear();
    let write = |name: &str, text: String| std::fs::write(args.out.join(name), text).map_err(failed);
    write_csv(&args.out.join("resolution.csv"), shares(&surveys))?;
    write_csv(&args.out.join("location.csv"), errors(&locations))?;
    let bars: Vec<Bar> = surveys.iter().map(bar_of).collect();
    write(
        "resolution.svg",
        ranges(&bars, "size over L: from where none survives to where all do", [-9, 0]).map_err(Failure::usage)?,
    )?;
    if let Some(svg) = curves(&lines(&locations)).map_err(Failure::usage)? {
        write("location.svg", svg)?;
    }
    print(&surveys, &locations);
    println!("{}", args.out.display());
    Ok(exit::OK)
}

type Surveyed = (&'static Feature, String, Survey);
type Located = (String, Vec<Location>);

fn ask(feature: &Feature, backend: &dyn Contestant, args: &Args) -> Result<Survey, Failure> {
    let name = backend.name();
    let contacts = |scene: &_, a: &_, b: &_| backend.contacts(scene, [a, b]);
    survey(feature, &contacts, length(&name, feature.dimension), precision(&name), args.trials, args.seed)
        .map_err(|why| Failure::usage(format!("{name} on `{}`: {why}", feature.name)))
}

fn locate(backend: &dyn Contestant, args: &Args) -> Result<Vec<Location>, Failure> {
    let name = backend.name();
    let contacts = |scene: &_, a: &_, b: &_| backend.contacts(scene, [a, b]);
    location(&contacts, length(&name, Dimension::Two), precision(&name), args.trials, args.seed)
        .map_err(|why| Failure::usage(format!("{name} on shallow crossings: {why}")))
}

#[derive(Serialize)]
struct Share<'a> {
    feature: &'a str,
    dimension: usize,
    tolerance: &'a str,
    backend: &'a str,
    size_over_l: f64,
    survived: f64,
}

fn shares(surveys: &[Surveyed]) -> impl Iterator<Item = Share<'_>> {
    surveys.iter().flat_map(|(feature, backend, survey)| {
        survey.shares.iter().map(move |&(size_over_l, survived)| {
            let Feature { name, tolerance, dimension, .. } = feature;
            Share { feature: name, dimension: dimension.count(), tolerance, backend, size_over_l, survived }
        })
    })
}

#[derive(Serialize)]
struct Error<'a> {
    backend: &'a str,
    angle: f64,
    crossed: u32,
    registered: u32,
    crossings: u32,
    worst_over_l: f64,
    mean_over_l: f64,
}

fn errors(locations: &[Located]) -> impl Iterator<Item = Error<'_>> {
    locations.iter().flat_map(|(backend, locations)| {
        locations.iter().map(move |&Location { angle, crossed, registered, crossings, worst, mean }| Error {
            backend,
            angle,
            crossed,
            registered,
            crossings,
            worst_over_l: worst,
            mean_over_l: mean,
        })
    })
}

fn write_csv(path: &Path, rows: impl Iterator<Item = impl Serialize>) -> Result<(), Failure> {
    let failed = |error: csv::Error| Failure::usage(format!("{}: {error}", path.display()));
    let mut csv = csv::Writer::from_path(path).map_err(failed)?;
    for row in rows {
        csv.serialize(row).map_err(failed)?;
    }
    csv.flush().map_err(|error| Failure::usage(format!("{}: {error}", path.display())))
}

fn bar_of((feature, backend, survey): &Surveyed) -> Bar {
    let name = format!("{}D {} ({})", feature.dimension.count(), feature.name, feature.tolerance);
    Bar { name, backend: backend.clone(), from: survey.lost(), to: survey.safe() }
}

fn lines(locations: &[Located]) -> Curves {
    let curve = |(backend, locations): &Located| Curve {
        name: backend.clone(),
        points: locations.iter().filter(|at| at.registered > 0).map(|at| (at.angle, at.worst)).collect(),
    };
    Curves {
        x: "angle between the edges, radians".into(),
        y: "worst distance along the edge, over L".into(),
        curves: locations.iter().map(curve).collect(),
    }
}

/// The tables, as Markdown.
fn print(surveys: &[Surveyed], locations: &[Located]) {
    println!("| | feature | size | tolerance | backend | none up to | all from |");
    println!("|---|---|---|---|---|---|---|");
    let size = |size: Option<f64>| size.map_or_else(|| "-".to_owned(), |size| format!("{size:.2e}"));
    for (feature, backend, survey) in surveys {
        let Feature { name, size: what, tolerance, dimension, .. } = feature;
        let (lost, safe) = (size(survey.lost()), size(survey.safe()));
        println!("| {}D | {name} | {what} | {tolerance} | {backend} | {lost} | {safe} |", dimension.count());
    }
    println!("\n| backend | worst error over L | at the angle | 19 of 20 registered as crossings from |");
    println!("|---|---|---|---|");
    for (backend, locations) in locations {
        let Some(worst) = locations.iter().max_by(|a, b| a.worst.total_cmp(&b.worst)) else { continue };
        let most = |at: &&Location| u64::from(at.crossings) * 20 >= u64::from(at.crossed) * 19;
        let steep = locations.iter().rev().take_while(most).last().map(|at| at.angle);
        println!("| {backend} | {:.3} | {:.2e} | {} |", worst.worst, worst.angle, size(steep));
    }
}
