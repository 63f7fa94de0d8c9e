#!/usr/bin/env python3
"""Unions by `manifold` (manifold3d on PyPI), `igl` (libigl: CGAL's exact kernel) or `trueform`, for the bench `mesh_race`.

    python3 peers.py manifold|igl|trueform

Run it by the `venv` of the engine of that name. The protocol is that of `race.hpp`: lines with the files of two meshes and of the
result; answers are seconds from arrays to arrays, or `refused` and the reason.
"""

import sys
import time

import numpy


def read(path):
    with open(path, "rb") as file:
        points, triangles = map(int, numpy.fromfile(file, "<u8", 2))
        points = numpy.fromfile(file, "<f8", 3 * points).reshape(-1, 3)
        return points, numpy.fromfile(file, "<u4", 3 * triangles).reshape(-1, 3).astype(numpy.int32)


def write(path, points, triangles):
    with open(path, "wb") as file:
        numpy.array([len(points), len(triangles)], "<u8").tofile(file)
        numpy.ascontiguousarray(points, "<f8").tofile(file)
        numpy.ascontiguousarray(triangles, "<u4").tofile(file)


def manifold():
    import manifold3d

    def solid(mesh):
        made = manifold3d.Manifold(manifold3d.Mesh64(mesh[0], mesh[1].astype(numpy.uint64)))
        if made.status() != manifold3d.Error.NoError:
            raise ValueError(made.status().name)
        return made

    def unite(first, second):
        made = (solid(first) + solid(second)).to_mesh64()
        return numpy.asarray(made.vert_properties)[:, :3], numpy.asarray(made.tri_verts)

    return unite


def igl():
    from igl.copyleft import cgal

    return lambda first, second: cgal.mesh_boolean(*first, *second, "union")[:2]


def trueform():
    import trueform

    def unite(first, second):
        one, other = (trueform.Mesh(triangles, points) for points, triangles in (first, second))
        (triangles, points), *_ = trueform.boolean_union(one, other)
        return numpy.asarray(points), numpy.asarray(triangles)

    return unite


LIBRARIES = {"manifold": manifold, "igl": igl, "trueform": trueform}
if len(sys.argv) != 2 or sys.argv[1] not in LIBRARIES:
    sys.exit(f"usage: peers.py {'|'.join(LIBRARIES)}")
union = LIBRARIES[sys.argv[1]]()
for line in sys.stdin:
    first, second, result = line.split()
    first, second = read(first), read(second)
    try:
        start = time.perf_counter()
        made = union(first, second)
        seconds = time.perf_counter() - start
        write(result, *made)
        print(seconds, flush=True)
    except Exception as why:  # of any kind: that is the library's answer
        print("refused", type(why).__name__, str(why).split("\n")[0], flush=True)
