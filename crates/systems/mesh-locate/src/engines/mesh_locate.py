

# REPLACE. For each probe 1 inside, 0 outside, -2 on the surface. This counts the triangles above a probe.
def mesh_locate(vertices, triangles, probes):
    solid = [[vertices[corner] for corner in triangle] for triangle in triangles]
    return [sum(is_above(corners, probe) for corners in solid) % 2 for probe in probes]


def is_above(corners, p):
    a, b, c = corners
    turns = turn(a, b, p), turn(b, c, p), turn(c, a, p)
    if not (all(t > 0 for t in turns) or all(t < 0 for t in turns)):
        return False
    return sum(weight * z for weight, (_, _, z) in zip(turns, (c, a, b))) / sum(turns) > p[2]


def turn(p, q, r):
    return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
