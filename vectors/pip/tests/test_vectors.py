"""The rows by Python's fractions, and the package `shewchuk`, which is wrong only where doubles underflow or overflow."""

import importlib.util
import unittest
from fractions import Fraction

from predicament_vectors import points, sign, vectors

ROWS = vectors()
HAS_PEER = importlib.util.find_spec("shewchuk") is not None


def exactly(predicate, points):
    """The sign of a predicate of points with exact coordinates."""
    *rest, last = points
    rows = [[x - y for x, y in zip(point, last)] for point in rest]
    if predicate in ("incircle", "insphere"):
        rows = [[*row, sum(x * x for x in row)] for row in rows]
    value = determinant(rows)
    return (value > 0) - (value < 0)


def determinant(rows):
    """By the first column."""
    if len(rows) == 1:
        return rows[0][0]
    minor = lambda out: determinant([row[1:] for at, row in enumerate(rows) if at != out])
    return sum((-1) ** at * row[0] * minor(at) for at, row in enumerate(rows) if row[0])


def wrong(rows):
    """Rows whose signs about doubles or decimals are not those of fractions."""
    for row in rows:
        args = points(row)
        is_known = args is not None and "plane" not in row and row["predicate"] != "compare"
        if is_known and exactly(row["predicate"], [[Fraction(x) for x in point] for point in args]) != sign(row):
            yield row["id"]
        elif is_known and row["decimals"] is not None:
            written = [[Fraction(x) for x in row["decimal"][int(vertex)]] for vertex in row["vertices"]]
            if exactly(row["predicate"], written) != sign({"doubles": row["decimals"]}):
                yield row["id"]


class Vectors(unittest.TestCase):
    def test_every_hex_float_is_the_double_of_its_decimal(self):
        for row in ROWS:
            hexes = [[float.fromhex(x) for x in point] for point in row["hex"]]
            self.assertEqual(hexes, [[float(x) for x in point] for point in row["decimal"]], row["id"])

    def test_signs_are_those_of_fractions(self):
        rows = ROWS[::10]
        self.assertEqual(list(wrong(rows)), [])
        for key in ("doubles", "decimals"):
            plain = next(row for row in ROWS if row["predicate"] == "incircle" and row[key] == "+")
            self.assertEqual(list(wrong([plain | {key: "-"}])), [plain["id"]], "a corrupted row is noticed")

    @unittest.skipUnless(HAS_PEER, "NOT RUN: shewchuk is missing; type `pip install vectors/pip[test]`")
    def test_shewchuk_is_right_within_its_range(self):
        import shewchuk

        # `incircle_test` takes the point first and the circle after it; `orientation` is the turn of three points.
        predicates = {"orient2d": shewchuk.orientation, "incircle": shewchuk.incircle_test}
        asked = [row for row in ROWS if row["predicate"] in predicates and "plane" not in row and points(row)]
        errs = []
        for row in asked:
            a, b, c, *rest = points(row)
            if predicates[row["predicate"]](*(x for p in (*rest, a, b, c) for x in p)) != sign(row):
                errs.append(row)
        self.assertEqual([row for row in errs if not {"underflow", "overflow"} & set(row["flags"])], [])
        self.assertTrue(len(asked) > 6000 and errs)
        print(f"shewchuk: {len(errs)} of {len(asked)} wrong")


if __name__ == "__main__":
    unittest.main()
