"""The predicates of libigl's Python package. orient3d takes arrays; the others take one query at a time."""

import importlib.metadata
import sys

sys.path.insert(0, "../python")

import igl.predicates
import predicament_engine


class Igl:
    name = "igl"
    version = importlib.metadata.version("libigl")
    zero = "exact"
    arrays = True

    def prepare(self, points, dimension):
        return list(points)

    def orient2d(self, a, b, c):
        return igl.predicates.orient2d(a, b, c).value

    def orient3d_arrays(self, a, b, c, d):
        return igl.predicates.orient3d(a, b, c, d)

    def incircle(self, a, b, c, d):
        return igl.predicates.incircle(a, b, c, d).value

    def insphere(self, a, b, c, d, e):
        return igl.predicates.insphere(a, b, c, d, e).value


predicament_engine.serve(Igl())
