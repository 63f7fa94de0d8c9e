

# REPLACE. Results by name: "union", "intersection", "difference", "symmetric-difference", all or some of them. An operand
# and a result are pairs of vertices and triangles. This puts one solid beside the other: a union if they are apart.
def mesh_intersect(first, second):
    (vertices, triangles), (others, more) = first, second
    moved = [tuple(corner + len(vertices) for corner in triangle) for triangle in more]
    return {"union": (list(vertices) + list(others), list(triangles) + moved)}
