//! Cases: queries of a family with the truth about each.

use std::sync::atomic::AtomicBool;

use numpy::{IntoPyArray, PyArray1};
use predicament_corpus::{Level, LoadedScene, SceneFormat, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_predicates::{Scene, Vertex};
use predicament_tasks::Watch;
use predicament_tasks::signs::{SignQueries, Signs, truth};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::kinds;

/// The families of a predicate: names, parameters, one line about each, and whether its points have coordinates.
#[pyfunction]
pub fn families<'py>(py: Python<'py>, name: &str) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let row = |family: &predicament_corpus::Family| {
        let row = PyDict::new(py);
        row.set_item("family", family.name)?;
        row.set_item("parameters", family.parameters.join(" "))?;
        row.set_item("about", family.about)?;
        Ok(row)
    };
    let all = Signs::of(kinds::kind(name)?);
    all.families().iter().filter(|family| !is_constructed(family.name)).map(row).collect()
}

/// True for a family whose points are constructed, so that they have no coordinates.
fn is_constructed(family: &str) -> bool {
    ["ssi-", "lpi-", "tpi-"].iter().any(|kind| family.starts_with(kind))
}

type Made<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<i8>>);

/// Queries of a family: the coordinates of all points of all queries, one after another, and the exact signs.
///
/// `keys` are lines of TOML for the family's own parameters.
#[pyfunction]
pub fn cases<'py>(py: Python<'py>, name: &str, family: &str, n: u64, seed: u64, keys: &str) -> PyResult<Made<'py>> {
    let kind = kinds::kind(name)?;
    let known: Vec<&str> = Signs::of(kind).families().iter().map(|family| family.name).collect();
    if !known.contains(&family) || is_constructed(family) {
        let known: Vec<&str> = known.into_iter().filter(|family| !is_constructed(family)).collect();
        return Err(PyValueError::new_err(format!(
            "{name} has no family {family:?} of points with coordinates; its families are {}",
            known.join(", ")
        )));
    }
    let size = if keys.contains("side =") { String::new() } else { format!("n = {n}\n") };
    let text = format!(
        "title = \"cases\"\n[[generate]]\nname = \"cases\"\nfamily = \"{family}\"\ntask = \"{name}\"\n\
         {size}seed = {seed}\n{keys}"
    );
    let (points, signs) = py.detach(|| made(&text)).map_err(PyValueError::new_err)?;
    Ok((points.into_pyarray(py), signs.into_pyarray(py)))
}

/// The points and signs of the only scene of a suite.
fn made(text: &str) -> Result<(Vec<f64>, Vec<i8>), String> {
    let vocabulary = predicament_bundle::vocabulary();
    let suite = Suite::parse(vocabulary, "cases", text, None, &Manifest::default()).map_err(|why| why.to_string())?;
    let [scene] = suite.scenes.as_slice() else { return Err("not one scene".to_owned()) };
    let loaded = scene.load(Level::Quick, &Cache::new("")).map_err(|why| why.to_string())?;
    let queries = &content(&loaded).map_err(|why| why.to_string())?.queries;
    let never = AtomicBool::new(false);
    let signs = truth(&loaded.scene, queries, &Watch::new(&never, None, &|_| {})).map_err(|_| "stopped".to_owned())?;
    let axes = queries.question().coordinates();
    let mut points = Vec::with_capacity(queries.flat().len() * axes.len());
    points.extend(queries.flat().iter().flat_map(|&vertex| seen(&loaded.scene, axes, vertex)));
    Ok((points, signs.into_iter().map(|sign| sign.as_i8()).collect()))
}

/// The queries of a scene of signs.
pub fn content(loaded: &LoadedScene) -> PyResult<&SignQueries> {
    loaded.content().ok_or_else(|| PyRuntimeError::new_err(format!("{} is not a scene of signs", loaded.name)))
}

/// The coordinates of a vertex that a predicate reads.
pub fn seen<'s>(scene: &'s Scene, axes: &'s [usize], vertex: Vertex) -> impl Iterator<Item = f64> + 's {
    axes.iter().map(move |&axis| scene.point(vertex)[axis])
}
