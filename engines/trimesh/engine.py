"""trimesh: `contains` and `slice_plane` with a cap, which need a closed mesh, and rays."""

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


def rays(vertices, triangles, rays, extent):
    if extent != "ray":
        raise predicament_engine.Declined(f"trimesh has rays, and no {extent}s")
    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    origins = numpy.array([ray[0] for ray in rays])
    directions = numpy.array([ray[1] for ray in rays]) - origins
    # The triangles of each ray come in no order: they are sorted by their distances.
    faces, of, places = mesh.ray.intersects_id(origins, directions, return_locations=True)
    away = numpy.linalg.norm(places - origins[of], axis=1) if len(of) else numpy.zeros(0)
    hits = [[] for _ in rays]
    for at in numpy.lexsort((away, of)):
        hits[of[at]].append(faces[at])
    return hits


engine = predicament_engine.Engine("trimesh", trimesh.__version__, arrays=True)
predicament_engine.serve(engine.task("mesh-locate", locate).task("slice", cut).task("mesh-rays", rays))
