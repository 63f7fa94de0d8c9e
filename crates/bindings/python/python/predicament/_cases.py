"""Cases: queries with the truth about them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._arrays import LETTERS, shape_of
from ._table import Table


@dataclass(frozen=True)
class Cases:
    """Queries of a family, with the exact sign of each."""

    predicate: str
    family: str
    #: Coordinates, of shape (queries, points of a query, coordinates of a point).
    points: npt.NDArray[np.float64]
    #: The exact signs, of int8.
    truth: npt.NDArray[np.int8]

    @property
    def args(self) -> tuple[npt.NDArray[np.float64], ...]:
        """The arguments of the predicate: one array of shape (queries, coordinates) for each point."""
        return tuple(self.points[:, at] for at in range(self.points.shape[1]))

    def __len__(self) -> int:
        return len(self.truth)

    def wrong(self, answers: npt.ArrayLike) -> npt.NDArray[np.intp]:
        """The indices of the queries to which these answers have another sign; a NaN is another sign."""
        answers = np.asarray(answers)
        if answers.shape != self.truth.shape:
            raise ValueError(f"answers of shape {answers.shape} to {len(self)} queries")
        return np.flatnonzero(np.sign(answers) != self.truth)

    def table(self) -> Table:
        """A row for each query: coordinates in hexadecimal, and the truth."""
        def row(at: int) -> dict[str, Any]:
            points = {
                LETTERS[i]: " ".join(float(x).hex() for x in point) for i, point in enumerate(self.points[at])
            }
            return {**points, "truth": int(self.truth[at])}

        return Table(map(row, range(len(self))))

    def to_pandas(self) -> Any:
        """The queries as a pandas DataFrame, a column for each coordinate: ``a0``, ``a1``, ``b0``…"""
        import pandas

        _, arity, width = self.points.shape
        columns = {f"{LETTERS[i]}{k}": self.points[:, i, k] for i in range(arity) for k in range(width)}
        return pandas.DataFrame({**columns, "truth": self.truth})


def cases(predicate: str, family: str = "near", n: int = 1000, seed: int = 1, **keys: Any) -> Cases:
    """Queries of a family with the exact signs. The same arguments give the same bits on every platform.

    >>> near = cases("incircle", family="near", n=1000)
    >>> near.wrong(my_incircle(*near.args))

    ``families(predicate)`` lists the families and their keys, such as ``ulps`` of ``near``.
    """
    arity, width = shape_of(predicate)
    if n < 1:
        raise ValueError(f"cases: n is {n}; at least one query is made")
    lines = "".join(f"{key} = {_toml(value)}\n" for key, value in keys.items())
    points, truth = _native.cases(predicate, family, n, seed, lines)
    return Cases(predicate, family, points.reshape(-1, arity, width), truth)


def families(predicate: str) -> Table:
    """The families of a predicate: name, parameters, and one line about each."""
    shape_of(predicate)
    return Table(_native.families(predicate), ["family", "parameters", "about"])


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        if any(mark in value for mark in '"\\\n\r'):
            raise ValueError(f"{value!r} is not a value of a family's key")
        return f'"{value}"'
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return f'"{float(value).hex()}"'
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    raise TypeError(f"{value!r} is not a value of a family's key")
