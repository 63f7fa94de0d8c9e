

# REPLACE. The distance of two objects: of polygons, by loops of points, or of meshes, by triangles. Each vertex is
# measured to each edge of the other object.
def distance(points, a, b):
    return min(to_object(points, one, other) for one, other in ((a, b), (b, a)))


def to_object(points, vertices, parts):
    edges = [(points[u], points[v]) for part in parts for u, v in zip(part, [*part[1:], part[0]])]
    return min(to_edge(points[p], a, b) for p in {p for part in vertices for p in part} for a, b in edges)


def to_edge(p, a, b):
    along = [y - x for x, y in zip(a, b)]
    length = sum(x * x for x in along)
    place = sum((x - y) * z for x, y, z in zip(p, a, along)) / length if length > 0 else 0
    place = min(max(place, 0), 1)
    return sum((x - y - place * z) ** 2 for x, y, z in zip(p, a, along)) ** 0.5
