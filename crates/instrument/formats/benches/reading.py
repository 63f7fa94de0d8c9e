#!/usr/bin/env python3
"""The seconds that shapely and trimesh take to read the files of the bench `reading`: FOLDER is its `READING_KEEP`."""

import pathlib
import statistics
import sys
import time


def median(read, rounds=3):
    """The median time of a function without arguments, in seconds."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        read()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


folder = pathlib.Path(sys.argv[1])
for name in ("shapely", "trimesh"):
    try:
        library = __import__(name)
    except ImportError:
        print(f"{name} is not installed", file=sys.stderr)
        continue
    if name == "shapely":
        text = (folder / "rings.geojson").read_text()
        print(f"shapely, rings.geojson: {median(lambda: library.from_geojson(text)):.3f}")
    else:
        print(f"trimesh, mesh.off: {median(lambda: library.load(folder / 'mesh.off', process=False)):.3f}")
        print(f"trimesh, mesh.stl, points joined: {median(lambda: library.load(folder / 'mesh.stl')):.3f}")
