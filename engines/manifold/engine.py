"""Manifold, with coordinates in doubles. It refuses meshes that are not closed, oriented surfaces: the scene is declined."""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import manifold3d
import numpy
import predicament_engine


def solid(mesh):
    vertices, triangles = mesh
    made = manifold3d.Manifold(manifold3d.Mesh64(vertices, triangles.astype("u8")))
    if made.status() != manifold3d.Error.NoError:
        raise predicament_engine.Declined(f"Manifold refuses an operand: {made.status().name}")
    return made


def mesh(solid):
    made = solid.to_mesh64()
    return numpy.asarray(made.vert_properties)[:, :3], numpy.asarray(made.tri_verts)


def boolean(first, second):
    a, b = solid(first), solid(second)
    return {"union": mesh(a + b), "intersection": mesh(a ^ b), "difference": mesh(a - b)}


engine = predicament_engine.Engine("manifold", importlib.metadata.version("manifold3d"), arrays=True)
predicament_engine.serve(engine.task("mesh-intersect", boolean))
