"""libigl: convex hulls, Delaunay triangulations and Boolean operations on CGAL's exact numbers, and winding numbers in
doubles, of which the nearest whole number counts.
"""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import igl
import igl.copyleft.cgal
import numpy
import predicament_engine

OPERATIONS = {"union": "union", "intersection": "intersect", "difference": "minus", "symmetric-difference": "xor"}


def boolean(first, second):
    def mesh(operation):
        vertices, triangles, _ = igl.copyleft.cgal.mesh_boolean(*first, *second, type_str=operation)
        return vertices, triangles

    return {name: mesh(operation) for name, operation in OPERATIONS.items()}


def locate(vertices, triangles, probes):
    return igl.winding_number(vertices, triangles, probes) > 0.5


def contacts(points, a, b):
    if any(len(simplex) != 3 for simplex in [*a, *b]):
        raise predicament_engine.Declined("libigl finds triangles that meet, not other simplices")
    meeting = igl.copyleft.cgal.intersect_other(points, numpy.array(a), points, numpy.array(b), detect_only=True)[0]
    return [(a[i], b[j]) for i, j in meeting]


def cut(vertices, triangles, planes):
    parts = [(vertices, triangles)]
    for a, b, c in planes:
        normal = numpy.cross(b - a, c - a)
        halves = [igl.copyleft.cgal.intersect_with_half_space(*part, a, way * normal) for part in parts for way in (1, -1)]
        parts = [half[:2] for half in halves if len(half[1]) > 0]
    return parts


engine = predicament_engine.Engine("igl-tasks", importlib.metadata.version("libigl"), arrays=True)
engine.task("delaunay2d", lambda points: igl.copyleft.cgal.delaunay_triangulation(points))
engine.task("hull3d", lambda points: igl.copyleft.cgal.convex_hull(points))
engine.task("mesh-locate", locate)
engine.task("mesh-intersect", boolean)
engine.task("contacts3d", contacts)
engine.task("slice", cut)
predicament_engine.serve(engine)
