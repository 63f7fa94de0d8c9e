

# REPLACE. The volume and the area of a union of cubes, and the length of its edges if you like. A cube has x, y and z of
# its lower corner and the length of its edges. This looks at each cell between the planes of all faces.
def cube_union(cubes):
    if len(cubes) > 12:
        raise predicament_engine.Declined("too many cubes for this example")
    edge = cubes[0][3]
    planes = [sorted({x for cube in cubes for x in (cube[axis], cube[axis] + edge)}) for axis in range(3)]
    xs, ys, zs = [list(zip(along, along[1:])) for along in planes]
    grid = [[[is_in(cubes, (x[0], y[0], z[0])) for z in zs] for y in ys] for x in xs]
    volume = area = 0
    for i, (x, next_x) in enumerate(xs):
        for j, (y, next_y) in enumerate(ys):
            for k, (z, next_z) in enumerate(zs):
                a, b, c = next_x - x, next_y - y, next_z - z
                volume += a * b * c * grid[i][j][k]
                faces = (b * c, cell(grid, i - 1, j, k)), (a * c, cell(grid, i, j - 1, k)), (a * b, cell(grid, i, j, k - 1))
                area += 2 * grid[i][j][k] * sum(face * (not before) for face, before in faces)
    return {"volume": volume, "area": area}


def cell(grid, i, j, k):
    return min(i, j, k) >= 0 and grid[i][j][k]


def is_in(cubes, point):
    return any(all(low <= x < low + cube[3] for low, x in zip(cube, point)) for cube in cubes)
