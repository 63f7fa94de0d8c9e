"""The pytest plugin."""

import os
import re

import pytest

FILE = """
import predicament
import numpy as np

@predicament.conforms("orient2d", suites=["lecture"])
def right(a, b, c):
    return predicament.orient2d(a, b, c)

@predicament.conforms("orient2d", suites=["lecture"])
def cast(a, b, c):
    return predicament.orient2d(*[np.asarray(point, dtype=np.float32) for point in (a, b, c)])

@predicament.conforms("incircle", suites=["filters"])
def test_made():
    return predicament.incircle

def test_it_stays_a_function():
    assert right((0, 0), (1, 0), (0, 1)) == 1
"""


@pytest.fixture
def run(pytester, request):
    """Runs pytest on a file, with the plugin also where the package is not installed."""
    # The plugin is named as its entry point names it, so that an installed one is not loaded twice.
    manager = request.config.pluginmanager
    is_installed = any(dist.metadata["Name"] == "predicament" for _, dist in manager.list_plugin_distinfo())

    def run(text, *args):
        pytester.makepyfile(test_own=text)
        plugin = [] if is_installed else ["-p", "predicament.pytest_plugin"]
        return pytester.runpytest_subprocess(*plugin, "-p", "no:cacheprovider", *args)

    return run


def test_predicates_are_collected_and_failures_show_the_case(run):
    result = run(FILE, "-v")
    result.assert_outcomes(passed=3, failed=1)
    text = result.stdout.str()
    for part in ["cast as orient2d: ", "shrunk case: ", "truth ", "answer ", "regression test:", "def test_"]:
        assert part in text, text
    assert re.search(r"a = \((-?0x[0-9a-f.p+-]+|0x0p\+0), ", text), text
    result.stdout.fnmatch_lines(["test_own.py::right PASSED*", "test_own.py::cast FAILED*", "test_own.py::test_made PASSED*"])


def test_tests_are_selected_as_others_are(run):
    run(FILE, "-m", "predicament", "-k", "not test_made").assert_outcomes(passed=1, failed=1, deselected=2)
    run(FILE, "--predicament-level", "slow").stderr.fnmatch_lines(["*invalid choice: *slow*"])


def test_marks_and_imports(run):
    text = """
import pytest, predicament
from predicament import orient2d

@pytest.mark.skip(reason="later")
@predicament.conforms("orient2d")
def later(a, b, c):
    raise RuntimeError

@pytest.mark.xfail(reason="naive", strict=True)
@predicament.conforms("orient2d", suites=["lecture"])
def naive(a, b, c):
    return 1.0

@predicament.conforms("orient2d")
def test_none():
    return 7
"""
    result = run(text)
    result.assert_outcomes(skipped=1, xfailed=1, failed=1)
    assert "has to return a predicate" in result.stdout.str()


def test_wrong_decorators_are_errors_of_the_file():
    import predicament

    with pytest.raises(ValueError, match="no predicate is called"):
        predicament.conforms("orient4d")
    with pytest.raises(TypeError, match="unknown options sweets"):
        predicament.conforms("orient2d", sweets=1)


def test_the_environment_has_the_package(pytester):
    """A test of the tests: without the path, the other tests would run another package."""
    import predicament

    result = pytester.runpython_c("import predicament; print(predicament.__file__)")
    assert os.path.samefile(result.outlines[0], predicament.__file__)
