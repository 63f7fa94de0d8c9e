"""Exact geometric predicates on NumPy arrays, and a test harness for predicates.

* Signs: ``orient2d``, ``orient3d``, ``incircle``, ``insphere``, ``compare``, and ``Scene`` for points by index.
* Values: ``exact_value`` returns a determinant as a ``fractions.Fraction``.
* Tests: ``check`` runs a function on the corpora, ``cases`` makes queries with the truth, ``conforms`` is for pytest.
* Runs: ``run`` and ``Run`` make tables, gates and reports; ``tool`` calls any command of ``python -m predicament``.

NumPy is imported when a function first needs it: the command line tool starts without it.
"""

from importlib import import_module as _import_module

from ._native import __version__

_WHERE = {
    "_arrays": ("compare", "orient2d", "orient3d", "incircle", "insphere", "exact_value"),
    "_scene": ("Scene",),
    "_cases": ("Cases", "cases", "families"),
    "_check": ("Findings", "check"),
    "_conforms": ("NonConformity", "conforms"),
    "_run": ("Gate", "Report", "Run", "ToolError", "run", "tool"),
    "_table": ("Table",),
}
_MODULES = {name: module for module, names in _WHERE.items() for name in names}

__all__ = ["__version__", *sorted(_MODULES)]


def __getattr__(name):
    module = _MODULES.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(_import_module(f".{module}", __name__), name)
    globals()[name] = value
    return value


def __dir__():
    return __all__
