#!/usr/bin/env python3
"""Unions by GEOS, for the bench `dissolve`: its argument is the name of a function of shapely, `unary_union` or `coverage_union_all`.

It reads a WKT polygon a line, an empty line after each group. It prints the seconds that the unions of all groups took, the number
of their corners, and the number of groups for which there was an error in place of a union.
"""

import sys
import time

import shapely

union = getattr(shapely, sys.argv[1])
groups = [[]]
for line in sys.stdin:
    if line.strip():
        groups[-1].append(shapely.from_wkt(line))
    else:
        groups.append([])
groups = [group for group in groups if group]
unions, errors = [], 0
start = time.perf_counter()
for group in groups:
    try:
        unions.append(union(group))
    except shapely.errors.GEOSException:
        errors += 1
seconds = time.perf_counter() - start
rings = shapely.get_rings(shapely.get_parts(unions))
print(seconds, shapely.get_num_coordinates(rings).sum() - len(rings), errors)
