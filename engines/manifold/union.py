"""The union of cubes by manifold, beside the example `cube_union` (docs/CUBES.md).

    pip install manifold3d numpy
    python union.py cubes.csv [--volume V] [--area A]

Prints volume, area and seconds: of the boolean alone, and including the
construction of the cubes. Both exclude reading the file. CPU seconds are
those of all threads. V and A are the exact volume and area to compare with,
as integers.
"""

import argparse
import sys
import time
from fractions import Fraction

from manifold3d import Manifold, OpType


def read(path):
    """The lower corners and the edge length in a file of cubes."""
    with open(path, encoding="ascii") as file:
        head = file.readline().split()
        if head[:2] != ["#", "edge"] or len(head) != 3:
            sys.exit(f"{path}:1: the first line must be `# edge N`")
        if file.readline().strip() != "x,y,z":
            sys.exit(f"{path}:2: the second line must be `x,y,z`")
        lowers = []
        for number, line in enumerate(file, 3):
            values = line.split(",")
            try:
                x, y, z = map(int, values)
            except ValueError:
                sys.exit(f"{path}:{number}: `{line.strip()}` are not three integers")
            lowers.append((x, y, z))
    return lowers, int(head[2])


class Clock:
    """The wall-clock and CPU seconds since its construction."""

    def __init__(self):
        self.wall, self.cpu = time.perf_counter(), time.process_time()

    def __str__(self):
        return f"{time.perf_counter() - self.wall:.6f}, {time.process_time() - self.cpu:.6f} of CPU"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("cubes")
    parser.add_argument("--volume", type=int)
    parser.add_argument("--area", type=int)
    args = parser.parse_args()
    lowers, edge = read(args.cubes)
    total = Clock()
    cube = Manifold.cube((edge, edge, edge))
    cubes = [cube.translate(lower) for lower in lowers]
    boolean = Clock()
    union = Manifold.batch_boolean(cubes, OpType.Add)
    # Evaluation is lazy: these calls force the computation.
    triangles, status = union.num_tri(), union.status()
    seconds = f"boolean seconds {boolean}\ntotal seconds {total}"
    volume, area = union.volume(), union.surface_area()
    print(f"cubes {len(lowers)} of edge {edge}\nstatus {status}, triangles {triangles}")
    print(f"volume {volume!r}\narea {area!r}\n{seconds}")
    for name, found, exact in [("volume", volume, args.volume), ("area", area, args.area)]:
        if exact is not None:
            off = abs(Fraction(found) - exact) / exact
            print(f"{name} off by {float(off):.2e} of the exact one")


if __name__ == "__main__":
    main()
