"""The pytest plugin: it collects predicates with ``predicament.conforms`` as tests.

It is found by its entry point, and imports NumPy only if a file has such a predicate.
"""

from __future__ import annotations

from typing import Any

import pytest

MARK = "__predicament__"


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("predicament")
    group.addoption(
        "--predicament-level", choices=("quick", "full"), default="quick", metavar="quick|full",
        help="the amount of work of @predicament.conforms: quick takes seconds (default)",
    )


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line("markers", "predicament: a predicate on the corpora (predicament.conforms)")


def pytest_pycollect_makeitem(collector: Any, name: str, obj: Any) -> Any:
    conformance = getattr(obj, MARK, None)
    # An imported predicate is the test of the file that it is in.
    if conformance is None or getattr(obj, "__module__", None) != collector.obj.__name__:
        return None
    return ConformanceItem.from_parent(collector, name=name, conformance=conformance)


class ConformanceItem(pytest.Item):
    """The test of a predicate."""

    def __init__(self, *, conformance: Any, **rest: Any) -> None:
        super().__init__(**rest)
        self.conformance = conformance
        self.add_marker("predicament")
        for mark in getattr(conformance.function, "pytestmark", []):
            self.own_markers.append(mark)
            self.keywords[mark.name] = mark

    def runtest(self) -> None:
        findings = self.conformance.run(level=self.config.getoption("--predicament-level"))
        self.add_report_section("call", "predicament", str(findings))

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        from ._conforms import NonConformity

        if isinstance(excinfo.value, NonConformity):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Any, int, str]:
        code = getattr(self.conformance.function, "__code__", None)
        return self.path, code.co_firstlineno - 1 if code else 0, f"{self.name} conforms to {self.conformance.predicate}"

