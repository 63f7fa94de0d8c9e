"""trimesh: `contains` and `slice_plane` with a cap, which need a closed mesh."""

import sys

sys.path.insert(0, "../python")

import numpy
import predicament_engine
import trimesh


def solid(vertices, triangles):
    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    if not mesh.is_watertight:
        raise predicament_engine.Declined("for trimesh the mesh is not watertight")
    return mesh


def locate(vertices, triangles, probes):
    return solid(vertices, triangles).contains(probes)


def cut(vertices, triangles, planes):
    parts = [solid(vertices, triangles)]
    for a, b, c in planes:
        normal = trimesh.transformations.unit_vector(numpy.cross(b - a, c - a))
        sides = [part.slice_plane(a, way * normal, cap=True) for part in parts for way in (1, -1)]
        parts = [side for side in sides if len(side.faces) > 0]
    return [(part.vertices, part.faces) for part in parts]


engine = predicament_engine.Engine("trimesh", trimesh.__version__, arrays=True)
predicament_engine.serve(engine.task("mesh-locate", locate).task("slice", cut))
