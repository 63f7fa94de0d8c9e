//! The smallest broken pairs, as a suite that can be run.

use serde::Serialize;

use super::super::study::{Parity, Searched};
use super::table::{all, scene_name, ways};
use super::{Census, Kind, Small};
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
    points: Vec<[toml::Value; 3]>,
    a: Triangles,
    b: Triangles,
    tags: Vec<&'static str>,
    source: String,
    analysis: String,
}

#[derive(Serialize)]
struct Triangles {
    triangles: Vec<[usize; 3]>,
}

/// The smallest pairs.
pub(in super::super) fn smallest(parity: &Parity, searched: &[Searched<Census, Kind, Small>]) -> Result<File, Error> {
    let seed = parity.seed;
    let scene = |(at, (precision, kind, small)): (usize, (Precision, &Kind, &Small))| {
        let [a, b] = &small.pair.surfaces;
        let of = |from: usize, triangles: &[[usize; 3]]| Triangles {
            triangles: triangles.iter().map(|triangle| triangle.map(|at| from + at)).collect(),
        };
        let minimal = if small.minimal { "minimal" } else { "the limit came before it was minimal" };
        Scene {
            name: scene_name(precision, at + 1),
            task: "contacts3d",
            points: a.points.iter().chain(&b.points).map(|point| point.map(coordinate)).collect(),
            a: of(0, &a.triangles),
            b: of(a.points.len(), &b.triangles),
            tags: vec!["near-degenerate", "loose-ends", precision.name()],
            source: format!(
                "predicament parity --dimension 3 --seed {seed}: recipe {}, number {}, shrunk ({minimal})",
                small.recipe.name(),
                small.number
            ),
            analysis: format!(
                "Tolerances in {} contradict each other on these closed surfaces: {}.",
                precision.name(),
                ways(kind)
            ),
        }
    };
    let suite = Suite {
        title: "Broken curves".into(),
        description: "The smallest pairs of closed surfaces found whose curves of intersection are broken.".into(),
        scene: all(searched).enumerate().map(scene).collect(),
    };
    Ok(File::new("smallest.toml", toml::to_string(&suite).map_err(Error::format)?))
}
