//! The time of the same work in Rust alone, which `bench/overhead.py` compares with a call from Python.

use std::hint::black_box;
use std::time::Instant;

use numpy::PyReadonlyArray2;
use predicament_exact::{Exact, NotFinite, raw};
use predicament_predicates::{Backend, Dimension, Off, Predicates, QuerySet, Scene, Sign, Vertex};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::kinds;

fn slices<'a>(arrays: &'a [PyReadonlyArray2<'_, f64>]) -> PyResult<Vec<&'a [f64]>> {
    let slices: Result<_, _> = arrays.iter().map(PyReadonlyArray2::as_slice).collect();
    slices.map_err(|_| PyValueError::new_err("the arrays are contiguous"))
}

/// The seconds of a loop over rows of these arrays that calls the predicate on coordinates.
#[pyfunction]
pub fn seconds_of_loop(py: Python<'_>, name: &str, arrays: Vec<PyReadonlyArray2<'_, f64>>) -> PyResult<f64> {
    let (name, arrays) = (kinds::kind(name)?.name(), slices(&arrays)?);
    py.detach(|| match (name, arrays.as_slice()) {
        ("orient2d", [a, b, c]) => Ok(timed([a, b, c], raw::try_orient2d)),
        ("orient3d", [a, b, c, d]) => Ok(timed([a, b, c, d], raw::try_orient3d)),
        ("incircle", [a, b, c, d]) => Ok(timed([a, b, c, d], raw::try_incircle)),
        ("insphere", [a, b, c, d, e]) => Ok(timed([a, b, c, d, e], raw::try_insphere)),
        _ => Err(PyValueError::new_err("one array for each point of the predicate")),
    })
}

/// The seconds of the loop, with the function that Python's arrays call.
fn timed<const D: usize, const N: usize>(
    arrays: [&[f64]; N],
    sign: impl Fn([[f64; D]; N]) -> Result<Sign, NotFinite>,
) -> f64 {
    let rows = arrays.map(|array| array.as_chunks::<D>().0);
    let start = Instant::now();
    let signs: Result<Vec<Sign>, _> = (0..rows[0].len()).map(|at| sign(rows.map(|rows| rows[at]))).collect();
    black_box(&signs);
    start.elapsed().as_secs_f64()
}

/// The seconds of one batch of a prepared session: without its preparation, and without making the vertices.
#[pyfunction]
pub fn seconds_of_batch(
    py: Python<'_>,
    name: &str,
    points: PyReadonlyArray2<'_, f64>,
    ids: PyReadonlyArray2<'_, i64>,
) -> PyResult<f64> {
    let broken = |_| PyValueError::new_err("the arrays are contiguous, and the points are a scene");
    let kind = kinds::kind(name)?;
    let dimension = Dimension::of(points.as_array().dim().1).ok_or_else(|| broken(()))?;
    let (points, ids) = (points.as_slice().map_err(|_| broken(()))?, ids.as_slice().map_err(|_| broken(()))?);
    py.detach(|| {
        let scene = Scene::new(dimension, points.to_vec()).map_err(|_| broken(()))?;
        let vertex = |&id: &i64| usize::try_from(id).ok().filter(|&id| id < scene.len()).map(Vertex::input);
        let vertices: Vec<Vertex> = ids.iter().map(vertex).collect::<Option<_>>().ok_or_else(|| broken(()))?;
        let queries = QuerySet::new(kind.first_question(), vertices);
        let session = Exact.prepare(&scene, Off).map_err(|_| broken(()))?;
        session.supports(kind).map_err(|_| broken(()))?;
        let mut out = vec![Sign::Zero; queries.len()];
        let start = Instant::now();
        queries.ask_batch(&session, 0..queries.len(), &mut out);
        black_box(&out);
        Ok(start.elapsed().as_secs_f64())
    })
}
