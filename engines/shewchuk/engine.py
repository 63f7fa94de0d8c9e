"""The predicates of the Python package shewchuk."""

import sys

sys.path.insert(0, "../python")

import predicament_engine
import shewchuk


class Shewchuk:
    name = "shewchuk"
    version = shewchuk.__version__
    zero = "exact"

    def orient2d(self, a, b, c):
        return shewchuk.orientation(*a, *b, *c)

    def incircle(self, a, b, c, d):
        return shewchuk.incircle_test(*d, *a, *b, *c)


predicament_engine.serve(Shewchuk())
