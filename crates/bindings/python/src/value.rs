//! Exact values of predicates, by the judge.

use predicament_judge::verdict;
use predicament_predicates::{Dimension, Question, Vertex};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::kinds;

/// The exact value of a predicate's determinant about these points: numerator and denominator, in hexadecimal.
///
/// `compare` takes points of one coordinate.
#[pyfunction]
pub fn exact_value(py: Python<'_>, name: &str, points: Vec<Vec<f64>>) -> PyResult<(String, String)> {
    let kind = kinds::kind(name)?;
    let width = kinds::coordinates(kind);
    if points.len() != kind.arity() || points.iter().any(|point| point.len() != width) {
        let (arity, points) = (kind.arity(), points.len());
        return Err(PyValueError::new_err(format!("{name} takes {arity} points of {width} coordinates, not {points}")));
    }
    // Points on a line are points of the plane.
    let flat: Vec<f64> =
        points.iter().flat_map(|point| point.iter().copied().chain((width == 1).then_some(0.0))).collect();
    let dimension = Dimension::of(width.max(2)).ok_or_else(|| PyValueError::new_err("no such dimension"))?;
    let scene = predicament_predicates::Scene::new(dimension, flat);
    let scene = scene.map_err(|error| PyValueError::new_err(error.to_string()))?;
    let question: Question = kind.first_question();
    let vertices: Vec<Vertex> = scene.vertices().collect();
    Ok(py.detach(|| {
        let value = verdict(&scene, question, &vertices).determinant;
        (value.numer().to_string_radix(16), value.denom().to_string_radix(16))
    }))
}
