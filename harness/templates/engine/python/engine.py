"""The engine {name}. Each predicate is a plain determinant, which is wrong near a tie.

REPLACE the body of each predicate by a call of your library. Delete a predicate that your library lacks. Only the sign
of a result counts. predicament_engine.py lists the other members that an engine may have, such as numpy arrays.
"""

import predicament_engine


def minus(p, q):
    return [x - y for x, y in zip(p, q)]


def lifted(p, q):
    """The difference of two points of the plane, and its squared length as z."""
    x, y = minus(p, q)
    return x, y, x * x + y * y


def squared(p):
    return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]


def triple(p, q, r):
    return (
        p[2] * (q[0] * r[1] - r[0] * q[1])
        + q[2] * (r[0] * p[1] - p[0] * r[1])
        + r[2] * (p[0] * q[1] - q[0] * p[1])
    )


class Engine:
    name = "{name}"
    version = "1.0"  # the version of your library
    zero = "exact"  # exact: a zero means that the points are degenerate. never: your library breaks ties

    # REPLACE. Positive where a's coordinate is greater than b's. axis is 0, 1 or 2.
    def compare(self, axis, a, b):
        return a[axis] - b[axis]

    # REPLACE. Positive where a, b, c turn counterclockwise.
    def orient2d(self, a, b, c):
        return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])

    # REPLACE. Positive where d is below the plane of a, b, c, which turn counterclockwise seen from above.
    def orient3d(self, a, b, c, d):
        return triple(minus(a, d), minus(b, d), minus(c, d))

    # REPLACE. Positive where d is inside the circle of a, b, c, which turn counterclockwise.
    def incircle(self, a, b, c, d):
        return triple(lifted(a, d), lifted(b, d), lifted(c, d))

    # REPLACE. Positive where e is inside the sphere of a, b, c, d, whose orient3d is positive.
    def insphere(self, a, b, c, d, e):
        p, q, r, s = minus(a, e), minus(b, e), minus(c, e), minus(d, e)
        return (squared(s) * triple(p, q, r) - squared(r) * triple(p, q, s)) + (
            squared(q) * triple(p, r, s) - squared(p) * triple(q, r, s)
        )


predicament_engine.serve(Engine())
