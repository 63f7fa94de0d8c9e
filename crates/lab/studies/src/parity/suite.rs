//! The smallest pairs, as a suite for `run`.

use serde::Serialize;

use super::searched::{PlaneSearched, SpaceSearched, all};
use super::{Kind, Parity, PolygonPair, Recipe, Small, space, table};
use crate::coordinate::coordinate;
use crate::{Error, File, Precision};

#[derive(Serialize)]
struct Suite<C> {
    title: String,
    description: String,
    scene: Vec<Scene<C>>,
}

#[derive(Serialize)]
struct Scene<C> {
    name: String,
    task: &'static str,
    points: Vec<Vec<toml::Value>>,
    a: C,
    b: C,
    tags: Vec<&'static str>,
    source: String,
    analysis: String,
}

#[derive(Serialize)]
struct Closed {
    closed: Vec<Vec<usize>>,
}

#[derive(Serialize)]
struct Triangles {
    triangles: Vec<[usize; 3]>,
}

/// The suite of the smallest odd pairs of polygons.
pub(super) fn polygons(parity: &Parity, searched: &[PlaneSearched]) -> Result<File, Error> {
    let scene = |(at, (precision, kind, small)): (usize, (Precision, &Kind, &Small<PolygonPair, Recipe>))| {
        let [a, b] = &small.pair.polygons;
        let closed = |from: usize, count: usize| Closed { closed: vec![(from..from + count).collect()] };
        let seats = table::seats(kind);
        Scene {
            name: table::scene_name(precision, at + 1),
            task: "contacts2d",
            points: points(a.iter().chain(b)),
            a: closed(0, a.len()),
            b: closed(a.len(), b.len()),
            tags: vec!["near-degenerate", "odd-crossings", precision.name()],
            source: source(parity, "", small.recipe.name(), small),
            analysis: format!(
                "Tolerances in {} make these closed curves cross an odd number of times where merged points sit at \
                 {seats}.",
                precision.name()
            ),
        }
    };
    let description = "The smallest pairs of simple polygons found that cross an odd number of times once merged.";
    suite("Odd crossings", description, all(searched).enumerate().map(scene).collect())
}

/// The suite of the smallest broken pairs of surfaces.
pub(super) fn surfaces(parity: &Parity, searched: &[SpaceSearched]) -> Result<File, Error> {
    let scene = |(at, (precision, kind, small)): (
        usize,
        (Precision, &space::Kind, &Small<space::SurfacePair, space::Recipe>),
    )| {
        let [a, b] = &small.pair.surfaces;
        let of = |from: usize, triangles: &[[usize; 3]]| Triangles {
            triangles: triangles.iter().map(|triangle| triangle.map(|at| from + at)).collect(),
        };
        Scene {
            name: space::scene_name(precision, at + 1),
            task: "contacts3d",
            points: points(a.points.iter().chain(&b.points)),
            a: of(0, &a.triangles),
            b: of(a.points.len(), &b.triangles),
            tags: vec!["near-degenerate", "loose-ends", precision.name()],
            source: source(parity, " --dimension 3", small.recipe.name(), small),
            analysis: format!(
                "Tolerances in {} contradict each other on these closed surfaces: {}.",
                precision.name(),
                space::ways(kind)
            ),
        }
    };
    let description = "The smallest pairs of closed surfaces found whose curves of intersection are broken.";
    suite("Broken curves", description, all(searched).enumerate().map(scene).collect())
}

fn suite<C: Serialize>(title: &str, description: &str, scene: Vec<Scene<C>>) -> Result<File, Error> {
    let suite = Suite { title: title.to_owned(), description: description.to_owned(), scene };
    Ok(File::new("smallest.toml", toml::to_string(&suite).map_err(Error::format)?))
}

/// The command that found the pair.
fn source<P, R>(parity: &Parity, dimension: &str, recipe: &str, small: &Small<P, R>) -> String {
    let minimal = if small.minimal { "minimal" } else { "the limit was reached before it was minimal" };
    let (seed, number) = (parity.common.seed, small.number);
    format!("predicament study parity{dimension} --seed {seed}: recipe {recipe}, number {number}, shrunk ({minimal})")
}

fn points<'a, const D: usize>(points: impl Iterator<Item = &'a [f64; D]>) -> Vec<Vec<toml::Value>> {
    points.map(|point| point.iter().copied().map(coordinate).collect()).collect()
}
