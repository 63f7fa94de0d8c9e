"""GEOS through shapely: the distance of two polygons. Their rings go in one by one: their symmetric difference is the
even-odd rule. A ring that crosses itself is first made valid, which keeps that rule.
"""

import functools
import sys

sys.path.insert(0, "../python")
import predicament_engine
import shapely


def region(points, rings):
    valid = (shapely.make_valid(shapely.Polygon([points[v] for v in ring])) for ring in rings)
    return functools.reduce(shapely.symmetric_difference, valid, shapely.Polygon())


def distance(points, a, b):
    if len(points[0]) == 3:
        raise predicament_engine.Declined("GEOS measures in the plane")
    return shapely.distance(region(points, a), region(points, b))


engine = predicament_engine.Engine("shapely-distances", f"{shapely.__version__}, GEOS {shapely.geos_version_string}")
predicament_engine.serve(engine.task("distance", distance))
