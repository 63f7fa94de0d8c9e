"""GEOS through shapely. A polygon of GEOS has one outer ring and holes in it, so the rings of an operand go in one by one:
their symmetric difference is the even-odd rule. A ring that crosses itself is first made valid, which keeps that rule.
"""

import functools
import sys

sys.path.insert(0, "../python")

import predicament_engine
import shapely


def region(rings):
    if any(len(ring) < 3 for ring in rings):
        raise predicament_engine.Declined("a ring has fewer than three points")
    polygons = [shapely.make_valid(shapely.Polygon(ring)) for ring in rings]
    return functools.reduce(shapely.symmetric_difference, polygons, shapely.Polygon())


def polygons(geometry):
    """The polygons of a geometry, which can also have points and lines."""
    if geometry.geom_type == "Polygon":
        rings = [] if geometry.is_empty else [geometry.exterior, *geometry.interiors]
        return [[list(ring.coords) for ring in rings]] if rings else []
    return [polygon for part in getattr(geometry, "geoms", []) for polygon in polygons(part)]


def overlay(first, second, rule):
    if rule != "even-odd":
        raise predicament_engine.Declined("GEOS has no rule of nonzero winding numbers")
    a, b = region(first), region(second)
    return {
        "union": polygons(shapely.union(a, b)),
        "intersection": polygons(shapely.intersection(a, b)),
        "difference": polygons(shapely.difference(a, b)),
        "symmetric-difference": polygons(shapely.symmetric_difference(a, b)),
    }


def locate(regions, probes):
    xs, ys = [x for x, _ in probes], [y for _, y in probes]
    labels = [-1] * len(probes)
    for number, rings in enumerate(regions):
        polygon = region(rings)
        inside, touched = shapely.contains_xy(polygon, xs, ys), shapely.intersects_xy(polygon, xs, ys)
        for at in range(len(probes)):
            if inside[at]:
                labels[at] = number
            elif touched[at] and labels[at] == -1:
                labels[at] = -2
    return labels


def shape(points, simplex):
    """A point, a segment or a triangle."""
    kinds = {1: shapely.Point, 2: shapely.LineString, 3: shapely.Polygon}
    return kinds[len(simplex)]([points[v] for v in simplex])


def contacts(points, a, b):
    shapes = [[shape(points, simplex) for simplex in simplices] for simplices in (a, b)]
    return [(a[i], b[j]) for i, j in shapely.STRtree(shapes[1]).query(shapes[0], predicate="intersects").T]


def crossings(segments):
    lines = [shapely.LineString(segment) for segment in segments]
    along = [[] for _ in lines]
    for i, j in shapely.STRtree(lines).query(lines, predicate="crosses").T:
        along[i].append((shapely.line_locate_point(lines[i], shapely.intersection(lines[i], lines[j])), j))
    return [[j for _, j in sorted(crossed)] for crossed in along]


version = f"{shapely.__version__}, GEOS {'.'.join(map(str, shapely.geos_version))}"
engine = predicament_engine.Engine("shapely", version)
engine.task("overlay2d", overlay).task("polygon-locate", locate)
engine.task("contacts2d", contacts).task("crossings", crossings)
predicament_engine.serve(engine)
