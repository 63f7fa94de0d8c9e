"""MeshLib's predicates on integers, which break ties by Simulation of Simplicity over the numbers of the vertices. A scene is
scaled by a power of two to integers; if these have more than 31 bits, the engine declines it."""

import importlib.metadata
import sys
from fractions import Fraction

sys.path.insert(0, "../python")

import predicament_engine
from meshlib import mrmeshpy


class Point:
    def __init__(self, number, at):
        self.number, self.at = mrmeshpy.VertId(number), at
        kinds = (mrmeshpy.PreciseVertCoords2, mrmeshpy.Vector2i), (mrmeshpy.PreciseVertCoords, mrmeshpy.Vector3i)
        kind, vector = kinds[len(at) - 2]
        self.precise = kind(self.number, vector(*at))


def gathered(array, points):
    for place, point in enumerate(points):
        array[place] = point.precise
    return array


class MeshLib:
    name = "meshlib"
    version = importlib.metadata.version("meshlib")
    zero = "never"

    def prepare(self, points, dimension):
        one = max((x.as_integer_ratio()[1] for point in points for x in point), default=1)
        whole = [tuple(int(Fraction(x) * one) for x in point) for point in points]
        if any(abs(x) >= 2**30 for point in whole for x in point):
            raise predicament_engine.Declined("the coordinates are no integers of 31 bits times a power of two")
        return [Point(*numbered) for numbered in enumerate(whole)]

    def compare(self, axis, a, b):
        a, b = (mrmeshpy.PreciseVertCoord(p.number, p.at[axis]) for p in (a, b))
        return -1 if mrmeshpy.smaller(a, b) else 1

    def orient2d(self, *points):
        return 1 if mrmeshpy.ccw(gathered(mrmeshpy.std_array_PreciseVertCoords2_3(), points)) else -1

    def orient3d(self, *points):
        return 1 if mrmeshpy.orient3d(gathered(mrmeshpy.std_array_PreciseVertCoords_4(), points)) else -1


predicament_engine.serve(MeshLib())
