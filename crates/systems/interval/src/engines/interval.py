

# REPLACE. For each probe the number of its cell, -1 outside of all, -2 at an end. Cells are pairs of numbers.
def interval(cells, probes):
    return [locate(cells, probe) for probe in probes]


def locate(cells, probe):
    if any(probe in cell for cell in cells):
        return -2
    return next((at for at, (left, right) in enumerate(cells) if left < probe < right), -1)
