"""Qhull through scipy.spatial. Its error for points that span too little, or that it cannot order, declines the scene."""

import sys

sys.path.insert(0, "../python")

import predicament_engine
import scipy
from scipy.spatial import ConvexHull, Delaunay, QhullError


def qhull(compute):
    try:
        return compute()
    except QhullError as problem:
        raise predicament_engine.Declined(str(problem).split("\n")[0])


engine = predicament_engine.Engine("scipy-qhull", scipy.__version__, arrays=True)
engine.task("delaunay2d", lambda points: qhull(lambda: Delaunay(points).simplices))
engine.task("hull2d", lambda points: qhull(lambda: ConvexHull(points).vertices))
engine.task("hull3d", lambda points: qhull(lambda: ConvexHull(points).simplices))
predicament_engine.serve(engine)
