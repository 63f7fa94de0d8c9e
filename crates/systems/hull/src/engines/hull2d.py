

# REPLACE. The indices of the hull's corners, one after the other. This is Andrew's monotone chain.
def hull2d(points):
    order = sorted(range(len(points)), key=lambda at: points[at])
    return chain(points, order)[:-1] + chain(points, order[::-1])[:-1] if len(order) > 1 else order


def chain(points, order):
    found = []
    for at in order:
        while len(found) > 1 and turn(points[found[-2]], points[found[-1]], points[at]) <= 0:
            found.pop()
        found.append(at)
    return found


def turn(p, q, r):
    return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
