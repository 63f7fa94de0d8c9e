"""Triangle. Constraints are segments (`p`); `c` keeps the triangles between them and the convex hull. Where Triangle puts a
new vertex on a crossing of segments, the tool sees an index that does not exist.
"""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import predicament_engine
import triangle


def delaunay(points, constraints=None):
    if constraints is None:
        found = triangle.triangulate({"vertices": points})
    else:
        found = triangle.triangulate({"vertices": points, "segments": constraints}, "pc")
    return found.get("triangles", [])


engine = predicament_engine.Engine("triangle", importlib.metadata.version("triangle"), arrays=True)
predicament_engine.serve(engine.task("delaunay2d", delaunay))
