

# REPLACE. For each segment a list of points with coordinates that are multiples of `side`. This rounds ends and
# crossings, one by one.
def snap2d(segments, side):
    def rounded(point):
        return tuple(round(x / side) * side for x in point)

    return [[rounded(point) for point in (a, *crossings(a, b, segments), b)] for a, b in segments]


def crossings(a, b, segments):
    found = []
    for c, d in segments:
        sides = turn(c, d, a), turn(c, d, b)
        if sides[0] * sides[1] < 0 and turn(a, b, c) * turn(a, b, d) < 0:
            found.append(sides[0] / (sides[0] - sides[1]))
    return [(a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])) for part in sorted(found)]


def turn(p, q, r):
    return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
