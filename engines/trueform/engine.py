"""trueform, with coordinates in doubles. Meshes that are not closed manifolds are declined."""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import numpy
import predicament_engine
import trueform


def solid(mesh):
    vertices, triangles = mesh
    made = trueform.Mesh(triangles.astype(numpy.int32), vertices)
    if not (trueform.is_closed(made) and trueform.is_manifold(made)):
        raise predicament_engine.Declined("for trueform an operand is not a closed manifold")
    return made


def boolean(first, second):
    a, b = solid(first), solid(second)
    results = {}
    for name in ("union", "intersection", "difference"):
        (triangles, vertices), *_ = getattr(trueform, f"boolean_{name}")(a, b)
        results[name] = numpy.asarray(vertices, float), numpy.asarray(triangles)
    return results


engine = predicament_engine.Engine("trueform", importlib.metadata.version("trueform"), arrays=True)
engine.task("mesh-intersect", boolean)
predicament_engine.serve(engine)
