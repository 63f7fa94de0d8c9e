"""Coal, an extension of FCL: the distance of two meshes by trees of boxes and GJK. Coal's meshes are surfaces: a mesh
inside another one is apart from it.
"""

import sys

sys.path.insert(0, "../python")

import coal
import numpy
import predicament_engine


def surface(points, triangles):
    used, places = numpy.unique(numpy.array(triangles), return_inverse=True)
    vertices, corners = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    vertices.extend(numpy.array(points)[used])
    corners.extend(coal.Triangle(*map(int, corner)) for corner in places.reshape(-1, 3))
    model = coal.BVHModelOBBRSS()
    model.beginModel(len(corners), len(vertices))
    model.addSubModel(vertices, corners)
    model.endModel()
    return model, coal.Transform3s()


def distance(points, a, b):
    if len(points[0]) == 2:
        raise predicament_engine.Declined("Coal measures meshes, and no polygons")
    result = coal.DistanceResult()
    coal.distance(*surface(points, a), *surface(points, b), coal.DistanceRequest(), result)
    return max(result.min_distance, 0)


engine = predicament_engine.Engine("coal", coal.__version__)
predicament_engine.serve(engine.task("distance", distance))
