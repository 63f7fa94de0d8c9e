

# REPLACE. Pairs of simplices that meet, each with the indices of its points. Of triangles, each pair is tried: an edge of
# one goes through the other.
def contacts3d(points, a, b):
    if any(len(simplex) != 3 for simplex in [*a, *b]):
        raise predicament_engine.Declined("this example takes triangles")
    return [(s, t) for s in a for t in b if meet([points[v] for v in s], [points[v] for v in t])]


def meet(s, t):
    return any(pierces(p, q, corners) for one, corners in ((s, t), (t, s)) for p, q in zip(one, one[1:] + one[:1]))


def pierces(p, q, corners):
    a, b, c = corners
    sides = volume(a, b, c, p), volume(a, b, c, q)
    turns = [volume(p, q, *edge) for edge in ((a, b), (b, c), (c, a))]
    return sides[0] * sides[1] <= 0 and sides != (0, 0) and (min(turns) >= 0 or max(turns) <= 0)


def volume(p, q, r, s):
    p, q, r = [[x - y for x, y in zip(point, s)] for point in (p, q, r)]
    return (
        p[2] * (q[0] * r[1] - r[0] * q[1])
        + q[2] * (r[0] * p[1] - p[0] * r[1])
        + r[2] * (p[0] * q[1] - q[0] * p[1])
    )
