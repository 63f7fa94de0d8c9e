"""Predicates with planted faults."""

import numpy as np


def naive_orient2d(a, b, c):
    """Plain doubles, vectorised or scalar."""
    return (a[..., 0] - c[..., 0]) * (b[..., 1] - c[..., 1]) - (a[..., 1] - c[..., 1]) * (b[..., 0] - c[..., 0])


def cast_orient2d(a, b, c):
    """A cast to single precision before an exact predicate."""
    import predicament

    return predicament.orient2d(*[np.asarray(point, dtype=np.float32) for point in (a, b, c)])
