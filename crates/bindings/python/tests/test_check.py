"""Functions on the corpora."""

import enum
from fractions import Fraction

import numpy as np
import planted
import pytest

import predicament
from predicament._ask import Asked

pytestmark = pytest.mark.filterwarnings("ignore:(overflow|invalid value|divide by zero):RuntimeWarning")

SUITES = ["decimals", "lecture"]
#: Six queries.
FEW = ["lecture"]


def scalar_orient2d(a, b, c):
    det = (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
    return float(det) if det else 0


@pytest.mark.parametrize("name", ["compare", "orient2d", "orient3d", "incircle", "insphere"])
def test_exact_predicates_have_no_findings(name):
    predicate = (lambda a, b: np.sign(a - b)) if name == "compare" else getattr(predicament, name)
    findings = predicament.check(predicate, name)
    assert findings.ok and findings == [] and findings.total == 0 and findings.queries > 10_000, str(findings)
    assert findings.to_pandas().empty if has_pandas() else True


def has_pandas():
    try:
        import pandas  # noqa: F401
    except ImportError:
        return False
    return True


def test_a_cast_to_single_precision_is_found_and_shrunk():
    findings = predicament.check(planted.cast_orient2d, suites=SUITES)
    assert not findings.ok and findings.total > 0
    row = findings[0]
    assert row["predicate"] == "orient2d" and row["truth"] in (-1, 0, 1) and row["answer"] != row["truth"]
    points = [[float.fromhex(x) for x in point] for point in row["points_hex"]]
    assert points == row["points"] and len(points) == 3
    assert planted.cast_orient2d(*map(np.array, points)) == row["answer"]
    for one in findings:
        if one["check"] == "sign":
            assert predicament.orient2d(*one["points"]) == one["truth"] != one["answer"]
    assert {one["truth"] for one in findings} == {-1, 0, 1}
    (small,) = findings.shrunk
    assert planted.cast_orient2d(*map(np.array, small["points"])) != predicament.orient2d(*small["points"])
    digits = lambda row: sum(len(x) for point in row["points_hex"] for x in point)  # noqa: E731
    assert digits(small) < digits(findings[small["of"]])
    text = str(findings)
    for part in ["cast_orient2d as orient2d: ", "first finding: ", "shrunk case: ", "truth ", "answer ", "def test_"]:
        assert part in text, text
    for x in (x for point in small["points_hex"] for x in point):
        assert x in text


def test_the_regression_test_of_a_finding_runs():
    findings = predicament.check(planted.cast_orient2d, suites=SUITES)
    source = findings.shrunk[0]["python"]
    test = next(line[4:].split("(")[0] for line in source.splitlines() if line.startswith("def test_"))
    for predicate, passes in [(predicament.orient2d, True), (planted.cast_orient2d, False)]:
        scope = {"orient2d": predicate}
        exec(source, scope)
        if passes:
            scope[test]()
        else:
            with pytest.raises(AssertionError):
                scope[test]()


def test_scalar_and_vectorised_functions_get_the_same_findings():
    wrong = [predicament.check(function, "orient2d", suites=SUITES) for function in (scalar_orient2d, planted.naive_orient2d)]
    assert wrong[0].total > 100
    assert [row["query"] for row in wrong[0]] == [row["query"] for row in wrong[1]]
    assert wrong[0].total == wrong[1].total and wrong[0].scenes.column("findings") == wrong[1].scenes.column("findings")


def test_answers_of_any_kind_are_taken():
    class Side(enum.Enum):
        RIGHT, ON, LEFT = -1, 0, 1

    kinds = [
        lambda sign: Side(sign),
        lambda sign: Fraction(sign, 10**400),
        lambda sign: np.int8(sign),
        lambda sign: np.array(sign),
        lambda sign: sign * 5e-324,
        lambda sign: sign * 10**400,
        lambda sign: np.longdouble(sign) * np.longdouble(2) ** -1074,
    ]
    queries = np.array([[(0, 0), (1, 0), (0, 1)], [(0, 0), (0, 1), (1, 0)], [(0, 0), (1, 1), (2, 2)]], dtype=float)
    for kind in kinds:
        asked = Asked(lambda a, b, c: kind(int(predicament.orient2d(a, b, c))), "orient2d", "float64", None)
        assert not asked.is_vectorised and list(np.sign(asked(queries))) == [1, -1, 0]
    assert np.isnan(Asked(lambda a, b, c: np.float32("nan"), "orient2d", "float64", False)(queries)).all()
    objects = lambda a, b, c: np.array([Fraction(int(sign)) for sign in predicament.orient2d(a, b, c)])  # noqa: E731
    asked = Asked(objects, "orient2d", "float64", None)
    assert asked.is_vectorised and list(asked(queries)) == [1, -1, 0]


def test_the_kind_of_function_is_found_out():
    rows = [
        (lambda a, b, c: a[0] * b[1] - a[1] * b[0], False),
        (lambda a, b, c: a[:, 0] * b[:, 1], True),
        (lambda a, b, c: a[..., 0] * b[..., 1], True),
        (lambda a, b, c: np.linalg.det(np.array([a - c, b - c])), False),
        (lambda a, b, c: 1 if a[0] > b[0] else 0, False),
        (lambda a, b, c: [1] * len(a), True),
    ]
    for function, is_vectorised in rows:
        assert Asked(function, "orient2d", "float64", None).is_vectorised is is_vectorised


def test_single_precision_is_judged_about_rounded_points():
    got = []

    def predicate(a, b, c):
        got.append(a.dtype)
        return predicament.orient2d(a, b, c)

    findings = predicament.check(predicate, "orient2d", suites=["families"], dtype="float32")
    assert findings.ok and set(got) == {np.dtype(np.float32)}, str(findings)
    assert any("single precision" in row["skipped"] for row in findings.skipped), "beyond the range of floats"
    naive = predicament.check(planted.naive_orient2d, suites=SUITES, dtype=np.float32)
    assert not naive.ok
    for point in naive.shrunk[0]["points"]:
        assert all(float(np.float32(x)) == x for x in point)


def test_faults_of_functions_are_findings():
    def raising(a, b, c):
        raise RuntimeError("not\nready")

    findings = predicament.check(raising, "orient2d", suites=FEW)
    assert {(row["class"], row["check"]) for row in findings} == {("panic", "exception")}
    assert "not ready" in findings[0]["answer"] and "not ready" in str(findings)

    nan = predicament.check(lambda a, b, c: a[..., 0] * np.nan, "orient2d", suites=FEW)
    assert "nan" in {row["class"] for row in nan}
    short = predicament.check(lambda a, b, c: a[:1, 0], "orient2d", suites=FEW, vectorised=True)
    assert "shape (1,)" in short[0]["answer"]
    nothing = predicament.check(lambda a, b, c: None, "orient2d", suites=FEW)
    assert nothing[0]["check"] == "exception"


def test_predicates_that_break_ties():
    def never_zero(a, b, c):
        sign = predicament.orient2d(a, b, c)
        return np.where(sign == 0, 1, sign)

    told = [predicament.check(never_zero, "orient2d", suites=SUITES, breaks_ties=breaks) for breaks in (False, True)]
    assert "missed_zero" in {row["class"] for row in told[0]}
    assert "missed_zero" not in {row["class"] for row in told[1]} and sum(told[1].scenes.column("tie_broken")) > 0


def test_skipped_scenes_are_counted_and_said():
    findings = predicament.check(predicament.orient2d, suites=["constructed"])
    assert not findings.ok and findings.queries == 0 and len(findings.skipped) == len(findings.scenes) > 0
    assert {row["skipped"] for row in findings.skipped} == {"constructed points have no coordinates"}
    assert "nothing was asked" in str(findings)


def test_what_there_is_not_is_refused():
    for args, keys in [
        ((lambda a: a,), {}),
        ((scalar_orient2d, "orient4d"), {}),
        ((scalar_orient2d,), {"suites": ["no such suite"]}),
        ((scalar_orient2d,), {"level": "slow"}),
        ((scalar_orient2d,), {"dtype": "int32"}),
    ]:
        with pytest.raises(ValueError):
            predicament.check(*args, **keys)


def test_an_interrupt_ends_the_check():
    calls = []

    def predicate(a, b, c):
        calls.append(1)
        if len(calls) > 3:
            raise KeyboardInterrupt
        return predicament.orient2d(a, b, c)

    with pytest.raises(KeyboardInterrupt):
        predicament.check(predicate, "orient2d", vectorised=True)
    assert len(calls) < 10
