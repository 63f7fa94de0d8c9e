"""One way to ask any predicate: scalar or vectorised, of doubles or floats, that returns signs or determinants."""

from __future__ import annotations

from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from ._arrays import shape_of

#: The rows of the trial. No point has so many coordinates, so that a scalar function can't return so many numbers.
TRIAL = 7


class Asked:
    """A function that answers arrays of shape (queries, points, coordinates) by one number for each query.

    The function gets a point as an array of its coordinates, or an array of such points if it is vectorised; `compare`
    gets the coordinates themselves. With ``vectorised=None`` one call with seven rows finds out.
    """

    def __init__(self, function: Callable[..., Any], predicate: str, dtype: Any, vectorised: bool | None) -> None:
        self.arity, self.width = shape_of(predicate)
        self.function = function
        self.dtype = np.dtype(dtype)
        if self.dtype not in (np.dtype(np.float64), np.dtype(np.float32)):
            raise ValueError(f"dtype is float64 or float32, not {self.dtype}")
        self.is_vectorised = self._is_vectorised() if vectorised is None else vectorised

    def __call__(self, points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        args = self._args(points)
        if self.is_vectorised:
            array = np.asarray(self.function(*args))
            if array.shape != (len(points),):
                raise ValueError(f"the function returned an array of shape {array.shape} for {len(points)} queries")
            if array.dtype != object:
                return np.ascontiguousarray(array, dtype=np.float64)
            answers = list(array)
        else:
            answers = [self.function(*row) for row in zip(*args)]
        return np.array([_number(answer) for answer in answers], dtype=np.float64)

    def _args(self, points: npt.NDArray[np.float64]) -> list[npt.NDArray[Any]]:
        points = points.astype(self.dtype)
        if self.width == 1:
            return [points[:, at, 0] for at in range(self.arity)]
        return [points[:, at] for at in range(self.arity)]

    def _is_vectorised(self) -> bool:
        points = np.random.default_rng(1).random((TRIAL, self.arity, self.width))
        try:
            answers = np.asarray(self.function(*self._args(points)))
        except Exception:
            # The same error comes again, from the first scalar call, if it is one of the function.
            return False
        return answers.shape == (TRIAL,)


def _number(answer: Any) -> float:
    """The answer as a double of the same sign; a NaN stays one."""
    if isinstance(answer, float):
        return answer
    value: Any = getattr(answer, "value", answer) if not isinstance(answer, np.generic) else answer
    if isinstance(value, np.ndarray):
        value = value[()]
    if value != value:
        return float("nan")
    return float(bool(value > 0)) - float(bool(value < 0))
