

# REPLACE. The parts of a closed mesh that is cut by planes, as pairs of vertices and triangles. A plane is three points.
# This gives the mesh as it is if no plane goes through it.
def slice(vertices, triangles, planes):
    for a, b, c in planes:
        sides = [volume(a, b, c, vertices[v]) for triangle in triangles for v in triangle]
        if min(sides) < 0 < max(sides):
            raise predicament_engine.Declined("this example takes planes that miss the mesh")
    return [(vertices, triangles)]


def volume(p, q, r, s):
    p, q, r = [[x - y for x, y in zip(point, s)] for point in (p, q, r)]
    return (
        p[2] * (q[0] * r[1] - r[0] * q[1])
        + q[2] * (r[0] * p[1] - p[0] * r[1])
        + r[2] * (p[0] * q[1] - q[0] * p[1])
    )
