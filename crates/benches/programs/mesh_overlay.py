#!/usr/bin/env python3
"""Unions by Manifold (manifold3d and numpy on PyPI), for the bench `mesh_overlay`: its arguments are the files of two meshes.

A file is two 64-bit counts, of points and of triangles, then coordinates as doubles and 32-bit indices, little-endian. It prints the
seconds that the union took (from arrays to a mesh; without reading), the number of its triangles, and its volume.
"""

import sys
import time

import manifold3d
import numpy


def read(path):
    """The points and triangles of a file."""
    with open(path, "rb") as file:
        points, triangles = numpy.fromfile(file, "<u8", 2)
        points = numpy.fromfile(file, "<f8", 3 * int(points)).reshape(-1, 3)
        triangles = numpy.fromfile(file, "<u4", 3 * int(triangles)).reshape(-1, 3)
    return points, triangles.astype(numpy.uint64)


meshes = [read(path) for path in sys.argv[1:3]]
start = time.perf_counter()
first, second = (manifold3d.Manifold(manifold3d.Mesh64(points, triangles)) for points, triangles in meshes)
union = first + second
triangles = union.num_tri()
seconds = time.perf_counter() - start
if union.status() != manifold3d.Error.NoError:
    sys.exit(f"{union.status()}")
print(seconds, triangles, repr(union.volume()))
