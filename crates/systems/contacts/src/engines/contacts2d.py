

# REPLACE. Pairs of simplices that meet, each with the indices of its points. Of edges, each pair is tried.
def contacts2d(points, a, b):
    if any(len(simplex) != 2 for simplex in [*a, *b]):
        raise predicament_engine.Declined("this example takes edges")
    return [(s, t) for s in a for t in b if meet([points[v] for v in s], [points[v] for v in t])]


def meet(s, t):
    for axis in (0, 1):
        one, other = [[point[axis] for point in edge] for edge in (s, t)]
        if max(one) < min(other) or max(other) < min(one):
            return False
    return all(turn(*p, q[0]) * turn(*p, q[1]) <= 0 for p, q in ((s, t), (t, s)))


def turn(p, q, r):
    return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
