"""Predicates on arrays, against fractions."""

import threading
from fractions import Fraction

import exact
import numpy as np
import pytest

import predicament
from predicament import _native

KINDS = list(_native.KINDS.items())
PREDICATES = {name: getattr(predicament, name) for name, _ in KINDS}


def points(name, n, seed, scale=1.0):
    arity, width = _native.KINDS[name]
    rng = np.random.default_rng(seed)
    # Few values, so that a third of the answers are ties.
    grid = rng.integers(0, 4, (arity, n, width)) * scale
    return list(grid.astype(np.float64))


@pytest.mark.parametrize("name", PREDICATES)
def test_signs_are_those_of_fractions(name):
    for seed, scale in [(1, 1.0), (2, 0.1), (3, 1e-200), (4, 1e200), (5, 5e-324)]:
        arrays = points(name, 40, seed, scale)
        with np.errstate(all="ignore"):
            signs = PREDICATES[name](*arrays)
        assert signs.dtype == np.int8 and signs.shape == (40,)
        assert list(signs) == [exact.sign(name, query) for query in zip(*arrays)], (name, scale)
    assert {-1, 0, 1} == set(signs.tolist())


@pytest.mark.parametrize("name", PREDICATES)
def test_single_precision_is_exact_when_widened(name):
    arrays = [array.astype(np.float32) for array in points(name, 300, 7, 0.1)]
    signs = PREDICATES[name](*arrays)
    assert (signs == PREDICATES[name](*[array.astype(np.float64) for array in arrays])).all()
    mixed = [array if at else array.astype(np.float64) for at, array in enumerate(arrays)]
    assert (PREDICATES[name](*mixed) == signs).all()


def test_the_convention():
    assert predicament.orient2d((0, 0), (1, 0), (0, 1)) == 1
    assert predicament.orient3d((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, -1)) == 1
    assert predicament.incircle((1, 0), (0, 1), (-1, 0), (0, 0)) == 1
    tetrahedron = (0, 0, 1), (1, 0, 1), (0, 1, 1), (0, 0, 0)
    assert predicament.orient3d(*tetrahedron) == 1 and predicament.insphere(*tetrahedron, (0.1, 0.1, 0.9)) == 1
    assert predicament.compare((0, 5), (1, 4)) == -1 and predicament.compare((0, 5), (1, 4), axis=1) == 1
    assert isinstance(predicament.orient2d((0, 0), (1, 0), (0, 1)), np.int8)


def test_leading_axes_broadcast():
    rng = np.random.default_rng(3)
    a, b, c = rng.random((5, 1, 2)), rng.random((700, 2)), rng.random(2)
    signs = predicament.orient2d(a, b, c)
    assert signs.shape == (5, 700)
    flat = predicament.orient2d(np.repeat(a, 700, axis=1).reshape(-1, 2), np.tile(b, (5, 1)), np.tile(c, (3500, 1)))
    assert (signs.reshape(-1) == flat).all()
    assert (predicament.orient2d(c, b, a) == -signs).all()
    assert predicament.orient2d(np.zeros((0, 2)), (1, 0), (0, 1)).shape == (0,)
    assert predicament.orient2d(np.zeros((3, 0, 2)), (1, 0), (0, 1)).shape == (3, 0)


def test_strides_and_byte_orders_are_taken_as_they_are():
    wide = np.random.default_rng(4).random((3, 100, 4))
    a, b, c = wide[:, ::-2, 1:3]
    want = [exact.sign("orient2d", query) for query in zip(a, b, c)]
    assert list(predicament.orient2d(a, b, c)) == want
    assert list(predicament.orient2d(a.astype(">f8"), np.asfortranarray(b), c.tolist())) == want
    frozen = a.copy()
    frozen.flags.writeable = False
    assert list(predicament.orient2d(frozen, b, c)) == want


def test_integers_are_exact_or_refused():
    big = 2**53
    assert predicament.orient2d((0, 0), (big, big), (big - 1, big)) == 1
    assert predicament.orient2d(np.array([0, 0], dtype=np.int32), (2, 2), np.array([1, 1], dtype=np.uint8)) == 0
    for wrong in [big + 1, -big - 1, 2**63 - 1]:
        with pytest.raises(ValueError, match=rf"orient2d: b\[1\] is {wrong}, which is not a double"):
            predicament.orient2d((0, 0), (0, wrong), (1, 1))
    with pytest.raises(ValueError, match="not a double"):
        predicament.compare(np.array([2**64 - 1], dtype=np.uint64), (0,))
    if np.dtype(np.longdouble).itemsize > 8:
        with pytest.raises(ValueError, match="not a double"):
            predicament.compare(np.array([1 + np.longdouble(2) ** -60]), (0,))


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_the_row_of_a_coordinate_that_is_not_finite_is_named(bad, dtype):
    arrays = [np.zeros((1000, 2), dtype) for _ in range(3)]
    arrays[1][777, 1] = bad
    with pytest.raises(ValueError, match=rf"^orient2d: b\[777\]: coordinate 1 is {bad}; coordinates must be finite$"):
        predicament.orient2d(*arrays)
    with pytest.raises(ValueError, match=r"^orient2d: b\[3, 177\]: coordinate 1"):
        predicament.orient2d(*[array.reshape(5, 200, 2) for array in arrays])
    with pytest.raises(ValueError, match=r"^orient2d: c: coordinate 0"):
        predicament.orient2d(arrays[0], arrays[2], (bad, 0))
    with pytest.raises(ValueError, match=r"^orient2d: c\[0, 0\]: coordinate 0"):
        predicament.orient2d(arrays[0], arrays[2], [[(bad, 0)]])
    with pytest.raises(ValueError, match=r"^compare: b\[777\]: coordinate 0 is"):
        predicament.compare(arrays[0], arrays[1], axis=1)


@pytest.mark.parametrize(
    "args, error, message",
    [
        (((0, 0), (1, 0), (0, 1, 2)), ValueError, r"c has shape \(3,\)"),
        ((0.5, (1, 0), (0, 1)), ValueError, r"a has shape \(\)"),
        ((np.zeros((3, 2)), np.zeros((4, 2)), (0, 1)), ValueError, "do not broadcast: a .*, b .*, c"),
        (((0, 0), (1, 0), ("0", "1")), TypeError, "numbers of a fixed size"),
        (((0, 0), (1, 0), (0, 2**70)), TypeError, "numbers of a fixed size"),
        (((0, 0), (1j, 0), (0, 1)), TypeError, "numbers of a fixed size"),
    ],
)
def test_other_arguments_are_refused(args, error, message):
    with pytest.raises(error, match=message):
        predicament.orient2d(*args)


def test_exact_values_are_fractions():
    for name, (arity, width) in KINDS:
        for query in np.random.default_rng(9).random((20, arity, width)):
            assert predicament.exact_value(name, *query) == exact.value(name, query)
    tiny = predicament.exact_value("orient2d", (0, 0), (1e-300, 0), (0, 5e-324))
    assert isinstance(tiny, Fraction) and tiny == Fraction(1e-300) * Fraction(5e-324) and float(tiny) == 0
    assert predicament.exact_value("compare", (1, 5), (0, 7), axis=1) == -2
    for args, error in [
        (("orient4d", (0, 0)), ValueError),
        (("orient2d", (0, 0)), TypeError),
        (("orient2d", (0, 0), (1, 0), (np.nan, 0)), ValueError),
        (("orient2d", (0, 0), (1, 0), np.zeros((3, 2))), ValueError),
    ]:
        with pytest.raises(error):
            predicament.exact_value(*args)


def test_the_lock_is_released():
    """Another thread makes progress while a call is running."""
    arrays = [np.zeros((600_000, 3)) for _ in range(5)]
    counted, ended = [0], threading.Event()

    def count():
        while not ended.is_set():
            counted[0] += 1

    thread = threading.Thread(target=count)
    thread.start()
    before = counted[0]
    _native.signs("insphere", arrays, len(arrays[0]))
    after = counted[0]
    ended.set()
    thread.join()
    assert after > before + 1000
