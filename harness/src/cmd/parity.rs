//! `parity`: random nearly degenerate polygons, how often two of them cross an
//! odd number of times by what a backend registers, and the smallest that do.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::atomic::Ordering;

use predicament_corpus::{exact_coordinate, hexfloat};
use predicament_oracle::parity::{Census, Found, Kind, PolygonPair, Recipe, Row, Small, search, smallest};
use predicament_oracle::resolution::Precision;
use serde::Serialize;

use crate::cmd::run::set_threads;
use crate::exit::{self, Failure};
use crate::{interrupt, progress};

const EXAMPLES: &str = "\
Two closed curves cross an even number of times. Pairs of random simple polygons, with a few corners
far away and a few within some multiples of sigma of each other, are registered by exact, perturbed
and tolerant predicates, merged where they are in contact, and their crossings counted, for each rule
about where merged points sit. There are three recipes, and pairs for the tolerances of either precision.

Written to the folder: parity.csv and parity.md (the counts), smallest.toml (the smallest pairs found
with an odd number of crossings, as a suite that `predicament run` reads; empty of scenes without --shrink).

Examples:
  predicament parity --out target/parity
  predicament parity --pairs 2000 --shrink 50 --out target/parity
  predicament run target/parity/smallest.toml -b exact,sos,tolerance,tolerance:f32";

/// Count odd crossings of random polygons after merging, and shrink those found
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Args {
    /// Pairs of each recipe, in each precision
    #[arg(long, default_value_t = 40_000, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub pairs: u64,

    /// The seed of the pairs
    #[arg(long, default_value_t = 1, value_name = "N")]
    pub seed: u64,

    /// Finds to shrink in each precision, evenly spread over all
    #[arg(long, default_value_t = 200, value_name = "N")]
    pub shrink: usize,

    /// Threads; all if left out
    #[arg(long, value_name = "N")]
    pub threads: Option<usize>,

    /// The folder to write; made if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
}

const PRECISIONS: [Precision; 2] = [Precision::Double, Precision::Single];
/// So many pairs of each recipe between two looks at the clock and at Ctrl-C.
const PART: u64 = 500;
/// So many finds.
const FINDS: usize = 16;

/// What was found in one precision.
struct Searched {
    precision: Precision,
    census: Census,
    smallest: BTreeMap<Kind, Small>,
}

/// Runs the command.
pub fn run(args: &Args) -> exit::Outcome {
    set_threads(args.threads)?;
    let failed = |error: std::io::Error| Failure::usage(format!("{}: {error}", args.out.display()));
    std::fs::create_dir_all(&args.out).map_err(failed)?;
    interrupt::listen();
    let mut searched = Vec::new();
    for precision in PRECISIONS {
        let census = count(precision, args)?;
        let smallest = shrink(precision, &census, args)?;
        searched.push(Searched { precision, census, smallest });
    }
    let page = page(&searched, args);
    let write = |name: &str, text: &str| std::fs::write(args.out.join(name), text).map_err(failed);
    write("parity.csv", &table(&searched)?)?;
    write("parity.md", &page)?;
    write("smallest.toml", &suite(&searched, args.seed)?)?;
    print!("{page}");
    println!("\n{}", args.out.display());
    Ok(exit::OK)
}

fn interrupted() -> Result<(), Failure> {
    if interrupt::flag().load(Ordering::Relaxed) {
        return Err(Failure { message: "interrupted; nothing was written".into(), code: exit::INCOMPLETE });
    }
    Ok(())
}

fn count(precision: Precision, args: &Args) -> Result<Census, Failure> {
    let bar = progress::bar(args.pairs * Recipe::ALL.len() as u64, "pairs");
    let mut census = Census::default();
    let mut from = 0;
    while from < args.pairs {
        interrupted()?;
        let to = (from + PART).min(args.pairs);
        census = census.and(search(precision, args.seed, from..to));
        bar.inc((to - from) * Recipe::ALL.len() as u64);
        from = to;
    }
    bar.finish_and_clear();
    Ok(census)
}

fn shrink(precision: Precision, census: &Census, args: &Args) -> Result<BTreeMap<Kind, Small>, Failure> {
    // exact and perturbed finds are a fault of ours, and are counted; here are those of tolerances
    let finds: Vec<&Found> = census.found.iter().filter(|found| found.backend.starts_with("tolerance")).collect();
    let step = finds.len().div_ceil(args.shrink.max(1)).max(1);
    let chosen: Vec<&Found> = finds.into_iter().step_by(step).take(args.shrink).collect();
    let bar = progress::bar(chosen.len() as u64, "finds");
    let mut kept = BTreeMap::new();
    for some in chosen.chunks(FINDS) {
        interrupted()?;
        for (kind, small) in smallest(precision, args.seed, some) {
            small.keep(&mut kept, kind);
        }
        bar.inc(some.len() as u64);
    }
    bar.finish_and_clear();
    Ok(kept)
}

#[derive(Serialize)]
struct Line<'a> {
    pairs_for: &'a str,
    backend: &'a str,
    pairs: usize,
    refused: usize,
    declined: usize,
    vertex_vertex: usize,
    edge_vertex: usize,
    edge_edge: usize,
    odd_a: usize,
    odd_b: usize,
    odd_middle: usize,
    odd_some: usize,
    odd_all: usize,
    odd_crossings_alone: usize,
    odd_with_vertices: usize,
    odd_with_edges_at_vertices: usize,
    odd_with_both: usize,
    unfaithful_a: usize,
    unfaithful_b: usize,
    unfaithful_middle: usize,
    clustered: usize,
    clusters: usize,
    largest_cluster: usize,
    intransitive: usize,
    collapsed: usize,
    collapses: usize,
}

fn line<'a>(precision: Precision, census: &Census, row: &'a Row) -> Line<'a> {
    let [vertex_vertex, edge_vertex, edge_edge] = row.registered;
    let [odd_a, odd_b, odd_middle] = row.seats.map(|seat| seat.odd);
    let [unfaithful_a, unfaithful_b, unfaithful_middle] = row.seats.map(|seat| seat.unfaithful);
    let [odd_crossings_alone, odd_with_vertices, odd_with_edges_at_vertices, odd_with_both] = row.odd_with;
    Line {
        pairs_for: name(precision),
        backend: &row.backend,
        pairs: census.pairs,
        refused: census.refused,
        declined: row.declined,
        vertex_vertex,
        edge_vertex,
        edge_edge,
        odd_a,
        odd_b,
        odd_middle,
        odd_some: row.odd_some,
        odd_all: row.odd_all,
        odd_crossings_alone,
        odd_with_vertices,
        odd_with_edges_at_vertices,
        odd_with_both,
        unfaithful_a,
        unfaithful_b,
        unfaithful_middle,
        clustered: row.clustered,
        clusters: row.clusters,
        largest_cluster: row.largest_cluster,
        intransitive: row.intransitive,
        collapsed: row.collapsed,
        collapses: row.collapses,
    }
}

fn table(searched: &[Searched]) -> Result<String, Failure> {
    let mut csv = csv::Writer::from_writer(Vec::new());
    for Searched { precision, census, .. } in searched {
        for row in &census.rows {
            csv.serialize(line(*precision, census, row)).map_err(Failure::usage)?;
        }
    }
    let bytes = csv.into_inner().map_err(Failure::usage)?;
    String::from_utf8(bytes).map_err(Failure::usage)
}

const fn name(precision: Precision) -> &'static str {
    match precision {
        Precision::Double => "f64",
        Precision::Single => "f32",
    }
}

/// A count with commas between thousands.
fn thousands(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The counts, as Markdown.
fn page(searched: &[Searched], args: &Args) -> String {
    let mut page = String::new();
    let mut say = |line: String| writeln!(page, "{line}").expect("memory");
    for Searched { precision, census, .. } in searched {
        say(format!(
            "{} pairs for tolerances in {}, seed {}, {} draws refused:\n",
            thousands(census.pairs),
            name(*precision),
            args.seed,
            thousands(census.refused)
        ));
        say("| backend | declined | vertex-vertex | edge-vertex | edge-edge | odd, seat A | odd, seat B | odd, middle | \
             odd under some | under all |"
            .into());
        say("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|".into());
        for row in &census.rows {
            let seats = row.seats.map(|seat| seat.odd);
            let counts = [&[row.declined][..], &row.registered, &seats, &[row.odd_some, row.odd_all]].concat();
            let counts: Vec<String> = counts.into_iter().map(thousands).collect();
            say(format!("| {} | {} |", row.backend, counts.join(" | ")));
        }
        say(String::new());
        say("| backend | odd with crossings alone | vertices with vertices | edges with vertices | both | pairs with a \
             cluster | clusters | largest | not transitive | pairs with a collapsed edge | collapsed edges |"
            .into());
        say("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|".into());
        for row in &census.rows {
            let clusters = [row.clustered, row.clusters, row.largest_cluster, row.intransitive];
            let counts = [&row.odd_with[..], &clusters, &[row.collapsed, row.collapses]].concat();
            let counts: Vec<String> = counts.into_iter().map(thousands).collect();
            say(format!("| {} | {} |", row.backend, counts.join(" | ")));
        }
        say(String::new());
    }
    say("| smallest | corners | A | B | odd under | registered |".into());
    say("|---|---:|---|---|---|---|".into());
    for (at, (precision, kind, small)) in all(searched).enumerate() {
        let [a, b] = small.pair.polygons.each_ref().map(|polygon| corners(polygon));
        let count: usize = small.pair.polygons.iter().map(Vec::len).sum();
        let bound = if small.minimal { "" } else { " (not minimal)" };
        let (odd, with) = (seats(kind), registered(kind));
        say(format!("| {}{bound} | {count} | {a} | {b} | {odd} | {with} |", scene_name(precision, at + 1)));
    }
    page
}

fn all(searched: &[Searched]) -> impl Iterator<Item = (Precision, &Kind, &Small)> {
    searched.iter().flat_map(|one| one.smallest.iter().map(|(kind, small)| (one.precision, kind, small)))
}

fn scene_name(precision: Precision, number: usize) -> String {
    format!("odd-{}-{number}", name(precision))
}

fn corners(polygon: &[[f64; 2]]) -> String {
    let corners: Vec<String> = polygon.iter().map(|[x, y]| format!("({x}, {y})")).collect();
    corners.join(", ")
}

fn seats(kind: &Kind) -> String {
    let names: Vec<&str> = kind.seats().map(|seat| seat.name()).collect();
    names.join(", ")
}

fn registered(kind: &Kind) -> String {
    let names = ["vertices with vertices", "edges with vertices", "edges with edges"];
    let names: Vec<&str> =
        names.into_iter().zip(kind.registered).filter(|&(_, has)| has).map(|(name, _)| name).collect();
    names.join(", ")
}

#[derive(Serialize)]
struct Suite {
    title: String,
    description: String,
    scene: Vec<Scene>,
}

#[derive(Serialize)]
struct Scene {
    name: String,
    task: &'static str,
    points: Vec<[toml::Value; 2]>,
    a: Closed,
    b: Closed,
    tags: Vec<&'static str>,
    source: String,
    analysis: String,
}

#[derive(Serialize)]
struct Closed {
    closed: Vec<Vec<usize>>,
}

/// The smallest pairs, as a suite.
fn suite(searched: &[Searched], seed: u64) -> Result<String, Failure> {
    let scene = |(at, (precision, kind, small)): (usize, (Precision, &Kind, &Small))| {
        let PolygonPair { polygons: [a, b] } = &small.pair;
        let closed = |from: usize, count: usize| Closed { closed: vec![(from..from + count).collect()] };
        let minimal = if small.minimal { "minimal" } else { "the limit came before it was minimal" };
        Scene {
            name: scene_name(precision, at + 1),
            task: "contacts2d",
            points: a.iter().chain(b).map(|point| point.map(coordinate)).collect(),
            a: closed(0, a.len()),
            b: closed(a.len(), b.len()),
            tags: vec!["near-degenerate", "odd-crossings", name(precision)],
            source: format!(
                "predicament parity --seed {seed}: recipe {}, number {}, shrunk ({minimal})",
                small.recipe.name(),
                small.number
            ),
            analysis: format!(
                "Tolerances in {} make these closed curves cross an odd number of times where merged points sit at {}.",
                name(precision),
                seats(kind)
            ),
        }
    };
    let suite = Suite {
        title: "Odd crossings".into(),
        description: "The smallest pairs of simple polygons found that cross an odd number of times once merged."
            .into(),
        scene: all(searched).enumerate().map(scene).collect(),
    };
    toml::to_string(&suite).map_err(Failure::usage)
}

/// A coordinate as it is read back without loss: a decimal if it is one, else a hex float.
fn coordinate(x: f64) -> toml::Value {
    // adding zero takes the sign of a negative one
    let text = (x + 0.0).to_string();
    match text.parse::<i64>() {
        Ok(whole) => toml::Value::Integer(whole),
        Err(_) if exact_coordinate(&text) == Ok(x) => toml::Value::String(text),
        Err(_) => toml::Value::String(hexfloat::format(x)),
    }
}
