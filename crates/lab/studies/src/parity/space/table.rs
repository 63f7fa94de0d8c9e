//! Tables of broken pairs by recipe and backend, as CSV and Markdown.

use std::fmt::Write as _;

use predicament_records::wilson;
use serde::Serialize;

use super::super::searched::{Parity, Searched, SpaceSearched, all};
use super::super::table::thousands;
use super::{Broken, Census, Kind, Recipe, Row};
use crate::{Error, File, Precision};

#[derive(Serialize)]
struct Line<'a> {
    pairs_for: &'a str,
    recipe: &'a str,
    backend: &'a str,
    pairs: usize,
    refused: usize,
    declined: usize,
    level_0: usize,
    level_1: usize,
    level_2: usize,
    level_3: usize,
    loose: usize,
    loose_low: f64,
    loose_high: f64,
    no_way: usize,
    no_direction: usize,
    odd: usize,
    odd_low: f64,
    odd_high: f64,
    broken: usize,
    broken_with_piercings_alone: usize,
    ends: usize,
    pieces: usize,
    boundaries: usize,
    boundaries_degenerate: usize,
}

fn interval(count: usize, row: &Row) -> [f64; 2] {
    wilson(count as u64, (row.pairs - row.declined) as u64)
}

fn line<'a>(precision: Precision, recipe: Recipe, backend: &'a str, row: &Row) -> Line<'a> {
    let [level_0, level_1, level_2, level_3] = row.registered;
    let [no_way, no_direction, odd] = row.broken;
    let [loose_low, loose_high] = interval(row.loose, row);
    let [odd_low, odd_high] = interval(odd, row);
    Line {
        pairs_for: precision.name(),
        recipe: recipe.name(),
        backend,
        pairs: row.pairs,
        refused: row.refused,
        declined: row.declined,
        level_0,
        level_1,
        level_2,
        level_3,
        loose: row.loose,
        loose_low,
        loose_high,
        no_way,
        no_direction,
        odd,
        odd_low,
        odd_high,
        broken: row.some,
        broken_with_piercings_alone: row.piercings_alone,
        ends: row.ends,
        pieces: row.pieces,
        boundaries: row.boundaries,
        boundaries_degenerate: row.degenerate,
    }
}

fn rows(census: &Census) -> impl Iterator<Item = (Recipe, &str, &Row)> {
    census.rows.iter().map(|((recipe, place), row)| (*recipe, census.backends[*place].as_str(), row))
}

/// The CSV table, with one row for each precision, recipe and backend.
pub(in super::super) fn csv(searched: &[SpaceSearched]) -> Result<File, Error> {
    let lines = searched.iter().flat_map(|Searched { precision, census, .. }| {
        rows(census).map(|(recipe, backend, row)| line(*precision, recipe, backend, row))
    });
    File::csv("parity-space.csv", lines)
}

/// A count and its interval in percent.
fn share(count: usize, row: &Row) -> String {
    let [low, high] = interval(count, row).map(|x| 100.0 * x);
    format!("{} ({low:.3} to {high:.3} %)", thousands(count))
}

/// The page of the study, as Markdown.
pub(in super::super) fn page(parity: &Parity, searched: &[SpaceSearched]) -> String {
    let mut page = String::new();
    let mut say = |line: String| writeln!(page, "{line}").expect("memory");
    for Searched { precision, census, .. } in searched {
        let (seed, name) = (parity.common.seed, precision.name());
        say(format!(
            "Pairs for tolerances in {name}, seed {seed}; in brackets the interval of the share (Wilson, 95 %):\n"
        ));
        say("| recipe | backend | pairs | declined | level 0 | level 1 | level 2 | level 3 | loose ends | \
             no continuation | no direction | odd boundaries | broken with piercings alone |"
            .into());
        say("|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|".into());
        for (recipe, backend, row) in rows(census) {
            let counts = [&[row.pairs, row.declined][..], &row.registered].concat();
            let counts: Vec<String> = counts.into_iter().map(thousands).collect();
            let [no_way, no_direction, odd] = row.broken;
            let (loose, odd) = (share(row.loose, row), share(odd, row));
            say(format!(
                "| {} | {backend} | {} | {loose} | {} | {} | {odd} | {} |",
                recipe.name(),
                counts.join(" | "),
                thousands(no_way),
                thousands(no_direction),
                thousands(row.piercings_alone)
            ));
        }
        say(String::new());
    }
    say("| smallest | triangles | A | B | shows | levels registered |".into());
    say("|---|---:|---|---|---|---|".into());
    for (at, (precision, kind, small)) in all(searched).enumerate() {
        let [a, b] = small.pair.surfaces.each_ref().map(|surface| points(&surface.points));
        let count: usize = small.pair.surfaces.iter().map(|surface| surface.triangles.len()).sum();
        let bound = if small.minimal { "" } else { " (not minimal)" };
        let (ways, levels) = (ways(kind), levels(kind));
        say(format!("| {}{bound} | {count} | {a} | {b} | {ways} | {levels} |", scene_name(precision, at + 1)));
    }
    page
}

/// The name of a scene in page and suite.
pub(in super::super) fn scene_name(precision: Precision, number: usize) -> String {
    format!("broken-{}-{number}", precision.name())
}

fn points(points: &[[f64; 3]]) -> String {
    let points: Vec<String> = points.iter().map(|[x, y, z]| format!("({x}, {y}, {z})")).collect();
    points.join(", ")
}

/// The names of the ways in which a pair is broken.
pub(in super::super) fn ways(kind: &Kind) -> String {
    let names: Vec<&str> = kind.ways.iter().map(|way| Broken::name(*way)).collect();
    names.join(", ")
}

fn levels(kind: &Kind) -> String {
    let levels: Vec<String> = (0..4).filter(|&level| kind.registered[level]).map(|level| level.to_string()).collect();
    levels.join(", ")
}
