"""Embree, by the binding that trimesh uses: all hits of rays.

Embree finds the first hit of a ray. trimesh moves the ray past it by a small step, and asks again.
"""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import numpy
import predicament_engine
import trimesh
from trimesh.ray.ray_pyembree import RayMeshIntersector


def rays(vertices, triangles, rays, extent):
    if extent != "ray":
        raise predicament_engine.Declined(f"Embree has rays, and no {extent}s")
    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    origins = numpy.array([ray[0] for ray in rays])
    directions = numpy.array([ray[1] for ray in rays]) - origins
    faces, of, places = RayMeshIntersector(mesh).intersects_id(origins, directions, return_locations=True)
    away = numpy.linalg.norm(places - origins[of], axis=1) if len(of) else numpy.zeros(0)
    hits = [[] for _ in rays]
    for at in numpy.lexsort((away, of)):
        hits[of[at]].append(faces[at])
    return hits


version = importlib.metadata.version("embreex")
engine = predicament_engine.Engine("embree", version, arrays=True)
predicament_engine.serve(engine.task("mesh-rays", rays))
