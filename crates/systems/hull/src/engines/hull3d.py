

# REPLACE. The triangles of the hull's surface, as rows of three indices of points. Every triangle is tried.
def hull3d(points):
    if len(points) > 24:
        raise predicament_engine.Declined("too many points for this example")
    n = range(len(points))
    every = ((a, b, c) for a in n for b in n for c in n if a < b and a < c and b != c)
    return [face for face in every if all(volume(points, *face, at) > 0 for at in n if at not in face)]


def volume(points, a, b, c, d):
    p, q, r = [[x - y for x, y in zip(points[at], points[d])] for at in (a, b, c)]
    return (
        p[2] * (q[0] * r[1] - r[0] * q[1])
        + q[2] * (r[0] * p[1] - p[0] * r[1])
        + r[2] * (p[0] * q[1] - q[0] * p[1])
    )
