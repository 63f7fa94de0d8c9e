"""trimesh: `contains`, which needs a closed mesh."""

import sys

sys.path.insert(0, "../python")

import predicament_engine
import trimesh


def locate(vertices, triangles, probes):
    mesh = trimesh.Trimesh(vertices, triangles, process=False)
    if not mesh.is_watertight:
        raise predicament_engine.Declined("for trimesh the mesh is not watertight")
    return mesh.contains(probes)


engine = predicament_engine.Engine("trimesh", trimesh.__version__, arrays=True)
predicament_engine.serve(engine.task("mesh-locate", locate))
