

# REPLACE. The triangles of one polygon. `rings` are its rings, as lists of indices of points. This cuts ears.
def triangulate(points, rings):
    if len(rings) > 1:
        raise predicament_engine.Declined("this example takes polygons without holes")
    ring, triangles = list(rings[0]), []
    if sum(turn(points[ring[0]], points[b], points[c]) for b, c in zip(ring, ring[1:])) < 0:
        ring.reverse()
    while len(ring) > 3:
        ear = next((at for at in range(len(ring)) if is_ear(points, ring, at)), 0)
        triangles.append((ring[ear - 1], ring[ear], ring[(ear + 1) % len(ring)]))
        del ring[ear]
    return triangles + [tuple(ring)]


def is_ear(points, ring, at):
    a, b, c = [points[ring[place]] for place in (at - 1, at, (at + 1) % len(ring))]
    others = [points[v] for v in ring if points[v] not in (a, b, c)]
    inside = (turn(a, b, p) >= 0 and turn(b, c, p) >= 0 and turn(c, a, p) >= 0 for p in others)
    return turn(a, b, c) > 0 and not any(inside)


def turn(p, q, r):
    return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
