//! The smallest odd pairs, as a suite that can be run.

use serde::Serialize;

use super::study::PlaneSearched;
use super::table::{all, scene_name, seats};
use super::{Kind, Parity, PolygonPair, Small};
use crate::coordinate::coordinate;
use crate::{Error, File, Precision};

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

/// The smallest pairs.
pub(super) fn smallest(parity: &Parity, searched: &[PlaneSearched]) -> Result<File, Error> {
    let seed = parity.seed;
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
            tags: vec!["near-degenerate", "odd-crossings", precision.name()],
            source: format!(
                "predicament parity --seed {seed}: recipe {}, number {}, shrunk ({minimal})",
                small.recipe.name(),
                small.number
            ),
            analysis: format!(
                "Tolerances in {} make these closed curves cross an odd number of times where merged points sit at {}.",
                precision.name(),
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
    Ok(File::new("smallest.toml", toml::to_string(&suite).map_err(Error::format)?))
}
