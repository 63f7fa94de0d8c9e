//! Tables of odd pairs by backend, as CSV and Markdown.

use std::fmt::Write as _;

use serde::Serialize;

use super::searched::{PlaneSearched, all};
use super::{Census, Kind, Parity, Row, Searched};
use crate::{Error, File, Precision};

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
        pairs_for: precision.name(),
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

/// The CSV table, with one row for each precision and backend.
pub(super) fn csv(searched: &[PlaneSearched]) -> Result<File, Error> {
    let rows = searched
        .iter()
        .flat_map(|Searched { precision, census, .. }| census.rows.iter().map(|row| line(*precision, census, row)));
    File::csv("parity.csv", rows)
}

/// A count with commas between thousands.
pub(super) fn thousands(count: usize) -> String {
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

/// The page of the study, as Markdown.
pub(super) fn page(parity: &Parity, searched: &[PlaneSearched]) -> String {
    let mut page = String::new();
    let mut say = |line: String| writeln!(page, "{line}").expect("memory");
    for Searched { precision, census, .. } in searched {
        say(format!(
            "{} pairs for tolerances in {}, seed {}, {} draws refused:\n",
            thousands(census.pairs),
            precision.name(),
            parity.common.seed,
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

/// The name of a scene in page and suite.
pub(super) fn scene_name(precision: Precision, number: usize) -> String {
    format!("odd-{}-{number}", precision.name())
}

fn corners(polygon: &[[f64; 2]]) -> String {
    let corners: Vec<String> = polygon.iter().map(|[x, y]| format!("({x}, {y})")).collect();
    corners.join(", ")
}

/// The names of the rules under which a pair is odd.
pub(super) fn seats(kind: &Kind) -> String {
    let names: Vec<&str> = kind.seats().map(|seat| seat.name()).collect();
    names.join(", ")
}

fn registered(kind: &Kind) -> String {
    let names = ["vertices with vertices", "edges with vertices", "edges with edges"];
    let names: Vec<&str> =
        names.into_iter().zip(kind.registered).filter(|&(_, has)| has).map(|(name, _)| name).collect();
    names.join(", ")
}
