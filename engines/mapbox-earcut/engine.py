"""Mapbox's earcut in C++. It wants an outer ring and then holes: the outer ring's bounding box has all others in it. Other
nests of rings, such as islands in holes, are declined.
"""

import importlib.metadata
import itertools
import sys

sys.path.insert(0, "../python")

import mapbox_earcut
import numpy
import predicament_engine


def extent(ring):
    """The low corner of the bounding box, then the high one with its sign changed."""
    return (*ring.min(axis=0), *-ring.max(axis=0))


def triangulate(points, rings):
    rings = sorted(rings, key=lambda ring: extent(points[ring]))
    boxes = [numpy.array(extent(points[ring])) for ring in rings]
    nested = {(i, j) for (i, a), (j, b) in itertools.permutations(enumerate(boxes), 2) if (a <= b).all()}
    if not nested >= {(0, j) for j in range(1, len(rings))} or any(i for i, _ in nested):
        raise predicament_engine.Declined("the rings are not an outer ring with holes")
    corners = numpy.concatenate([numpy.array(ring) for ring in rings])
    ends = numpy.array(list(itertools.accumulate(map(len, rings))), dtype="u4")
    return corners[mapbox_earcut.triangulate_float64(points[corners], ends)]


engine = predicament_engine.Engine("mapbox-earcut", importlib.metadata.version("mapbox-earcut"), arrays=True)
predicament_engine.serve(engine.task("triangulate", triangulate))
