"""Properties of any finite coordinates, by hypothesis: signs and values against fractions."""

import exact
import numpy as np
import pytest

import predicament
from predicament import _native

hypothesis = pytest.importorskip("hypothesis")
from hypothesis import strategies as st  # noqa: E402

DOUBLES = st.floats(allow_nan=False, allow_infinity=False)
#: Any doubles, and few nearby ones, so that ties and near ties are frequent.
NUMBERS = st.one_of(DOUBLES, st.sampled_from([0.0, -0.0, 0.1, 0.2, 0.3, 0.30000000000000004, 1.0, 5e-324]))


@pytest.mark.parametrize("name", _native.KINDS)
@hypothesis.settings(max_examples=60, deadline=None, database=None)
@hypothesis.given(data=st.data())
def test_signs_and_values_are_those_of_fractions(name, data):
    arity, width = _native.KINDS[name]
    query = data.draw(st.lists(st.tuples(*[NUMBERS] * width), min_size=arity, max_size=arity))
    want = exact.sign(name, query)
    assert getattr(predicament, name)(*query) == want
    assert predicament.exact_value(name, *query) == exact.value(name, query)
    if name != "compare":
        ids = np.arange(arity)
        scene = predicament.Scene(query)
        assert getattr(scene, name)(ids) == want
        perturbed = getattr(scene, name)(ids, sos=True)
        assert perturbed == want if want else perturbed != 0


@hypothesis.settings(max_examples=60, deadline=None, database=None)
@hypothesis.given(st.lists(st.floats(width=32, allow_nan=False, allow_infinity=False), min_size=8, max_size=8))
def test_single_precision_is_exact(numbers):
    query = np.array(numbers, dtype=np.float32).reshape(4, 2)
    assert predicament.incircle(*query) == exact.sign("incircle", query)
