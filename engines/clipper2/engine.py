"""Clipper2 on its grid of integers. The scene is scaled by a power of two, so that its largest coordinate has 52 bits (or as
many as the parameter says), and rounded to the grid; results are scaled back. Clipper2 knows both rules of the tool and takes
all rings of an operand at once."""

import importlib.metadata
import math
import os
import sys

sys.path.insert(0, "../python")

import predicament_engine
from clipper2 import Clipper64, ClipType, FillRule

BITS = int(os.environ.get("PREDICAMENT_BITS", 52))
OPERATIONS = {
    "union": ClipType.UNION,
    "intersection": ClipType.INTERSECTION,
    "difference": ClipType.DIFFERENCE,
    "symmetric-difference": ClipType.XOR,
}


def overlay(first, second, rule):
    rule = FillRule.EVEN_ODD if rule == "even-odd" else FillRule.NON_ZERO
    largest = max((abs(x) for ring in first + second for point in ring for x in point), default=0.0)
    shift = BITS - math.frexp(largest)[1]

    def grid(rings):
        return [[tuple(round(math.ldexp(x, shift)) for x in point) for point in ring] for ring in rings]

    def ring(path):
        return [[math.ldexp(int(x), -shift) for x in (point[0], point[1])] for point in path.polygon]

    def polygons(tree):
        """Each outer ring with its holes; islands in the holes are polygons of their own."""
        found = []
        for outer in tree:
            found.append([ring(outer), *map(ring, outer)])
            for hole in outer:
                found += polygons(hole)
        return found

    first, second = grid(first), grid(second)

    def result(operation):
        clipper = Clipper64()
        clipper.add_subject(first)
        clipper.add_clip(second)
        return polygons(clipper.execute_tree(operation, rule)[0])

    return {name: result(operation) for name, operation in OPERATIONS.items()}


engine = predicament_engine.Engine("clipper2", importlib.metadata.version("clipper2-py"))
predicament_engine.serve(engine.task("overlay2d", overlay))
