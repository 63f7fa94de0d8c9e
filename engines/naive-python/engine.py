"""Determinants in plain doubles: a starting point for predicates of your own."""

import sys

sys.path.insert(0, "../python")

import predicament_engine


class Naive:
    name = "naive-python"
    version = "1.0"
    zero = "exact"

    def compare(self, axis, a, b):
        return a[axis] - b[axis]

    def orient2d(self, a, b, c):
        return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])

    def orient3d(self, a, b, c, d):
        ax, ay, az = a[0] - d[0], a[1] - d[1], a[2] - d[2]
        bx, by, bz = b[0] - d[0], b[1] - d[1], b[2] - d[2]
        cx, cy, cz = c[0] - d[0], c[1] - d[1], c[2] - d[2]
        return ax * (by * cz - bz * cy) + bx * (cy * az - cz * ay) + cx * (ay * bz - az * by)

    def incircle(self, a, b, c, d):
        ax, ay, bx, by = a[0] - d[0], a[1] - d[1], b[0] - d[0], b[1] - d[1]
        cx, cy = c[0] - d[0], c[1] - d[1]
        return (
            (ax * ax + ay * ay) * (bx * cy - by * cx)
            + (bx * bx + by * by) * (cx * ay - cy * ax)
            + (cx * cx + cy * cy) * (ax * by - ay * bx)
        )


predicament_engine.serve(Naive())
