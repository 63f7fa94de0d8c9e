//! A backend whose predicate is a Python function.
//!
//! The function gets the points of many queries as one array, and returns one number for each query. The Python side
//! makes such a function of a user's predicate, whatever that takes and returns.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use numpy::{IntoPyArray, PyArray1, PyArrayMethods};
use predicament_predicates::{
    Axis, Backend, Broken, Class, Contract, Declined, Plane, PredicateKind, Predicates, Question, Scene, Sign, Tally,
    Vertex, ZeroMeaning, answer_by,
};
use pyo3::exceptions::{PyException, PyValueError};
use pyo3::prelude::*;

use crate::cases;

/// A Python function as a backend.
pub struct Callable {
    /// The name of the function.
    pub name: String,
    /// The predicate that it answers.
    pub kind: PredicateKind,
    /// The function.
    pub ask: Py<PyAny>,
    /// The meaning of zero that it promises.
    pub zero: ZeroMeaning,
    /// The end of the work, if it was not a fault of the function: Ctrl-C.
    pub ended: Arc<Ended>,
}

/// The end of the work by an exception that is not an error of the function.
#[derive(Default)]
pub struct Ended {
    /// True if the work has to stop.
    pub flag: AtomicBool,
    /// The exception.
    pub why: Mutex<Option<PyErr>>,
}

impl Ended {
    /// Stops the work.
    pub fn stop(&self, why: PyErr) {
        self.why.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(why);
        self.flag.store(true, Ordering::Relaxed);
    }
}

impl Backend for Callable {
    type Session<'s, T: Tally + 's> = Session<'s>;

    fn name(&self) -> String {
        self.name.clone()
    }

    fn contract(&self, _: PredicateKind) -> Contract {
        Contract { zero: self.zero, proved: false }
    }

    fn stages(&self) -> &'static [&'static str] {
        &["python"]
    }

    fn prepare<'s, T: Tally + 's>(&'s self, scene: &'s Scene, _: T) -> Result<Session<'s>, Declined> {
        if scene.constructions().is_empty() {
            Ok(Session { callable: self, scene, has_nan: AtomicBool::new(false) })
        } else {
            Err(Declined::scene("constructed vertices have no coordinates"))
        }
    }
}

/// The session of a Python function for one scene.
pub struct Session<'s> {
    callable: &'s Callable,
    scene: &'s Scene,
    /// True if the function has returned a NaN.
    has_nan: AtomicBool,
}

impl Session<'_> {
    /// The numbers that the function returns for these queries.
    fn values(&self, question: Question, vertices: &[Vertex]) -> Vec<f64> {
        let axes = question.coordinates();
        let points: Vec<f64> = vertices.iter().flat_map(|&vertex| cases::seen(self.scene, axes, vertex)).collect();
        let shape = [vertices.len() / question.kind().arity(), question.kind().arity(), axes.len()];
        let asked = Python::attach(|py| -> PyResult<Vec<f64>> {
            let points = points.into_pyarray(py).reshape(shape)?;
            let values = self.callable.ask.call1(py, (points,))?;
            let values = values.bind(py).cast::<PyArray1<f64>>()?.try_readonly();
            let values = values.map_err(|error| PyValueError::new_err(error.to_string()))?;
            Ok(values.as_slice().map_err(|error| PyValueError::new_err(error.to_string()))?.to_vec())
        });
        match asked {
            Ok(values) if values.len() == shape[0] => {
                if values.iter().any(|value| value.is_nan()) {
                    self.has_nan.store(true, Ordering::Relaxed);
                }
                values
            }
            Ok(values) => self.broken("answers", format!("{} answers to {} queries", values.len(), shape[0])),
            Err(error) => {
                let message = Python::attach(|py| {
                    if error.is_instance_of::<PyException>(py) {
                        return error.to_string();
                    }
                    self.callable.ended.stop(error.clone_ref(py));
                    "ended".to_owned()
                });
                self.broken("exception", message.replace('\n', " "))
            }
        }
    }

    fn broken(&self, check: &'static str, message: String) -> ! {
        Broken { class: Class::Panic, check, message }.throw()
    }

    fn ask<const N: usize>(&self, question: Question, vertices: [Vertex; N]) -> Sign {
        self.values(question, &vertices).first().map_or(Sign::Zero, |&value| Sign::of(value))
    }

    fn signs<const N: usize>(&self, question: Question, queries: &[[Vertex; N]], out: &mut [Sign]) {
        let values = self.values(question, queries.as_flattened());
        out.iter_mut().zip(values).for_each(|(out, value)| *out = Sign::of(value));
    }
}

impl Predicates for Session<'_> {
    fn scene(&self) -> &Scene {
        self.scene
    }

    fn supports(&self, kind: PredicateKind) -> Result<(), Declined> {
        if kind == self.callable.kind {
            self.scene.has_dimension_for(kind)
        } else {
            Err(Declined::predicate(kind, "the function is another predicate"))
        }
    }

    answer_by!(ask);

    /// A NaN if the function returns one: its sign would pass as zero. Other numbers may be signs alone.
    fn estimate(&self, question: Question, args: &[Vertex]) -> Option<f64> {
        // The judge asks for the estimate of each zero. Without any NaN, a second call for each would find none.
        if !self.has_nan.load(Ordering::Relaxed) {
            return None;
        }
        self.values(question, args).first().copied().filter(|value| value.is_nan())
    }

    fn compare_batch(&self, axis: Axis, queries: &[[Vertex; 2]], out: &mut [Sign]) {
        self.signs(Question::Compare(axis), queries, out);
    }

    fn orient2d_batch(&self, plane: Plane, queries: &[[Vertex; 3]], out: &mut [Sign]) {
        self.signs(Question::Orient2d(plane), queries, out);
    }

    fn orient3d_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.signs(Question::Orient3d, queries, out);
    }

    fn incircle_batch(&self, queries: &[[Vertex; 4]], out: &mut [Sign]) {
        self.signs(Question::Incircle, queries, out);
    }

    fn insphere_batch(&self, queries: &[[Vertex; 5]], out: &mut [Sign]) {
        self.signs(Question::Insphere, queries, out);
    }
}

/// Returns true if the function would be asked about these points as they are.
pub fn is_single(scene: &Scene) -> bool {
    scene.coordinates().iter().all(|&x| rounded(x) == x)
}

/// The nearest double that single precision has; infinity beyond its range.
#[allow(clippy::cast_possible_truncation)] // rounding is the purpose
pub fn rounded(x: f64) -> f64 {
    f64::from(x as f32)
}
