"""The tutorial, executed: by nbclient where it is installed with a kernel, else cell by cell in this process."""

import ast
import json
from importlib.util import find_spec
from pathlib import Path

import pytest

NOTEBOOK = Path(__file__).parents[1] / "notebooks" / "tutorial.ipynb"


def code_cells():
    cells = json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]


def test_the_notebook_has_no_outputs():
    for cell in json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]:
        assert not cell.get("outputs") and cell.get("execution_count") is None


def test_the_tutorial_runs_in_a_kernel():
    nbclient = pytest.importorskip("nbclient", reason="nbclient is missing: the cells run without a kernel")
    pytest.importorskip("ipykernel", reason="ipykernel is missing: the cells run without a kernel")
    import nbformat

    notebook = nbformat.read(NOTEBOOK, as_version=4)
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3").execute()
    last = [cell for cell in notebook.cells if cell.cell_type == "code"][-1]
    assert "<iframe srcdoc" in last.outputs[-1].data["text/html"], "the report is shown inline"


HAS_KERNEL = all(find_spec(name) for name in ("nbclient", "ipykernel"))


@pytest.mark.skipif(HAS_KERNEL, reason="the cells have run in a kernel, by nbclient")
def test_the_cells_run():
    """The same as in a kernel: the last expression of a cell is shown, as HTML if it has HTML."""
    scope = {"__name__": "__main__"}
    shown = []
    for source in code_cells():
        tree = ast.parse(source)
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, "cell", "exec"), scope)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), "cell", "eval"), scope)
            shown.append(value._repr_html_() if hasattr(value, "_repr_html_") else repr(value))
    assert len(shown) > 8 and shown[-1].startswith("<iframe srcdoc=")
