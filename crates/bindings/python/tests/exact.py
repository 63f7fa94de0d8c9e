"""The predicates by their definitions, in fractions: another truth than the judge of the harness."""

from fractions import Fraction
from itertools import permutations


def determinant(rows):
    """The determinant by the sum over all permutations."""
    total = Fraction(0)
    for columns in permutations(range(len(rows))):
        inversions = sum(a > b for i, a in enumerate(columns) for b in columns[i + 1 :])
        product = Fraction(-1 if inversions % 2 else 1)
        for row, column in zip(rows, columns):
            product *= row[column]
        total += product
    return total


def value(predicate, points):
    """The value of a predicate's determinant; `compare` takes points of one coordinate."""
    *others, last = [[Fraction(float(x)) for x in point] for point in points]
    rows = [[x - o for x, o in zip(point, last)] for point in others]
    if predicate in ("incircle", "insphere"):
        rows = [[*row, sum(x * x for x in row)] for row in rows]
    return determinant(rows)


def sign(predicate, points):
    """-1, 0 or 1."""
    exact = value(predicate, points)
    return (exact > 0) - (exact < 0)
