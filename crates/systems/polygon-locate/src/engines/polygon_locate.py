

# REPLACE. For each probe the number of its region, -1 outside of all, -2 on a border. A region is a list of rings of
# points. This counts crossings.
def polygon_locate(regions, probes):
    return [next((at for at, rings in enumerate(regions) if is_in(rings, probe)), -1) for probe in probes]


def is_in(rings, p):
    edges = (edge for ring in rings for edge in zip(ring, ring[1:] + ring[:1]))
    return sum((a[1] > p[1]) != (b[1] > p[1]) and p[0] < at(a, b, p[1]) for a, b in edges) % 2 == 1


def at(a, b, y):
    return a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
