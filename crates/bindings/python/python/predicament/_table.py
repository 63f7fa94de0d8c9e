"""Tables: lists of rows, which a notebook shows and pandas takes."""

from __future__ import annotations

from html import escape
from typing import Any, Dict, Iterable, List

SHOWN = 20


class Table(List[Dict[str, Any]]):
    """A list of rows; a row is a dict with the same keys in each row."""

    def __init__(self, rows: Iterable[dict[str, Any]] = (), columns: Iterable[str] | None = None) -> None:
        super().__init__(rows)
        self._columns = list(columns) if columns is not None else None

    @property
    def columns(self) -> list[str]:
        """The names of the columns, in their order."""
        if self._columns is None:
            return list(dict.fromkeys(key for row in self for key in row))
        return self._columns

    def column(self, name: str) -> list[Any]:
        """The values of one column."""
        return [row[name] for row in self]

    def to_pandas(self) -> Any:
        """The table as a pandas DataFrame. Raises ImportError if pandas is not installed."""
        import pandas

        return pandas.DataFrame.from_records(list(self), columns=self.columns)

    def _repr_html_(self) -> str:
        heads = "".join(f"<th>{escape(name)}</th>" for name in self.columns)
        cells = "".join(
            "<tr>" + "".join(f"<td>{escape(_shown(row.get(name)))}</td>" for name in self.columns) + "</tr>"
            for row in self[:SHOWN]
        )
        more = f"<p>{SHOWN} of {len(self)} rows</p>" if len(self) > SHOWN else ""
        return f"<table><thead><tr>{heads}</tr></thead><tbody>{cells}</tbody></table>{more}"


def _shown(value: Any) -> str:
    return "" if value is None else str(value)
