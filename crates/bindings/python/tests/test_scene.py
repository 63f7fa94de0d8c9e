"""Scenes: predicates by index, exact and perturbed."""

from itertools import permutations

import exact
import numpy as np
import pytest

import predicament
from predicament import Scene


def test_signs_are_those_of_fractions():
    rng = np.random.default_rng(1)
    for scale in [1.0, 0.1, 1e-200]:
        flat, solid = [rng.integers(0, 4, (60, d)) * scale for d in (2, 3)]
        for name, points in [("orient2d", flat), ("incircle", flat), ("orient3d", solid), ("insphere", solid)]:
            arity = {"orient2d": 3, "orient3d": 4, "incircle": 4, "insphere": 5}[name]
            ids = rng.integers(0, 60, (30, arity))
            signs = getattr(Scene(points), name)(ids)
            assert signs.dtype == np.int8 and list(signs) == [exact.sign(name, points[row]) for row in ids]
            assert (signs == getattr(predicament, name)(*points[ids].swapaxes(0, 1))).all()


def test_planes_and_axes():
    points = np.random.default_rng(2).random((9, 3))
    scene = Scene(points)
    ids = np.random.default_rng(3).integers(0, 9, (50, 3))
    for plane, axes in [("xy", [0, 1]), ("yz", [1, 2]), ("zx", [2, 0])]:
        want = predicament.orient2d(*points[ids][:, :, axes].swapaxes(0, 1))
        assert (scene.orient2d(ids, plane=plane) == want).all()
    for axis in range(3):
        assert (scene.compare(ids[:, :2], axis=axis) == np.sign(points[ids[:, 0], axis] - points[ids[:, 1], axis])).all()
    for wrong in [lambda: scene.orient2d(ids, plane="xz"), lambda: scene.compare(ids[:, :2], axis=3)]:
        with pytest.raises(ValueError):
            wrong()
    with pytest.raises(ValueError, match="the scene is 3D"):
        scene.incircle([[0, 1, 2, 3]])
    with pytest.raises(ValueError, match="no plane yz"):
        Scene(points[:, :2]).orient2d(ids, plane="yz")


def test_perturbed_signs_are_never_zero_and_belong_together():
    scene = Scene(np.zeros((6, 3)))
    assert (scene.orient3d([[0, 1, 2, 3]]) == 0).all()
    rows = [list(row) for row in permutations(range(4))]
    signs = scene.orient3d(rows, sos=True)
    parity = [1 - 2 * (sum(a > b for i, a in enumerate(row) for b in row[i + 1 :]) % 2) for row in rows]
    assert set(np.abs(signs)) == {1} and (signs * parity == signs[0]).all(), "all orders of the points agree"
    assert scene.orient3d([0, 1, 2, 2], sos=True) == 0, "a point that occurs twice"
    perturbed = Scene(np.zeros((6, 3)), sos=True)
    assert (perturbed.orient3d(rows) == signs).all() and (perturbed.orient3d(rows, sos=False) == 0).all()
    points = np.random.default_rng(4).random((20, 2))
    ids = np.random.default_rng(5).integers(0, 20, (100, 4))
    exactly = Scene(points).incircle(ids)
    assert (Scene(points).incircle(ids, sos=True)[exactly != 0] == exactly[exactly != 0]).all()


def test_many_rows_and_shapes():
    points = np.random.default_rng(6).random((500, 2)).astype(np.float32)
    scene = Scene(points)
    ids = np.random.default_rng(7).integers(0, 500, (7, 1000, 3))
    signs = scene.orient2d(ids)
    assert signs.shape == (7, 1000)
    assert (signs == predicament.orient2d(*np.moveaxis(points[ids], 2, 0))).all()
    assert (scene.orient2d(ids.astype(np.uint32)) == signs).all() and (scene.orient2d(ids[:, ::-1])[:, ::-1] == signs).all()
    assert scene.orient2d([]).shape == (0,) and scene.orient2d([0, 1, 2]).shape == ()
    assert (len(scene), scene.dimension, repr(scene)) == (500, 2, "<Scene of 500 points in 2 dimensions>")


def test_other_arguments_are_refused():
    with pytest.raises(ValueError, match=r"^Scene: points\[2\]: coordinate 1 is nan; coordinates must be finite$"):
        Scene([(0, 0), (1, 1), (2, np.nan)])
    for points in [np.zeros(4), np.zeros((3, 4)), np.zeros((2, 2, 2))]:
        with pytest.raises(ValueError, match="Scene: points have shape"):
            Scene(points)
    scene = Scene(np.zeros((5, 2)))
    ids = np.zeros((3000, 3), dtype=np.int64)
    for wrong in [5, -1, 2**62]:
        ids[2900, 1] = wrong
        with pytest.raises(IndexError, match=rf"^orient2d: ids\[2900\]: there is no point {wrong}; the scene has 5$"):
            scene.orient2d(ids)
    with pytest.raises(IndexError):
        scene.orient2d(np.full((1, 3), 2**64 - 1, dtype=np.uint64))
    with pytest.raises(TypeError, match="indices are integers"):
        scene.orient2d([[0.0, 1.0, 2.0]])
    with pytest.raises(ValueError, match="the last axis has 3 points"):
        scene.orient2d([[0, 1, 2, 3]])
