"""The package `shewchuk` on all rows about input points: it is wrong only where doubles underflow or overflow."""

import shewchuk
from predicament_vectors import points, sign, vectors

PREDICATES = {"orient2d": shewchuk.orientation, "incircle": shewchuk.incircle_test}


def test_shewchuk_is_right_within_its_range():
    asked, wrong = 0, 0
    for row in vectors():
        args = points(row)
        if args is None or row["predicate"] not in PREDICATES or len(args[0]) != 2:
            continue
        asked += 1
        a, b, c, *rest = args
        # `incircle_test` takes the point first and the circle after it; `orientation` is the turn of three points.
        got = PREDICATES[row["predicate"]](*(x for p in (*rest, a, b, c) for x in p))
        if got != sign(row):
            wrong += 1
            assert {"underflow", "overflow"} & set(row["flags"]), (row["id"], got, row)
    print(f"shewchuk: {wrong} of {asked} wrong")
    assert asked > 6000 and wrong > 0
