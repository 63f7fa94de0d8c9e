//! Cuts as CSV and Markdown.

use std::fmt::Write as _;

use serde::Serialize;

use super::measured::{Cut, Made, Measured, Row};
use super::pieces::SLIVER;
use crate::{Error, File};

#[derive(Serialize)]
struct Line<'a> {
    shape: &'a str,
    placement: &'a str,
    backend: &'a str,
    declined: Option<String>,
    tetrahedra: usize,
    triangles: usize,
    vertex_vertex: usize,
    vertex_edge: usize,
    vertex_triangle: usize,
    edge_edge: usize,
    triangle_edge: usize,
    tetrahedron_vertex: usize,
    tetrahedron_vertex_asked: u64,
    located: usize,
    unknown: usize,
    contradicted_edges: usize,
    degenerate_edges: usize,
    cut: usize,
    inconsistent: usize,
    undecided: usize,
    volume: f64,
    sum: f64,
    lost: f64,
    inside: f64,
    inside_true: f64,
    near: usize,
    checked: usize,
    off: usize,
    furthest_off: f64,
    slivers: usize,
    empty: usize,
    many_points: usize,
    missing_points: usize,
    parts_inside: usize,
    parts_outside: usize,
}

#[derive(Serialize)]
struct Time<'a> {
    shape: &'a str,
    placement: &'a str,
    backend: &'a str,
    contacts_seconds: f64,
    cutting_seconds: f64,
}

fn line(row: &Row) -> Line<'_> {
    let made = row.made.as_ref().ok();
    let of = |ranks| made.map_or(0, |made| made.registered(ranks));
    let count = |get: fn(&Made) -> usize| made.map_or(0, get);
    let volume = |get: fn(&Made) -> f64| made.map_or(0.0, get);
    Line {
        shape: row.shape.name(),
        placement: row.placement.name(),
        backend: &row.backend,
        declined: row.made.as_ref().err().map(ToString::to_string),
        tetrahedra: row.tetrahedra,
        triangles: row.triangles,
        vertex_vertex: of([0, 0]),
        vertex_edge: of([0, 1]),
        vertex_triangle: of([0, 2]),
        edge_edge: of([1, 1]),
        triangle_edge: of([1, 2]),
        tetrahedron_vertex: of([0, 3]),
        tetrahedron_vertex_asked: made.map_or(0, Made::asked_in_tetrahedra),
        located: count(|made| made.sides.located),
        unknown: count(|made| made.sides.unknown),
        contradicted_edges: count(|made| made.sides.contradicted.len()),
        degenerate_edges: count(|made| made.sides.degenerate.iter().filter(|&&is| is).count()),
        cut: count(|made| made.pieces.cut),
        inconsistent: count(|made| made.pieces.inconsistent),
        undecided: count(|made| made.pieces.undecided),
        volume: row.whole,
        sum: volume(|made| made.pieces.sum),
        lost: volume(|made| made.pieces.lost),
        inside: volume(|made| made.pieces.inside),
        inside_true: row.truth,
        near: row.near,
        checked: count(|made| made.deviation.checked),
        off: count(|made| made.deviation.off),
        furthest_off: volume(|made| made.deviation.furthest),
        slivers: count(|made| made.pieces.slivers),
        empty: count(|made| made.pieces.empty),
        many_points: count(|made| made.pieces.many),
        missing_points: count(|made| made.pieces.missing),
        parts_inside: count(|made| made.pieces.parts[0]),
        parts_outside: count(|made| made.pieces.parts[1]),
    }
}

/// The results that are the same in every run, and the times.
pub(super) fn csv(measured: &Measured) -> Result<Vec<File>, Error> {
    let times = measured.rows.iter().filter_map(|row| {
        let made = row.made.as_ref().ok()?;
        Some(Time {
            shape: row.shape.name(),
            placement: row.placement.name(),
            backend: &row.backend,
            contacts_seconds: made.registering.as_secs_f64(),
            cutting_seconds: made.cutting.as_secs_f64(),
        })
    });
    Ok(vec![File::csv("cut.csv", measured.rows.iter().map(line))?, File::csv("cut-times.csv", times)?])
}

/// The tables, as Markdown.
pub(super) fn page(cut: &Cut, measured: &Measured) -> String {
    let mut page = String::new();
    let mut say = |line: String| writeln!(page, "{line}").expect("memory");
    say(format!(
        "A lattice of {} cubes along each axis, seed {}. Lost and inside are volumes, in cubes. A sliver has less than \
         {SLIVER:e} of the volume of its tetrahedron. Checked one by one: a sample at even steps of the tetrahedra in \
         cubes that a triangle reaches into. Off: the inside share differs by more than 2^-44 from the share by exact \
         contacts, or the tetrahedron has no pieces.\n",
        cut.cubes, cut.common.seed
    ));
    say("| surface | placement | backend | vertex-vertex | vertex-edge | vertex-triangle | edge-edge | triangle-edge | \
         tetrahedron-vertex (queried) |"
        .into());
    say("|---|---|---|---:|---:|---:|---:|---:|---:|".into());
    for row in &measured.rows {
        let name = format!("{} | {} | {}", row.shape.name(), row.placement.name(), row.backend);
        match &row.made {
            Ok(made) => {
                let kinds =
                    [[0, 0], [0, 1], [0, 2], [1, 1], [1, 2], [0, 3]].map(|ranks| made.registered(ranks).to_string());
                say(format!("| {name} | {} ({}) |", kinds.join(" | "), made.asked_in_tetrahedra()));
            }
            Err(why) => say(format!("| {name} | declined: {why} | | | | | |")),
        }
    }
    say(String::new());
    say("| surface | placement | backend | tetrahedra cut | inconsistent | undecided | lost | sum minus the mesh | inside \
         | off the true volume | checked one by one | off | off by at most | slivers (empty) | several points | no point | parts in, out | contacts, s | cutting, s |"
        .into());
    say("|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|".into());
    for row in &measured.rows {
        let Ok(made) = &row.made else { continue };
        let pieces = &made.pieces;
        let [inside, outside] = pieces.parts;
        say(format!(
            "| {} | {} | {} | {} | {} | {} | {:.4} | {:.1e} | {:.4} | {:.2e} | {} of {} | {} | {:.1e} | {} ({}) | {} | {} | {inside}, {outside} | {:.3} | {:.3} |",
            row.shape.name(),
            row.placement.name(),
            row.backend,
            pieces.cut,
            pieces.inconsistent,
            pieces.undecided,
            pieces.lost,
            pieces.sum - row.whole,
            pieces.inside,
            pieces.inside - row.truth,
            made.deviation.checked,
            row.near,
            made.deviation.off,
            made.deviation.furthest,
            pieces.slivers,
            pieces.empty,
            pieces.many,
            pieces.missing,
            made.registering.as_secs_f64(),
            made.cutting.as_secs_f64()
        ));
    }
    page
}
