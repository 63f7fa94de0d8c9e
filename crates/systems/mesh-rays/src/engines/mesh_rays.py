

# REPLACE. For each ray the triangles that it hits, in their order along it. Each triangle is tried.
def mesh_rays(vertices, triangles, rays, extent):
    solid = [[vertices[corner] for corner in triangle] for triangle in triangles]
    return [[face for _, face in sorted(ray_hits(solid, ray, extent))] for ray in rays]


def ray_hits(solid, ray, extent):
    """The place of each hit on the ray, from 0 at its first point to 1 at its second, and the triangle."""
    for face, corners in enumerate(solid):
        place = ray_hit(corners, ray)
        if place is not None and (extent == "line" or place >= 0) and (extent != "segment" or place <= 1):
            yield place, face


def ray_hit(corners, ray):
    (a, b, c), (p, q) = corners, ray
    along, u, v, from_a = minus(q, p), minus(b, a), minus(c, a), minus(p, a)
    across = cross(along, v)
    volume = dot(u, across)
    if volume == 0:
        return None
    second = dot(from_a, across) / volume
    other = cross(from_a, u)
    third = dot(along, other) / volume
    return dot(v, other) / volume if second >= 0 and third >= 0 and second + third <= 1 else None


def minus(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]
