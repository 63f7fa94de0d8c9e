"""Predicates on arrays of points."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native

Signs = Any  # an array of int8, or one int8 for points without leading axes
LETTERS = "abcde"


def orient2d(a: npt.ArrayLike, b: npt.ArrayLike, c: npt.ArrayLike) -> Signs:
    """The turn of a, b, c: 1 if counterclockwise, -1 if clockwise, 0 if the points are on one line.

    The last axis of each argument has the 2 coordinates; the other axes broadcast. The result is an array of int8. The
    signs are exact for all finite coordinates of float64 and float32, and for integers that are doubles.

    Raises ValueError for a coordinate that is not finite, with its row, and for an integer that is not a double.
    """
    return _signs("orient2d", (a, b, c))


def orient3d(a: npt.ArrayLike, b: npt.ArrayLike, c: npt.ArrayLike, d: npt.ArrayLike) -> Signs:
    """The side of d: 1 if d is below the plane of a, b, c, which turn counterclockwise seen from above.

    It is the sign of det(a - d, b - d, c - d). See ``orient2d`` for shapes, types and errors.
    """
    return _signs("orient3d", (a, b, c, d))


def incircle(a: npt.ArrayLike, b: npt.ArrayLike, c: npt.ArrayLike, d: npt.ArrayLike) -> Signs:
    """The circle test: 1 if d is inside the circle of a, b, c, if these turn counterclockwise.

    See ``orient2d`` for shapes, types and errors.
    """
    return _signs("incircle", (a, b, c, d))


def insphere(
    a: npt.ArrayLike, b: npt.ArrayLike, c: npt.ArrayLike, d: npt.ArrayLike, e: npt.ArrayLike
) -> Signs:
    """The sphere test: 1 if e is inside the sphere of a, b, c, d, if ``orient3d(a, b, c, d)`` is 1.

    See ``orient2d`` for shapes, types and errors.
    """
    return _signs("insphere", (a, b, c, d, e))


def compare(a: npt.ArrayLike, b: npt.ArrayLike, axis: int = 0) -> Signs:
    """The order of a and b along an axis: the sign of a's coordinate minus b's.

    See ``orient2d`` for shapes, types and errors.
    """
    return _signs("compare", [column("compare", points, axis, letter) for points, letter in zip((a, b), LETTERS)])


def exact_value(predicate: str, *points: npt.ArrayLike, axis: int = 0) -> Fraction:
    """The exact value of a predicate's determinant about these points, computed in rationals.

    >>> exact_value("orient2d", (0, 0), (1, 0), (0, 0.5))
    Fraction(1, 2)

    The points are one query. The judge of the test harness computes the value; it shares no code with the predicates.
    """
    arity, width = shape_of(predicate)
    if len(points) != arity:
        raise TypeError(f"{predicate} takes {arity} points, not {len(points)}")
    if predicate == "compare":
        points = tuple(column(predicate, point, axis, letter) for point, letter in zip(points, LETTERS))
    rows = [coordinates(predicate, letter, point, width) for point, letter in zip(points, LETTERS)]
    for row, letter in zip(rows, LETTERS):
        if row.ndim != 1:
            raise ValueError(f"{predicate}: {letter} is one point here, not an array of shape {row.shape}")
    numerator, denominator = _native.exact_value(predicate, [row.tolist() for row in rows])
    return Fraction(int(numerator, 16), int(denominator, 16))


def shape_of(predicate: str) -> tuple[int, int]:
    """The number of points of a predicate, and the number of coordinates that it reads of each."""
    try:
        return _native.KINDS[predicate]
    except KeyError:
        names = ", ".join(_native.KINDS)
        raise ValueError(f"no predicate is called {predicate!r}; the predicates are {names}") from None


def column(predicate: str, points: npt.ArrayLike, axis: int, letter: str) -> npt.NDArray[Any]:
    """The coordinate along an axis, as points of one coordinate."""
    array = np.asarray(points)
    if array.ndim == 0 or not 0 <= axis < array.shape[-1]:
        raise ValueError(f"{predicate}: {letter} of shape {array.shape} has no axis {axis}")
    return array[..., axis : axis + 1]


def coordinates(predicate: str, letter: str, points: npt.ArrayLike, width: int) -> npt.NDArray[Any]:
    """The points as an array of float64 or float32 with the same values."""
    array = np.asarray(points)
    where = f"{predicate}: {letter}"
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{where}: coordinates are numbers of a fixed size, not of type {array.dtype}")
    if array.ndim == 0 or array.shape[-1] != width:
        raise ValueError(f"{where} has shape {array.shape}; the last axis has the {width} coordinates of a point")
    if array.dtype == np.float64 or array.dtype == np.float32:
        return array if array.dtype.isnative else array.astype(array.dtype.newbyteorder("="))
    if array.dtype.kind == "f" and array.dtype.itemsize < 4:
        return array.astype(np.float32)
    with np.errstate(over="ignore"):
        wide = array.astype(np.float64)
    if array.dtype.itemsize > 4:
        _same(where, array, wide)
    return wide


def _same(where: str, array: npt.NDArray[Any], wide: npt.NDArray[np.float64]) -> None:
    """Raises ValueError for the first number that rounding to a double has changed."""
    if array.dtype.kind == "f":
        same = (wide == array) | ~np.isfinite(array)
    else:
        limit = 2.0 ** (8 * array.dtype.itemsize - (array.dtype.kind == "i"))
        inside = wide < limit
        same = inside & (np.where(inside, wide, 0).astype(array.dtype) == array)
    if not same.all():
        index = tuple(int(at) for at in np.argwhere(~same)[0])
        raise ValueError(f"{where}{list(index)} is {array[index]}, which is not a double; the sign would be of another point")


def _signs(predicate: str, points: Any) -> Signs:
    width = _native.KINDS[predicate][1]
    arrays = [coordinates(predicate, letter, one, width) for one, letter in zip(points, LETTERS)]
    shapes = [array.shape[:-1] for array in arrays]
    try:
        shape = np.broadcast_shapes(*shapes)
    except ValueError:
        listed = ", ".join(f"{letter} {array.shape}" for array, letter in zip(arrays, LETTERS))
        raise ValueError(f"{predicate}: the shapes do not broadcast: {listed}") from None
    count = int(np.prod(shape, dtype=np.int64))
    rows = [_rows(array, shape, width) for array in arrays]
    try:
        signs = _native.signs(predicate, rows, count)
    except ValueError as error:
        raise named(error, shapes, shape) from None
    return signs.reshape(shape)[()]


def _rows(array: npt.NDArray[Any], shape: tuple[int, ...], width: int) -> npt.NDArray[Any]:
    """A row for each query, or one row for all."""
    if array.size != width and array.shape[:-1] != shape:
        array = np.broadcast_to(array, (*shape, width))
    return np.ascontiguousarray(array).reshape(-1, width)


def named(error: ValueError, shapes: Any, shape: tuple[int, ...]) -> ValueError:
    """The error with the argument and the row by their names, if it is about a row."""
    if len(error.args) != 3:
        return error
    message, of, row = error.args
    rows = shapes[of] if int(np.prod(shapes[of], dtype=np.int64)) == 1 else shape
    index = ", ".join(str(int(at)) for at in np.unravel_index(row, rows)) if rows else ""
    name, rest = message.split(": ", 1)
    return ValueError(f"{name}: {LETTERS[of]}{f'[{index}]' if index else ''}: {rest}")
