"""Cases with the truth."""

import exact
import numpy as np
import pytest

import predicament
from predicament import _native


@pytest.mark.parametrize("name", _native.KINDS)
def test_every_family_has_the_truth(name):
    arity, width = _native.KINDS[name]
    families = predicament.families(name)
    assert len(families) > 5 and families.columns == ["family", "parameters", "about"]
    for family in families.column("family"):
        keys = {"p": [0.5, 0.5], "q": [12, 12], "r": [24, 24], "side": 4} if family == "pixel-map" else {}
        cases = predicament.cases(name, family=family, n=16, **keys)
        assert cases.points.shape == (16, arity, width) and cases.truth.dtype == np.int8 and len(cases) == 16
        assert [exact.sign(name, query) for query in cases.points] == list(cases.truth), family
        args = [points[:, 0] for points in cases.args] if name == "compare" else cases.args
        if name != "compare":
            assert len(cases.wrong(getattr(predicament, name)(*args))) == 0


def test_seeds_and_keys():
    near = predicament.cases("orient2d", family="near", n=50)
    assert (near.points == predicament.cases("orient2d", family="near", n=50).points).all()
    assert (near.points != predicament.cases("orient2d", family="near", n=50, seed=2).points).any()
    assert (near.points != predicament.cases("orient2d", family="near", n=50, ulps=64).points).any()
    assert set(predicament.cases("orient2d", family="degen", n=50).truth) == {0}


def test_wrong_answers_are_found():
    near = predicament.cases("orient2d", family="near", n=400)
    a, b, c = near.args
    naive = np.linalg.det(np.stack([a - c, b - c], axis=1))
    wrong = near.wrong(naive)
    assert 0 < len(wrong) < 400
    assert near.wrong(near.truth).size == 0 and list(near.wrong(-near.truth)) == list(np.flatnonzero(near.truth))
    answers = near.truth.astype(float)
    answers[7] = np.nan
    assert list(near.wrong(answers)) == [7]
    with pytest.raises(ValueError):
        near.wrong(near.truth[1:])
    row = near.table()[3]
    assert list(row) == ["a", "b", "c", "truth"]
    assert [float.fromhex(x) for x in row["b"].split()] == list(b[3]) and row["truth"] == near.truth[3]


def test_what_there_is_not_is_refused():
    for args, message in [
        (("orient4d",), "predicates are compare, orient2d"),
        (("orient2d", "nearby"), "its families are uniform, "),
        (("orient2d", "ssi-near"), "no family .ssi-near. of points with coordinates"),
        (("orient2d", "near", 0), "at least one query"),
    ]:
        with pytest.raises(ValueError, match=message):
            predicament.cases(*args)
    with pytest.raises(ValueError, match="ulp"):
        predicament.cases("orient2d", "near", ulp=3)
    with pytest.raises(ValueError):
        predicament.cases("orient2d", "near", ulps='2"\nn = 7')
    with pytest.raises(TypeError):
        predicament.cases("orient2d", "near", ulps=None)
