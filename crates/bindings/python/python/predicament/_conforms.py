"""Conformance tests: a decorator, which the pytest plugin turns into a test."""

from __future__ import annotations

import inspect
from typing import Any, Callable, TypeVar

from ._arrays import shape_of
from ._check import Findings, check

MARK = "__predicament__"

F = TypeVar("F", bound=Callable[..., Any])


class NonConformity(AssertionError):
    """A predicate has findings; ``findings`` has all of them, and the text shows the shrunk case."""

    def __init__(self, findings: Findings) -> None:
        super().__init__(str(findings))
        self.findings = findings


class Conformance:
    """A predicate to be tested, and how."""

    def __init__(self, predicate: str, function: Callable[..., Any], options: dict[str, Any]) -> None:
        self.predicate = predicate
        self.function = function
        self.options = options

    def run(self, **defaults: Any) -> Findings:
        """Runs the test; the decorator's options come before these. Raises NonConformity if there are findings."""
        function = self.function
        if _takes_nothing(function):
            function = function()
            if not callable(function):
                raise TypeError(f"{self.function.__name__} takes no argument, so that it has to return a predicate")
        findings = check(function, self.predicate, **{**defaults, **self.options})
        if not findings.ok:
            raise NonConformity(findings)
        return findings


def conforms(predicate: str, **options: Any) -> Callable[[F], F]:
    """Makes a test of a predicate in a test file: the pytest plugin runs it on the corpora.

    >>> @predicament.conforms("orient2d")
    ... def my_orient2d(a, b, c):
    ...     return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])

    The function is the predicate, or takes no arguments and returns the predicate. Any name will do. The options are
    those of ``check``. A failure shows the points in hexadecimal, the truth, the answer and the shrunk case. The
    function itself stays as it is.
    """
    shape_of(predicate)
    unknown = set(options) - set(inspect.signature(check).parameters) | {"function", "predicate"} & set(options)
    if unknown:
        raise TypeError(f"conforms: unknown options {', '.join(sorted(unknown))}; they are those of check")

    def mark(function: F) -> F:
        setattr(function, MARK, Conformance(predicate, function, options))
        return function

    return mark


def _takes_nothing(function: Callable[..., Any]) -> bool:
    try:
        return not inspect.signature(function).parameters
    except ValueError:
        return False
