"""A million queries from Python beside the same work in Rust alone, in one process: seconds and their ratio.

    python bench/overhead.py [QUERIES]

Each figure is the least of several rounds, and the rounds of both sides alternate. The first table is about arrays:
the Rust side is a loop over the same rows. The second is about scenes: the Rust side is a batch of a session that is
prepared already, about vertices that are made already, in 100,000 points; the Python side takes indices of int64.
"""

import sys
import time

import numpy as np

import predicament
from predicament import _native

ROUNDS = 9
PREDICATES = ["orient2d", "orient3d", "incircle", "insphere"]


def best(*works):
    """The least seconds of each work, in alternating rounds. A work returns its seconds, or None to be timed here."""
    least = [float("inf")] * len(works)
    for _ in range(ROUNDS):
        for at, work in enumerate(works):
            start = time.perf_counter()
            seconds = work()
            least[at] = min(least[at], time.perf_counter() - start if seconds is None else seconds)
    return least


def row(name, what, python, rust, count):
    print(f"| `{name}` | {what} | {1e9 * python / count:.1f} | {1e9 * rust / count:.1f} | {python / rust:.2f} |", flush=True)


def arrays(count):
    for name in PREDICATES:
        for family in ("uniform", "near"):
            cases = predicament.cases(name, family=family, n=count)
            args = [np.ascontiguousarray(points) for points in cases.args]
            function = getattr(predicament, name)
            assert (function(*args) == cases.truth).all()
            python, rust = best(lambda: void(function(*args)), lambda: _native.seconds_of_loop(name, args))
            row(name, family, python, rust, count)
        single = [points.astype(np.float32) for points in args]
        python, rust = best(lambda: void(function(*single)), lambda: _native.seconds_of_loop(name, args))
        row(name, "near, float32 against float64 in Rust", python, rust, count)


def scenes(count):
    rng = np.random.default_rng(1)
    for name in PREDICATES:
        arity, width = _native.KINDS[name]
        points = rng.random((100_000, width))
        ids = rng.integers(0, len(points), (count, arity))
        scene = predicament.Scene(points)
        function = getattr(scene, name)
        function(ids[:10])
        python, rust = best(lambda: void(function(ids)), lambda: _native.seconds_of_batch(name, points, ids))
        row(name, "100,000 uniform points", python, rust, count)


def void(_):
    return None


if __name__ == "__main__":
    COUNT = int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000
    for title, table in [("arrays", arrays), ("scenes", scenes)]:
        print(f"\n| {title} | points | Python, ns a query | Rust, ns a query | ratio |\n|---|---|---:|---:|---:|")
        table(COUNT)
