//! The pairs as a suite, so that `run` judges them and `bench` times other programs on them.

use predicament_report::text::in_order;
use serde::Serialize;

use super::{Measured, Touching};
use crate::coordinate::coordinate;
use crate::{Error, File};

#[derive(Serialize)]
struct Suite {
    title: String,
    description: String,
    scene: Vec<Scene>,
}

#[derive(Serialize)]
struct Scene {
    name: &'static str,
    task: &'static str,
    points: Vec<Vec<toml::Value>>,
    first: Vec<[u32; 3]>,
    second: Vec<[u32; 3]>,
    source: String,
    analysis: String,
}

/// The suite of all measured pairs.
pub(super) fn suite(study: &Touching, measured: &Measured) -> Result<File, Error> {
    let scenes = in_order(measured.rows.iter().map(|row| row.pair)).into_iter().map(|pair| {
        let [first, second] = pair.solids(study.side, study.levels as usize);
        let before = u32::try_from(first.points.len()).expect("few points");
        Scene {
            name: pair.name(),
            task: "mesh-intersect",
            points: first.points.iter().chain(&second.points).map(|point| point.map(coordinate).to_vec()).collect(),
            first: first.triangles,
            second: second.triangles.iter().map(|triangle| triangle.map(|v| before + v)).collect(),
            source: format!("predicament study touching --side {} --levels {}", study.side, study.levels),
            analysis: format!("The pair `{}` of the study: docs/TOUCHING.md says what is counted.", pair.name()),
        }
    });
    let suite = Suite {
        title: "Pairs of solids that touch".to_owned(),
        description: "The pairs of the study of solids that touch.".to_owned(),
        scene: scenes.collect(),
    };
    Ok(File::new("touching-pairs.toml", toml::to_string(&suite).map_err(Error::format)?))
}
