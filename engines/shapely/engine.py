"""GEOS through shapely. The rings of an operand go in one by one: their symmetric difference is the even-odd rule. A ring
that crosses itself is first made valid, which keeps that rule."""
import functools
import os
import sys

sys.path.insert(0, "../python")
import predicament_engine
import shapely

OPERATIONS = "union", "intersection", "difference", "symmetric-difference"
GRID = float(os.environ.get("PREDICAMENT_GRID", 0)) or None
SIMPLICES = {1: shapely.Point, 2: shapely.LineString, 3: shapely.Polygon}


def region(rings):
    if any(len(ring) < 3 for ring in rings):
        raise predicament_engine.Declined("a ring has fewer than three points")
    valid = (shapely.make_valid(shapely.Polygon(ring)) for ring in rings)
    return functools.reduce(shapely.symmetric_difference, valid, shapely.Polygon())


def polygons(geometry):
    """The polygons of a geometry, which can also have points and lines."""
    if geometry.geom_type == "Polygon":
        return [] if geometry.is_empty else [[list(ring.coords) for ring in (geometry.exterior, *geometry.interiors)]]
    return [polygon for part in getattr(geometry, "geoms", []) for polygon in polygons(part)]


def overlay(first, second, rule):
    if rule != "even-odd":
        raise predicament_engine.Declined("GEOS has no rule of nonzero winding numbers")
    both = region(first), region(second)
    return {name: polygons(getattr(shapely, name.replace("-", "_"))(*both, grid_size=GRID)) for name in OPERATIONS}


def locate(regions, probes):
    labels = [-1] * len(probes)
    for number, polygon in enumerate(map(region, regions)):
        tests = (test(polygon, *zip(*probes)) for test in (shapely.contains_xy, shapely.intersects_xy))
        labels = [number if a else -2 if b and label == -1 else label for a, b, label in zip(*tests, labels)]
    return labels


def contacts(points, a, b):
    shapes = [[SIMPLICES[len(simplex)]([points[v] for v in simplex]) for simplex in simplices] for simplices in (a, b)]
    return [(a[i], b[j]) for i, j in shapely.STRtree(shapes[1]).query(shapes[0], predicate="intersects").T]


def crossings(segments):
    lines = [shapely.LineString(segment) for segment in segments]
    along = [[] for _ in lines]
    for i, j in shapely.STRtree(lines).query(lines, predicate="crosses").T:
        along[i].append((shapely.line_locate_point(lines[i], shapely.intersection(lines[i], lines[j])), j))
    return [[j for _, j in sorted(crossed)] for crossed in along]


engine = predicament_engine.Engine("shapely", f"{shapely.__version__}, GEOS {shapely.geos_version_string}")
engine.task("overlay2d", overlay).task("polygon-locate", locate).task("contacts2d", contacts)
predicament_engine.serve(engine.task("crossings", crossings))
