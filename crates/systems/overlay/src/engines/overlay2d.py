

# REPLACE. Results by name: "union", "intersection", "difference", "symmetric-difference", all or some of them. A result
# is a list of polygons, and a polygon a list of rings, the outer one first. This clips one convex polygon by another
# (Sutherland and Hodgman 1974).
def overlay2d(first, second):
    if len(first) != 1 or len(second) != 1 or not is_convex(second[0]) or not is_convex(first[0]):
        raise predicament_engine.Declined("this example takes two convex polygons")
    ring, clip = first[0], counterclockwise(second[0])
    for a, b in zip(clip, clip[1:] + clip[:1]):
        ring = [point for p, q in zip(ring[-1:] + ring[:-1], ring) for point in clipped(a, b, p, q)]
    return {"intersection": [[ring]] if ring else []}


def clipped(a, b, p, q):
    """The part of the edge from p to q on the left of the line from a to b, without its start."""
    from_p, from_q = turn(a, b, p), turn(a, b, q)
    part = from_p / (from_p - from_q) if from_p != from_q else 0
    crossing = [(p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1]))]
    return (crossing if (from_p < 0) != (from_q < 0) else []) + ([q] if from_q >= 0 else [])


def turn(p, q, r):
    return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])


def corners(ring):
    return zip(ring, ring[1:] + ring[:1], ring[2:] + ring[:2])


def counterclockwise(ring):
    return ring if sum(turn(*corner) for corner in corners(ring)) > 0 else ring[::-1]


def is_convex(ring):
    return len({turn(*corner) > 0 for corner in corners(ring)}) == 1
