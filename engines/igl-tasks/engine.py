"""libigl: convex hulls, Delaunay triangulations and Boolean operations on CGAL's exact numbers, and winding numbers in
doubles, of which the nearest whole number counts.
"""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import igl
import igl.copyleft.cgal
import predicament_engine

OPERATIONS = {"union": "union", "intersection": "intersect", "difference": "minus", "symmetric-difference": "xor"}


def boolean(first, second):
    def mesh(operation):
        vertices, triangles, _ = igl.copyleft.cgal.mesh_boolean(*first, *second, type_str=operation)
        return vertices, triangles

    return {name: mesh(operation) for name, operation in OPERATIONS.items()}


def locate(vertices, triangles, probes):
    return igl.winding_number(vertices, triangles, probes) > 0.5


engine = predicament_engine.Engine("igl-tasks", importlib.metadata.version("libigl"), arrays=True)
engine.task("delaunay2d", lambda points: igl.copyleft.cgal.delaunay_triangulation(points))
engine.task("hull3d", lambda points: igl.copyleft.cgal.convex_hull(points))
engine.task("mesh-locate", locate)
engine.task("mesh-intersect", boolean)
predicament_engine.serve(engine)
