"""Scenes: predicates on points by index."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from ._arrays import coordinates


class Scene:
    """Points that are prepared once and asked about by their indices.

    Queries are rows of indices: ``scene.orient3d([[0, 1, 2, 3]])``. All leading axes are kept, and the result has a
    sign of int8 for each row. Batches use vector instructions.

    With ``sos=True`` answers are signs of a perturbed scene (Simulation of Simplicity), in which every point has moved
    by its own infinitesimal: a sign is zero only if an index occurs twice in a row, and all answers about a scene
    belong together. The method's argument ``sos`` overrides the scene's.
    """

    def __init__(self, points: npt.ArrayLike, sos: bool = False) -> None:
        array = np.asarray(points)
        if array.ndim != 2 or array.shape[1] not in (2, 3):
            raise ValueError(f"Scene: points have shape (n, 2) or (n, 3), not {array.shape}")
        array = coordinates("Scene", "points", array, array.shape[1])
        try:
            self._scene = _native.Scene(np.ascontiguousarray(array, dtype=np.float64))
        except ValueError as error:
            raise _named(error, "points", "Scene") from None
        self.sos = sos

    def __len__(self) -> int:
        return len(self._scene)

    def __repr__(self) -> str:
        return f"<Scene of {len(self)} points in {self.dimension} dimensions>"

    @property
    def dimension(self) -> int:
        """The number of coordinates of a point: 2 or 3."""
        return self._scene.dimension

    def compare(self, ids: npt.ArrayLike, axis: int = 0, sos: bool | None = None) -> Any:
        """The order of two points along an axis, for each row of two indices."""
        return self._signs("compare", ids, sos, axis=axis)

    def orient2d(self, ids: npt.ArrayLike, plane: str = "xy", sos: bool | None = None) -> Any:
        """The turn of three points in the plane xy, yz or zx, for each row of three indices."""
        return self._signs("orient2d", ids, sos, plane=plane)

    def orient3d(self, ids: npt.ArrayLike, sos: bool | None = None) -> Any:
        """The side of the plane of three points on which a fourth is, for each row of four indices."""
        return self._signs("orient3d", ids, sos)

    def incircle(self, ids: npt.ArrayLike, sos: bool | None = None) -> Any:
        """The circle test, for each row of four indices into points of the plane."""
        return self._signs("incircle", ids, sos)

    def insphere(self, ids: npt.ArrayLike, sos: bool | None = None) -> Any:
        """The sphere test, for each row of five indices into points in space."""
        return self._signs("insphere", ids, sos)

    def _signs(self, predicate: str, ids: npt.ArrayLike, sos: bool | None, axis: int = 0, plane: str = "xy") -> Any:
        arity = _native.KINDS[predicate][0]
        array = np.asarray(ids)
        if array.size == 0 and array.dtype.kind == "f":
            array = array.astype(np.int64)
        if array.dtype.kind not in "iu":
            raise TypeError(f"{predicate}: indices are integers, not of type {array.dtype}")
        if array.ndim == 0 or (array.shape[-1] != arity and array.size):
            raise ValueError(f"{predicate}: indices have shape {array.shape}; the last axis has {arity} points")
        if array.dtype.kind == "u" and array.size and int(array.max()) >= 1 << 63:
            raise IndexError(f"{predicate}: there is no point {array.max()}")
        rows = np.ascontiguousarray(array, dtype=np.int64).reshape(-1, arity)
        sos = self.sos if sos is None else sos
        try:
            signs = self._scene.signs(predicate, rows, bool(sos), axis, plane)
        except (IndexError, ValueError) as error:
            raise _named(error, "ids", predicate) from None
        return signs.reshape(array.shape[:-1] if array.size else (0,))[()]


def _named(error: Exception, what: str, name: str) -> Exception:
    if len(error.args) != 3:
        return error
    message, _, row = error.args
    return type(error)(f"{name}: {what}[{row}]: {message.split(': ', 1)[1]}")
