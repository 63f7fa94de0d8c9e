"""FCL, the Flexible Collision Library: the distance of two meshes by trees of boxes. FCL's meshes are surfaces: a mesh
inside another one is apart from it.
"""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import fcl
import numpy
import predicament_engine


def surface(points, triangles):
    used, places = numpy.unique(numpy.array(triangles), return_inverse=True)
    model = fcl.BVHModel()
    model.beginModel(len(used), len(triangles))
    model.addSubModel(numpy.array(points)[used], places.reshape(-1, 3))
    model.endModel()
    return fcl.CollisionObject(model, fcl.Transform())


def distance(points, a, b):
    if len(points[0]) == 2:
        raise predicament_engine.Declined("FCL measures meshes, and no polygons")
    result = fcl.DistanceResult()
    fcl.distance(surface(points, a), surface(points, b), fcl.DistanceRequest(), result)
    return max(result.min_distance, 0)


engine = predicament_engine.Engine("fcl", importlib.metadata.version("python-fcl"))
predicament_engine.serve(engine.task("distance", distance))
