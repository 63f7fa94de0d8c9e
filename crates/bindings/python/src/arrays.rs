//! Predicates on arrays: a query is a row of each array.
//!
//! Rows are copied into a block that stays in the fast cache, widened to doubles and checked there, and answered from
//! there. Widening is exact, so single precision needs no code of its own. The copies also make all arrays look alike:
//! those of one row, which is part of every query, too.

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use predicament_exact::raw;
use predicament_predicates::{PredicateKind, Sign};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;

use crate::kinds;

/// The number of queries that are copied, checked and answered at a time.
const BLOCK: usize = 256;

/// The signs of a predicate, one for each row: -1, 0 or 1.
///
/// Each array is contiguous, of doubles or floats, and has a row for each query, or one row for all.
///
/// # Errors
/// `ValueError` with the array, the row and the column if a coordinate is not finite: the arguments are a message, the
/// index of the array, and the row. `TypeError` if an array is of another kind.
#[pyfunction]
pub fn signs<'py>(
    py: Python<'py>,
    name: &str,
    arrays: Vec<Bound<'py, PyAny>>,
    count: usize,
) -> PyResult<Bound<'py, PyArray1<i8>>> {
    let kind = kinds::kind(name)?;
    let held: Vec<Held> = arrays.iter().map(Held::of).collect::<PyResult<_>>()?;
    if held.len() != kind.arity() {
        return Err(PyValueError::new_err(format!("{name} takes {} arrays", kind.arity())));
    }
    let rows: Vec<Rows> = held.iter().map(Held::rows).collect::<PyResult<_>>()?;
    for (rows, array) in rows.iter().zip(&held) {
        let [had, width] = array.shape();
        if width != kinds::coordinates(kind) || (had != count && had != 1) {
            return Err(PyValueError::new_err(format!("{name}: an array of {had} rows of {width} coordinates")));
        }
        debug_assert_eq!(rows.len(), had * width);
    }
    let done = py.detach(|| match kind {
        PredicateKind::Compare => {
            blocks::<1, 2>(&rows, count, |[[a], [b]]| Sign::of(f64::from(i8::from(a > b) - i8::from(a < b))))
        }
        PredicateKind::Orient2d => blocks::<2, 3>(&rows, count, raw::orient2d),
        PredicateKind::Orient3d => blocks::<3, 4>(&rows, count, raw::orient3d),
        PredicateKind::Incircle => blocks::<2, 4>(&rows, count, raw::incircle),
        PredicateKind::Insphere => blocks::<3, 5>(&rows, count, raw::insphere),
        PredicateKind::Derived(_) => Ok(Vec::new()),
    });
    match done {
        Ok(signs) => Ok(signs.into_pyarray(py)),
        Err(NotFinite { array, row, column, value }) => {
            Err(PyValueError::new_err((format!("{name}: {}", not_finite(column, value)), array, row)))
        }
    }
}

/// An array of points that is kept from changing.
enum Held<'py> {
    Double(PyReadonlyArray2<'py, f64>),
    Single(PyReadonlyArray2<'py, f32>),
}

impl<'py> Held<'py> {
    fn of(array: &Bound<'py, PyAny>) -> PyResult<Held<'py>> {
        if let Ok(array) = array.cast::<PyArray2<f64>>() {
            Ok(Held::Double(array.try_readonly().map_err(busy)?))
        } else if let Ok(array) = array.cast::<PyArray2<f32>>() {
            Ok(Held::Single(array.try_readonly().map_err(busy)?))
        } else {
            Err(PyTypeError::new_err("points are arrays of two dimensions, of float64 or float32"))
        }
    }

    fn shape(&self) -> [usize; 2] {
        let shape = match self {
            Held::Double(array) => array.shape(),
            Held::Single(array) => array.shape(),
        };
        [shape[0], shape[1]]
    }

    fn rows(&self) -> PyResult<Rows<'_>> {
        let not_contiguous = |_| PyTypeError::new_err("points are contiguous arrays");
        Ok(match self {
            Held::Double(array) => Rows::Double(array.as_slice().map_err(not_contiguous)?),
            Held::Single(array) => Rows::Single(array.as_slice().map_err(not_contiguous)?),
        })
    }
}

fn busy(error: numpy::BorrowError) -> PyErr {
    PyValueError::new_err(format!("an array is being written: {error}"))
}

/// The coordinates of an array, point after point.
#[derive(Clone, Copy)]
enum Rows<'a> {
    Double(&'a [f64]),
    Single(&'a [f32]),
}

impl Rows<'_> {
    fn len(&self) -> usize {
        match self {
            Rows::Double(all) => all.len(),
            Rows::Single(all) => all.len(),
        }
    }

    /// Copies the rows from `first` on; returns false if a coordinate is not finite.
    #[inline(always)]
    fn copy<const D: usize>(&self, first: usize, to: &mut [[f64; D]]) -> bool {
        let (to, first) = (to.as_flattened_mut(), first * D);
        let end = first + to.len();
        match self {
            Rows::Double(all) => to.copy_from_slice(&all[first..end]),
            Rows::Single(all) => to.iter_mut().zip(&all[first..end]).for_each(|(to, &x)| *to = f64::from(x)),
        }
        are_finite(to)
    }
}

/// True if all of these are finite; without branches, so that it costs little.
fn are_finite(numbers: &[f64]) -> bool {
    numbers.iter().fold(true, |all, x| all & x.is_finite())
}

/// The message about a coordinate, which is spelled as Python spells it.
pub fn not_finite(column: usize, value: f64) -> String {
    let value = value.to_string().to_lowercase();
    format!("coordinate {column} is {value}; coordinates must be finite")
}

/// The first coordinate that is not finite.
struct NotFinite {
    array: usize,
    row: usize,
    column: usize,
    value: f64,
}

/// The signs of all queries, block after block.
fn blocks<const D: usize, const N: usize>(
    arrays: &[Rows<'_>],
    count: usize,
    sign: impl Fn([[f64; D]; N]) -> Sign,
) -> Result<Vec<i8>, NotFinite> {
    let mut signs = Vec::with_capacity(count);
    let mut block = [[[0.0; D]; BLOCK]; N];
    let is_one: [bool; N] = std::array::from_fn(|of| arrays[of].len() == D && count != 1);
    for (of, points) in block.iter_mut().enumerate().filter(|(of, _)| is_one[*of]) {
        let mut one = [[0.0; D]];
        if !arrays[of].copy(0, &mut one) {
            return Err(found(&one, of, 0));
        }
        points.fill(one[0]);
    }
    for first in (0..count).step_by(BLOCK) {
        let length = BLOCK.min(count - first);
        for (of, points) in block.iter_mut().enumerate().filter(|(of, _)| !is_one[*of]) {
            if !arrays[of].copy(first, &mut points[..length]) {
                return Err(found(&points[..length], of, first));
            }
        }
        signs.extend((0..length).map(|at| sign(std::array::from_fn(|of| block[of][at])).as_i8()));
    }
    Ok(signs)
}

/// The first number that is not finite, in rows from `first` on.
#[cold]
fn found<const D: usize>(points: &[[f64; D]], array: usize, first: usize) -> NotFinite {
    let at = points.as_flattened().iter().position(|x| !x.is_finite()).unwrap_or(0);
    NotFinite { array, row: first + at / D, column: at % D, value: points.as_flattened()[at] }
}
