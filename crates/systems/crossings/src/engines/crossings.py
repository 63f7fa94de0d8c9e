

# REPLACE. For each segment the numbers of those that cross it, in their order along it. Each pair is tried.
def crossings(segments):
    return [[other for _, other in sorted(along(segments, at))] for at in range(len(segments))]


def along(segments, at):
    """The part of the segment before each crossing, and the number of the segment that crosses there."""
    a, b = segments[at]
    for other, (c, d) in enumerate(segments):
        sides = turn(c, d, a), turn(c, d, b)
        if sides[0] * sides[1] < 0 and turn(a, b, c) * turn(a, b, d) < 0:
            yield sides[0] / (sides[0] - sides[1]), other


def turn(p, q, r):
    return (p[0] - r[0]) * (q[1] - r[1]) - (p[1] - r[1]) * (q[0] - r[0])
