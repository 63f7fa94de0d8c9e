#!/usr/bin/env python3
"""Unions by another library, for the bench `mesh_overlay`: the library, then the files of two meshes.

`manifold` (manifold3d on PyPI), `igl` (libigl: its Boolean operations are those of CGAL's exact kernel) or `trueform` (for
noncommercial purposes only, by its licence); all need numpy. A file is two 64-bit counts, of points and of triangles, then coordinates
as doubles and 32-bit indices, little-endian. Printed are the seconds that the union took (from arrays to a mesh; without reading), the
number of its triangles, and its volume.
"""

import sys
import time

import numpy


def read(path):
    """The points and triangles of a file."""
    with open(path, "rb") as file:
        points, triangles = numpy.fromfile(file, "<u8", 2)
        points = numpy.fromfile(file, "<f8", 3 * int(points)).reshape(-1, 3)
        triangles = numpy.fromfile(file, "<u4", 3 * int(triangles)).reshape(-1, 3)
    return points, triangles.astype(numpy.int32)


def volume(points, triangles):
    """The volume inside of a closed mesh."""
    a, b, c = (points[triangles[:, corner]] for corner in range(3))
    return float(numpy.einsum("ij,ij->i", a, numpy.cross(b, c)).sum() / 6)


def manifold(first, second):
    import manifold3d

    start = time.perf_counter()
    meshes = (manifold3d.Mesh64(points, triangles.astype(numpy.uint64)) for points, triangles in (first, second))
    one, other = (manifold3d.Manifold(mesh) for mesh in meshes)
    union = one + other
    triangles = union.num_tri()
    seconds = time.perf_counter() - start
    if union.status() != manifold3d.Error.NoError:
        sys.exit(f"{union.status()}")
    return seconds, triangles, union.volume()


def igl(first, second):
    from igl.copyleft import cgal

    start = time.perf_counter()
    points, triangles, *_ = cgal.mesh_boolean(*first, *second, "union")
    return time.perf_counter() - start, len(triangles), volume(points, triangles)


def trueform(first, second):
    import trueform

    start = time.perf_counter()
    one, other = (trueform.Mesh(triangles, points) for points, triangles in (first, second))
    (triangles, points), *_ = trueform.boolean_union(one, other)
    seconds = time.perf_counter() - start
    return seconds, len(triangles), volume(numpy.asarray(points), numpy.asarray(triangles))


LIBRARIES = {"manifold": manifold, "igl": igl, "trueform": trueform}
if len(sys.argv) != 4 or sys.argv[1] not in LIBRARIES:
    sys.exit(f"usage: mesh_overlay.py {'|'.join(LIBRARIES)} FIRST SECOND")
seconds, triangles, inside = LIBRARIES[sys.argv[1]](*map(read, sys.argv[2:]))
print(seconds, triangles, repr(inside))
