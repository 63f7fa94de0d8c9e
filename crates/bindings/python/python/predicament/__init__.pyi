from ._arrays import compare as compare
from ._arrays import exact_value as exact_value
from ._arrays import incircle as incircle
from ._arrays import insphere as insphere
from ._arrays import orient2d as orient2d
from ._arrays import orient3d as orient3d
from ._cases import Cases as Cases
from ._cases import cases as cases
from ._cases import families as families
from ._check import Findings as Findings
from ._check import check as check
from ._conforms import NonConformity as NonConformity
from ._conforms import conforms as conforms
from ._run import Gate as Gate
from ._run import Report as Report
from ._run import Run as Run
from ._run import ToolError as ToolError
from ._run import run as run
from ._run import tool as tool
from ._scene import Scene as Scene
from ._table import Table as Table

__version__: str
__all__ = [
    "__version__",
    "Cases",
    "Findings",
    "Gate",
    "NonConformity",
    "Report",
    "Run",
    "Scene",
    "Table",
    "ToolError",
    "cases",
    "check",
    "compare",
    "conforms",
    "exact_value",
    "families",
    "incircle",
    "insphere",
    "orient2d",
    "orient3d",
    "run",
    "tool",
]
