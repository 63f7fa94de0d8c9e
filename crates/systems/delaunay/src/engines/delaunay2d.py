

# REPLACE. Triangles of the Delaunay triangulation, as rows of three indices of points. Every triangle is tried.
def delaunay2d(points):
    if len(points) > 24:
        raise predicament_engine.Declined("too many points for this example")
    n = range(len(points))
    return [(a, b, c) for a in n for b in n for c in n if a < b and a < c and is_empty(points, a, b, c)]


def turn(p, q, r):
    return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])


def is_empty(points, a, b, c):
    p, q, r = points[a], points[b], points[c]
    return turn(p, q, r) > 0 and all(s in (p, q, r) or in_circle(p, q, r, s) <= 0 for s in points)


def in_circle(p, q, r, s):
    rows = [(x - s[0], y - s[1]) for x, y in (p, q, r)]
    (a, b, e), (c, d, f), (g, h, i) = [(x, y, x * x + y * y) for x, y in rows]
    return a * (d * i - f * h) - b * (c * i - f * g) + e * (c * h - d * g)
