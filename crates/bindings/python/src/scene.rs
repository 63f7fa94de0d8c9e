//! Scenes: points that are prepared once and asked about by their indices.

use std::sync::OnceLock;

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Dimension, Predicates, Question, SceneError, Sign, Vertex};
use predicament_sos::{Scheme, Sos};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use self_cell::self_cell;

use crate::arrays::not_finite;
use crate::kinds;

/// The number of queries whose indices are checked and answered at a time.
const CHUNK: usize = 2048;

static EXACT: Exact = Exact;
static SOS: Sos = Sos { scheme: Scheme::PerCoordinate };

type Session<'s> = Box<dyn Predicates + 's>;

self_cell!(
    /// A scene with a session that was prepared for it.
    struct Prepared {
        owner: predicament_predicates::Scene,
        #[not_covariant]
        dependent: Session,
    }
);

/// The points of a scene, prepared for exact signs and for perturbed signs when they are first asked for.
#[pyclass(frozen, module = "predicament._native")]
pub struct Scene {
    scene: predicament_predicates::Scene,
    exact: OnceLock<Prepared>,
    sos: OnceLock<Prepared>,
}

#[pymethods]
impl Scene {
    /// Makes a scene of contiguous points, a row each.
    #[new]
    fn new(py: Python<'_>, points: PyReadonlyArray2<'_, f64>) -> PyResult<Scene> {
        let (shape, slice) = (points.as_array().dim(), points.as_slice());
        let slice = slice.map_err(|_| PyValueError::new_err("points are a contiguous array"))?;
        let dimension = Dimension::of(shape.1).ok_or_else(|| {
            PyValueError::new_err(format!("points have 2 or 3 coordinates, and these have {}", shape.1))
        })?;
        let scene = py.detach(|| predicament_predicates::Scene::new(dimension, slice.to_vec()));
        let scene = scene.map_err(|error| match error {
            SceneError::NotFinite { vertex, axis, value } => {
                PyValueError::new_err((format!("Scene: {}", not_finite(axis, value)), 0, vertex))
            }
            other => PyValueError::new_err(other.to_string()),
        })?;
        Ok(Scene { scene, exact: OnceLock::new(), sos: OnceLock::new() })
    }

    /// The number of points.
    fn __len__(&self) -> usize {
        self.scene.len()
    }

    /// The number of coordinates of a point.
    #[getter]
    fn dimension(&self) -> usize {
        self.scene.dimension().count()
    }

    /// The signs of queries about contiguous rows of indices.
    fn signs<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        ids: PyReadonlyArray2<'py, i64>,
        sos: bool,
        axis: usize,
        plane: &str,
    ) -> PyResult<Bound<'py, PyArray1<i8>>> {
        let question = kinds::question(kinds::kind(name)?, axis, plane, &self.scene)?;
        let arity = question.kind().arity();
        let (width, slice) = (ids.as_array().dim().1, ids.as_slice());
        if width != arity {
            return Err(PyValueError::new_err(format!("{name} takes {arity} points, and a row has {width}")));
        }
        let slice = slice.map_err(|_| PyValueError::new_err("indices are a contiguous array"))?;
        let signs = py.detach(|| self.answer(question, slice, sos))?;
        Ok(signs.into_pyarray(py))
    }
}

impl Scene {
    fn prepared(&self, sos: bool) -> PyResult<&Prepared> {
        let cell = if sos { &self.sos } else { &self.exact };
        if let Some(prepared) = cell.get() {
            return Ok(prepared);
        }
        let prepared =
            Prepared::try_new(
                self.scene.clone(),
                |scene| {
                    if sos { SOS.boxed(scene, None) } else { EXACT.boxed(scene, None) }
                },
            );
        let prepared = prepared.map_err(|declined| PyValueError::new_err(declined.to_string()))?;
        Ok(cell.get_or_init(|| prepared))
    }

    /// The signs of all queries; the first index without a point is an error.
    fn answer(&self, question: Question, ids: &[i64], sos: bool) -> PyResult<Vec<i8>> {
        let (arity, points) = (question.kind().arity(), self.scene.len());
        let vertex = |&id: &i64| usize::try_from(id).ok().filter(|&id| id < points).map(Vertex::input);
        self.prepared(sos)?.with_dependent(|_, session| {
            let mut signs = Vec::with_capacity(ids.len() / arity);
            let mut vertices = Vec::with_capacity(CHUNK * arity);
            let mut out = [Sign::Zero; CHUNK];
            for (chunk, ids) in ids.chunks(CHUNK * arity).enumerate() {
                vertices.clear();
                vertices.extend(ids.iter().map_while(vertex));
                if let Some(id) = ids.get(vertices.len()) {
                    return Err(PyIndexError::new_err((
                        format!("{}: there is no point {id}; the scene has {points}", question.kind()),
                        0,
                        chunk * CHUNK + vertices.len() / arity,
                    )));
                }
                let out = &mut out[..ids.len() / arity];
                question.ask_batch(&**session, &vertices, out);
                signs.extend(out.iter().map(|sign| sign.as_i8()));
            }
            Ok(signs)
        })
    }
}
