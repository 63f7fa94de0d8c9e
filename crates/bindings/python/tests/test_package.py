"""The package as a whole: names, stubs, docstrings, tables."""

import ast
import inspect
from pathlib import Path

import pytest

import predicament
from predicament import _native

FOLDER = Path(predicament.__file__).parent


def test_every_name_has_a_docstring_and_a_stub():
    stubs = (FOLDER / "__init__.pyi").read_text()
    for name in predicament.__all__:
        value = getattr(predicament, name)
        assert f"import {name} as {name}\n" in stubs or name == "__version__", name
        assert name == "__version__" or inspect.getdoc(value), name
        if inspect.isclass(value):
            public = [member for key, member in vars(value).items() if not key.startswith("_")]
            for member in public:
                if callable(member) or isinstance(member, property):
                    assert inspect.getdoc(member), (name, member)
    assert set(dir(predicament)) == set(predicament.__all__)
    with pytest.raises(AttributeError, match="no attribute 'orient4d'"):
        predicament.orient4d


def test_the_stubs_of_the_native_module_name_what_it_has():
    tree = ast.parse((FOLDER / "_native.pyi").read_text())
    named = {node.name for node in tree.body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
    named |= {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)}
    has = {name for name in dir(_native) if not name.startswith("__")} | {"__version__"}
    assert named == has
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            text = getattr(_native, node.name).__text_signature__
            words = [word.strip() for word in text.strip("()").split(",") if word.strip()]
            assert words == [one.arg for one in node.args.args], node.name
    assert (FOLDER / "py.typed").exists()


def test_tables():
    table = predicament.Table([{"a": 1, "b": None}, {"a": 2, "b": "<"}] * 15)
    assert table.columns == ["a", "b"] and table.column("a") == [1, 2] * 15
    assert "<td>&lt;</td>" in table._repr_html_() and "20 of 30 rows" in table._repr_html_()
    assert predicament.Table([], ["c"]).columns == ["c"]
    pandas = pytest.importorskip("pandas")
    assert list(pandas.DataFrame(table).columns) == list(table.to_pandas().columns) == ["a", "b"]
