//! The five predicates by name, and their parameters besides points.

use predicament_predicates::{Axis, Plane, PredicateKind, Question, Scene};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// The axes, in the order of coordinates.
pub const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// The predicate with this name.
///
/// # Errors
/// `ValueError` with the names that there are.
pub fn kind(name: &str) -> PyResult<PredicateKind> {
    PredicateKind::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| {
        let names = PredicateKind::ALL.map(PredicateKind::name).join(", ");
        PyValueError::new_err(format!("no predicate is called {name:?}; the predicates are {names}"))
    })
}

/// The question of a predicate about a scene.
///
/// # Errors
/// `ValueError` if there is no such axis or plane, or the scene has another dimension.
pub fn question(kind: PredicateKind, axis: usize, plane: &str, scene: &Scene) -> PyResult<Question> {
    let question = match kind {
        PredicateKind::Compare => Question::Compare(*AXES[..scene.dimension().count()].get(axis).ok_or_else(|| {
            PyValueError::new_err(format!("there is no axis {axis} in {} dimensions", scene.dimension().count()))
        })?),
        PredicateKind::Orient2d => {
            let plane: Plane = plane.parse().map_err(|_| {
                PyValueError::new_err(format!("no plane is called {plane:?}; the planes are xy, yz, zx"))
            })?;
            if plane.axes().iter().any(|axis| axis.index() >= scene.dimension().count()) {
                return Err(PyValueError::new_err(format!("points of the plane have no plane {}", plane.name())));
            }
            Question::Orient2d(plane)
        }
        other => other.first_question(),
    };
    scene.has_dimension_for(kind).map_err(|why| PyValueError::new_err(why.to_string()))?;
    Ok(question)
}

/// The predicates with the number of points and of coordinates of a query.
pub fn table(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let table = PyDict::new(py);
    for kind in PredicateKind::ALL {
        table.set_item(kind.name(), (kind.arity(), coordinates(kind)))?;
    }
    Ok(table)
}

/// The number of coordinates of a predicate's points; 1 for `compare`, which sees one coordinate.
pub fn coordinates(kind: PredicateKind) -> usize {
    kind.first_question().coordinates().len()
}
