"""A function on the embedded corpora: what it answers wrongly."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Callable, Sequence

from . import _native
from ._arrays import LETTERS, exact_value, shape_of
from ._ask import Asked
from ._table import Table

SIGNS = {"-": -1, "0": 0, "+": 1}
COLUMNS = [
    "predicate", "suite", "scene", "family", "class", "check", "query", "points", "points_hex", "answer", "truth",
    "log2_relative_det",
]


class Findings(Table):
    """The findings about a function: a row for each of the first 25 of a class in a scene, with the points.

    ``points`` are the coordinates that the function got, ``points_hex`` the same in hexadecimal; ``answer`` and
    ``truth`` are signs. A finding about several queries, such as answers that contradict each other, has the points of
    all of them.
    """

    predicate: str
    function: str
    #: A row for each scene: queries, findings, counts by class, and the reason if the scene was skipped.
    scenes: Table
    #: The smallest cases that show the first findings, with a regression test each.
    shrunk: Table

    @property
    def ok(self) -> bool:
        """True if the function was asked, and there are no findings."""
        return not self and self.queries > 0

    @property
    def queries(self) -> int:
        """The number of queries that were asked once each."""
        return sum(self.scenes.column("queries"))

    @property
    def total(self) -> int:
        """The number of all findings, also of those without a row."""
        return sum(self.scenes.column("findings"))

    @property
    def skipped(self) -> Table:
        """The scenes that were not asked about, with the reasons."""
        return Table([row for row in self.scenes if row["skipped"]], ["suite", "scene", "skipped"])

    def __str__(self) -> str:
        return report(self)

    def __repr__(self) -> str:
        return f"<Findings about {self.function}: {self.total} in {self.queries} queries>"


def check(
    function: Callable[..., Any],
    predicate: str | None = None,
    *,
    level: str = "quick",
    suites: Sequence[str] = (),
    dtype: Any = "float64",
    vectorised: bool | None = None,
    breaks_ties: bool = False,
    shrink: int = 1,
) -> Findings:
    """Runs a predicate on the embedded corpora, judges each answer exactly, and returns the findings as a table.

    >>> findings = check(my_orient2d)
    >>> print(findings)                # a report with the shrunk case and a regression test
    >>> findings.to_pandas()           # the rows

    ``predicate`` is orient2d, orient3d, incircle, insphere or compare; by default the one in the function's name. The
    function takes the points of one query, or arrays of points; it returns signs, or any numbers of the same sign.
    ``dtype="float32"`` rounds all scenes to single precision first, and judges answers about the rounded points.
    ``breaks_ties`` is for predicates that never answer zero. ``shrink`` is the number of findings to shrink.

    An exception in the function is a finding. Raises ValueError if a suite or a predicate is unknown.
    """
    name = getattr(function, "__name__", type(function).__name__)
    predicate = predicate or _named_in(name)
    asked = Asked(function, predicate, dtype, vectorised)
    done = _native.check(
        predicate, asked, name, level, list(suites), asked.dtype.itemsize == 4, breaks_ties, shrink
    )
    findings = Findings(map(_signed, done["findings"]), COLUMNS)
    findings.predicate, findings.function = predicate, name
    findings.scenes = Table(done["scenes"])
    findings.shrunk = Table(map(_signed, done["shrunk"]), [*COLUMNS, "of", "evaluations", "python", "toml"])
    return findings


def _named_in(name: str) -> str:
    found = [predicate for predicate in _native.KINDS if predicate in name.lower().replace("_", "")]
    if len(found) != 1:
        names = ", ".join(_native.KINDS)
        raise ValueError(f"{name!r} does not say which predicate it is; give predicate= one of {names}")
    return found[0]


def _signed(row: dict[str, Any]) -> dict[str, Any]:
    return {**row, **{key: SIGNS.get(row[key], row[key]) for key in ("answer", "truth")}}


def report(findings: Findings) -> str:
    """The findings as text: how many, the first one, its shrunk case, and a regression test."""
    wrong = sum(1 for row in findings.scenes if row["findings"])
    head = (
        f"{findings.function} as {findings.predicate}: {findings.total:,} findings in {findings.queries:,} queries; "
        f"{wrong} of {len(findings.scenes) - len(findings.skipped)} scenes"
    )
    if findings.skipped:
        head += f", {len(findings.skipped)} skipped"
    if not findings:
        return head if findings.queries else head + "\nnothing was asked, so that nothing is known"
    lines = [head, "", f"first finding: {_title(findings[0])}", *points(findings[0])]
    for small in findings.shrunk:
        lines += ["", f"shrunk case: {_title(small)}", *points(small), "", "regression test:", small["python"].rstrip()]
    return "\n".join(lines)


def _title(row: dict[str, Any]) -> str:
    return f"{row['class']} ({row['check']}) in {row['suite']}/{row['scene']}: {row['query']}"


def points(row: dict[str, Any]) -> list[str]:
    """The points of a finding in hexadecimal, the truth and the answer, a line each."""
    arity, _ = shape_of(row["predicate"])
    lines = []
    for at, (point, hexes) in enumerate(zip(row["points"], row["points_hex"])):
        numbers = ", ".join(f"{x!r}" for x in point)
        lines.append(f"  {LETTERS[at % arity]} = ({', '.join(hexes)})  # ({numbers})")
    value = f"  exact value {_short(_value(row))}" if len(row["points"]) == arity else ""
    return [*lines, f"  truth  {_sign(row['truth'])}{value}", f"  answer {_sign(row['answer'])}"]


def _value(row: dict[str, Any]) -> Fraction:
    return exact_value(row["predicate"], *row["points"])


def _short(value: Fraction) -> str:
    try:
        number = float(value)
    except OverflowError:
        number = float("inf")
    return f"{number:.6g}" if number == value == 0 or 1e-300 < abs(number) < 1e300 else (
        f"{'-' if value < 0 else ''}2^{_exponent(abs(value))} or so"
    )


def _exponent(value: Fraction) -> int:
    return value.numerator.bit_length() - value.denominator.bit_length()


def _sign(value: Any) -> str:
    return f"{value:+d}" if isinstance(value, int) and value else str(value)
