"""Manifold, with coordinates in doubles. It refuses meshes that are not closed, oriented surfaces by a status."""

import importlib.metadata
import os
import sys

sys.path.insert(0, "../python")

import manifold3d
import numpy
import predicament_engine

TOLERANCE = float(os.environ.get("PREDICAMENT_TOLERANCE", 0))


def solid(mesh):
    vertices, triangles = mesh
    made = manifold3d.Manifold(manifold3d.Mesh64(vertices, triangles.astype("u8")))
    if made.status() != manifold3d.Error.NoError:
        raise ValueError(f"Manifold's status for an operand is {made.status().name}")
    return made.set_tolerance(TOLERANCE) if TOLERANCE else made


def mesh(solid):
    made = solid.to_mesh64()
    return numpy.asarray(made.vert_properties)[:, :3], numpy.asarray(made.tri_verts)


def boolean(first, second):
    a, b = solid(first), solid(second)
    return {"union": mesh(a + b), "intersection": mesh(a ^ b), "difference": mesh(a - b)}


def cut(vertices, triangles, planes):
    parts = [solid((vertices, triangles))]
    for a, b, c in planes:
        normal = numpy.cross(b - a, c - a)
        normal /= numpy.linalg.norm(normal)
        parts = [side for part in parts for side in part.split_by_plane(normal, normal @ a)]
    return [mesh(part) for part in parts if not part.is_empty()]


def cubes(cubes):
    solids = [manifold3d.Manifold.cube([edge] * 3).translate([x, y, z]) for x, y, z, edge in cubes.tolist()]
    union = manifold3d.Manifold.batch_boolean(solids, manifold3d.OpType.Add)
    return {"volume": union.volume(), "area": union.surface_area()}


engine = predicament_engine.Engine("manifold", importlib.metadata.version("manifold3d"), arrays=True)
engine.task("mesh-intersect", boolean).task("slice", cut).task("cube-union", cubes)
predicament_engine.serve(engine)
