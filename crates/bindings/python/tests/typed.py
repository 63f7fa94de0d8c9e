"""A program of a user, for type checkers: `cargo xtask wheel` runs mypy in strict mode on it."""

from fractions import Fraction
from typing import Sequence

import numpy as np
import numpy.typing as npt

import predicament


def turn(a: Sequence[float], b: Sequence[float], c: Sequence[float]) -> float:
    return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])


@predicament.conforms("orient2d")
def mine(a: Sequence[float], b: Sequence[float], c: Sequence[float]) -> float:
    return turn(a, b, c)


def signs() -> npt.NDArray[np.int8]:
    points = np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    scene = predicament.Scene(points)
    ids = np.array([[0, 1, 2], [2, 1, 0]], dtype=np.uint32)
    in_scene: npt.NDArray[np.int8] = scene.orient2d(ids)
    alone: npt.NDArray[np.int8] = predicament.orient2d(points[0], points[1], points[1:])
    return np.concatenate([in_scene, alone])


def value() -> Fraction:
    return predicament.exact_value("orient2d", [0.0, 0.0], [1.0, 0.0], [0.0, 1.0])


def names() -> list[str]:
    findings = predicament.check(turn, "orient2d")
    cases: predicament.Cases = predicament.cases("incircle", family="near", n=10)
    return [*findings.columns, str(cases.points.shape), str(cases.truth.dtype)]


def answer() -> float:
    return mine([0.0, 0.0], [1.0, 0.0], [0.0, 1.0])


def run(folder: str) -> predicament.Table:
    done: predicament.Run = predicament.run("classics", backends=["exact"], out=folder)
    return done.table("summary")
