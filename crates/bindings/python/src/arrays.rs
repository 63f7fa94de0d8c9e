//! Predicates on arrays: a query is a row of each array.
//!
//! Arrays of doubles with a row for each query are read where they are. Other arrays are copied, a block at a time, and
//! answered from there: single precision is widened, which is exact, and an array of one row has that row in every
//! query. The predicates find coordinates that are not finite: their filters never decide about these.

use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use predicament_exact::{NotFinite, raw};
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
        PredicateKind::Compare => all(&rows, count, compare),
        PredicateKind::Orient2d => all(&rows, count, raw::try_orient2d),
        PredicateKind::Orient3d => all(&rows, count, raw::try_orient3d),
        PredicateKind::Incircle => all(&rows, count, raw::try_incircle),
        PredicateKind::Insphere => all(&rows, count, raw::try_insphere),
        PredicateKind::Derived(_) => Ok(Vec::new()),
    });
    match done {
        Ok(signs) => Ok(signs.into_pyarray(py)),
        Err((query, NotFinite { point, axis, value })) => {
            let row = if held[point].shape()[0] == count { query } else { 0 };
            Err(PyValueError::new_err((format!("{name}: {}", not_finite(axis, value)), point, row)))
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

    /// Copies the rows from `first` on.
    #[inline(always)]
    fn copy<const D: usize>(&self, first: usize, to: &mut [[f64; D]]) {
        let (to, first) = (to.as_flattened_mut(), first * D);
        let end = first + to.len();
        match self {
            Rows::Double(all) => to.copy_from_slice(&all[first..end]),
            Rows::Single(all) => to.iter_mut().zip(&all[first..end]).for_each(|(to, &x)| *to = f64::from(x)),
        }
    }
}

/// The message about a coordinate, which is spelled as Python spells it.
pub fn not_finite(column: usize, value: f64) -> String {
    let value = value.to_string().to_lowercase();
    format!("coordinate {column} is {value}; coordinates must be finite")
}

/// The order of two numbers.
fn compare([[a], [b]]: [[f64; 1]; 2]) -> Result<Sign, NotFinite> {
    match [a, b].iter().position(|x| !x.is_finite()) {
        None => Ok(Sign::of(f64::from(i8::from(a > b) - i8::from(a < b)))),
        Some(point) => Err(NotFinite { point, axis: 0, value: [a, b][point] }),
    }
}

/// The signs of all queries, or the first row with a coordinate that is not finite.
fn all<const D: usize, const N: usize>(
    arrays: &[Rows<'_>],
    count: usize,
    sign: impl Fn([[f64; D]; N]) -> Result<Sign, NotFinite>,
) -> Result<Vec<i8>, (usize, NotFinite)> {
    let mut signs = vec![0; count];
    let whole: [Option<&[[f64; D]]>; N] = std::array::from_fn(|of| match arrays[of] {
        Rows::Double(all) => Some(all.as_chunks().0).filter(|rows| rows.len() == count),
        Rows::Single(_) => None,
    });
    if whole.iter().all(Option::is_some) {
        return answer(&whole.map(Option::unwrap_or_default), 0, &mut signs, &sign).map(|()| signs);
    }
    let mut block = [[[0.0; D]; BLOCK]; N];
    let is_one: [bool; N] = std::array::from_fn(|of| arrays[of].len() == D && count != 1);
    for (of, points) in block.iter_mut().enumerate().filter(|(of, _)| is_one[*of]) {
        let mut one = [[0.0; D]];
        arrays[of].copy(0, &mut one);
        points.fill(one[0]);
    }
    for (at, signs) in signs.chunks_mut(BLOCK).enumerate() {
        for (of, points) in block.iter_mut().enumerate().filter(|(of, _)| !is_one[*of]) {
            arrays[of].copy(at * BLOCK, &mut points[..signs.len()]);
        }
        answer(&block.each_ref().map(<[_; BLOCK]>::as_slice), at * BLOCK, signs, &sign)?;
    }
    Ok(signs)
}

/// Answers queries of which the first one is that of row `first`.
#[inline(always)]
fn answer<const D: usize, const N: usize>(
    rows: &[&[[f64; D]]; N],
    first: usize,
    signs: &mut [i8],
    sign: &impl Fn([[f64; D]; N]) -> Result<Sign, NotFinite>,
) -> Result<(), (usize, NotFinite)> {
    let rows: [&[[f64; D]]; N] = std::array::from_fn(|of| &rows[of][..signs.len()]);
    for (at, to) in signs.iter_mut().enumerate() {
        match sign(std::array::from_fn(|of| rows[of][at])) {
            Ok(sign) => *to = sign.as_i8(),
            Err(error) => return Err((first + at, error)),
        }
    }
    Ok(())
}
