"""20,000 queries of geometric predicates with their exact signs; docs/VECTORS.md describes the rows."""

import gzip
import json
from pathlib import Path


def vectors(name="vectors.json.gz"):
    """All rows, as dictionaries."""
    with gzip.open(Path(__file__).with_name(name), "rt") as file:
        return json.load(file)["rows"]


def tasks():
    """Whole scenes of tasks, as dictionaries."""
    return vectors("tasks.json.gz")


def points(row):
    """The arguments of the predicate, as tuples of doubles in order; None if a vertex is constructed."""
    if any(vertex.startswith("c") for vertex in row["vertices"]):
        return None
    return [tuple(float(x) for x in row["decimal"][int(vertex)]) for vertex in row["vertices"]]


def sign(row):
    """The exact sign about the doubles: -1, 0 or 1."""
    return "-0+".index(row["doubles"]) - 1
