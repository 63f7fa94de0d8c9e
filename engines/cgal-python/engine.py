"""The planar orientation of CGAL's kernel with exact predicates, through its Python package."""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import predicament_engine
from CGAL.CGAL_Kernel import Point_2, orientation


class Cgal:
    name = "cgal-python"
    version = importlib.metadata.version("cgal")
    zero = "exact"

    def prepare(self, points, dimension):
        return [Point_2(point[0], point[1]) for point in points]

    def orient2d(self, a, b, c):
        return orientation(a, b, c)


predicament_engine.serve(Cgal())
