"""Qhull through scipy.spatial, which raises `QhullError` for points that span too little, or that it cannot order."""

import sys

sys.path.insert(0, "../python")

import predicament_engine
import scipy
from scipy.spatial import ConvexHull, Delaunay

engine = predicament_engine.Engine("scipy-qhull", scipy.__version__, arrays=True)
engine.task("delaunay2d", lambda points: Delaunay(points).simplices)
engine.task("hull2d", lambda points: ConvexHull(points).vertices)
engine.task("hull3d", lambda points: ConvexHull(points).simplices)
predicament_engine.serve(engine)
