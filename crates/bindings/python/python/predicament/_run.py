"""The tool in this process: runs, tables, gates and reports."""

from __future__ import annotations

import csv
import json
import os
import shutil
import sys
import tempfile
from functools import lru_cache
from html import escape
from pathlib import Path
from typing import Any, NamedTuple, Sequence

from . import _native
from ._table import Table

#: Exit codes of a command that could not do its work.
FAILED = (2, 4, 104)


class Called(NamedTuple):
    """The result of a command: its exit code, and what it wrote."""

    code: int
    out: str
    err: str


class ToolError(RuntimeError):
    """A command could not do its work; ``code`` is its exit code, and the text says why."""

    def __init__(self, code: int, message: str) -> None:
        super().__init__(message)
        self.code = code


def tool(*args: str | os.PathLike[str], check: bool = True) -> Called:
    """Runs a command of the tool in this process: ``tool("corpus", "list")``.

    With ``check`` the exit codes 2, 4 and 104 (bad input, nothing selected, bad corpus) raise ToolError. All others are
    results, such as 100 for an unexpected finding. Ctrl-C stops a run; finished scenes stay in its folder.
    """
    called = Called(*_native.call([os.fspath(arg) for arg in args]))
    if check and called.code in FAILED:
        raise ToolError(called.code, called.err.strip() or called.out.strip())
    return called


class Gate(NamedTuple):
    """The verdict of a gate: ``code`` is 0 if all is as expected, and ``text`` says what is not."""

    code: int
    text: str

    def __bool__(self) -> bool:
        return self.code == 0


class Report:
    """A report of runs: a page that a notebook shows inline."""

    def __init__(self, folder: Path, keep: Any = None) -> None:
        self.folder = folder
        self._keep = keep

    @property
    def path(self) -> Path:
        """The page, one HTML file."""
        return self.folder / "report.html"

    @property
    def html(self) -> str:
        """The text of the page."""
        return self.path.read_text(encoding="utf-8")

    @property
    def markdown(self) -> str:
        """The same report as Markdown."""
        return (self.folder / "report.md").read_text(encoding="utf-8")

    def save(self, folder: str | os.PathLike[str]) -> Path:
        """Copies the report into a folder, and returns the path of the page there."""
        shutil.copytree(self.folder, folder, dirs_exist_ok=True)
        return Path(folder) / "report.html"

    def _repr_html_(self) -> str:
        page = escape(self.html, quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 40em; border: 1px solid #ccc"></iframe>'


class Run:
    """A run folder: of ``run``, or one that the tool has written, ``Run("out/run")``."""

    def __init__(self, folder: str | os.PathLike[str], code: int = 0, text: str = "", keep: Any = None) -> None:
        self.folder = Path(folder)
        if not (self.folder / "plan.json").is_file():
            raise FileNotFoundError(f"{self.folder} is not a folder of a run")
        #: The exit code of the run: 0, 100 (unexpected findings), 101 or 103 (incomplete).
        self.code = code
        #: What the run said.
        self.text = text
        self._keep = keep

    def __repr__(self) -> str:
        return f"<Run {self.folder}: {self.text.strip() or 'read'}>"

    @property
    def tables(self) -> list[str]:
        """The names of the tables of the run."""
        return sorted(path.stem for path in self.folder.glob("*.csv"))

    def table(self, name: str = "summary") -> Table:
        """A table with typed values, such as ``summary``, ``findings`` or ``throughput``; None for an empty cell."""
        path = self.folder / f"{name}.csv"
        if not path.is_file():
            raise ValueError(f"{self.folder} has no table {name!r}; it has {', '.join(self.tables)}")
        types = _types().get(path.name, {})
        with path.open(newline="", encoding="utf-8") as file:
            rows = csv.DictReader(file)
            columns = list(rows.fieldnames or [])
            return Table(
                ({key: _typed(types.get(key, ""), value) for key, value in row.items()} for row in rows), columns
            )

    def gate(self, *args: str, expected: str | os.PathLike[str] | None = None) -> Gate:
        """Holds the run against the expected findings: the embedded ones, or those of a file as well."""
        own = ("--expected", expected) if expected is not None else ()
        called = tool("gate", self.folder, *own, *args)
        return Gate(called.code, called.out + called.err)

    def report(
        self, *others: Run | str | os.PathLike[str], out: str | os.PathLike[str] | None = None, baseline: Any = None
    ) -> Report:
        """Writes a report of this run, and of others beside it, such as one of ``bench``."""
        keep, folder = _folder(out, "predicament-report-")
        folders = [other.folder if isinstance(other, Run) else other for other in others]
        since = baseline.folder if isinstance(baseline, Run) else baseline
        tool("report", self.folder, *folders, *(("--baseline", since) if since else ()), "--out", folder)
        return Report(folder, keep)

    def _repr_html_(self) -> str:
        return f"<p>{escape(self.text)}</p>" + self.table("summary")._repr_html_()


def run(
    *suites: str | os.PathLike[str],
    backends: Sequence[str] = (),
    level: str = "quick",
    filter: str | None = None,
    out: str | os.PathLike[str] | None = None,
    args: Sequence[str] = (),
) -> Run:
    """Runs suites through backends, and judges every answer; all embedded suites and the usual backends by default.

    >>> done = run("classics", backends=["exact", "naive"])
    >>> done.table("summary").to_pandas()
    >>> done.report()

    ``suites`` are names, or paths of TOML files. ``filter`` is a regular expression for ``suite/scene``. ``args`` are
    further options of the command ``run``. Without ``out``, the folder lives as long as the result.
    """
    keep, folder = _folder(out, "predicament-run-")
    words = ["run", *(os.fspath(suite) for suite in suites), "--level", level, "--out", os.fspath(folder)]
    if backends:
        words += ["-b", ",".join([backends] if isinstance(backends, str) else backends)]
    if filter is not None:
        words += ["--filter", filter]
    called = tool(*words, *args)
    return Run(folder, called.code, called.out + called.err, keep)


def _folder(out: Any, prefix: str) -> tuple[Any, Path]:
    if out is not None:
        return None, Path(out)
    if sys.version_info < (3, 10):
        keep = tempfile.TemporaryDirectory(prefix=prefix)
    else:
        keep = tempfile.TemporaryDirectory(prefix=prefix, ignore_cleanup_errors=True)
    return keep, Path(keep.name) / "out"


@lru_cache(maxsize=None)
def _types() -> dict[str, dict[str, str]]:
    """The types of the columns, by file and column."""
    schema = json.loads(tool("data", "schema", "--format", "json").out)
    return {
        table["file"]: {column["name"]: column["type"] for column in table["columns"]} for table in schema["tables"]
    }


def _typed(kind: str, text: str | None) -> Any:
    if not text:
        return None if kind != "text" else ""
    if kind == "int64":
        return int(text)
    if kind == "float64":
        return float(text)
    if kind == "bool":
        return text == "true"
    return text
