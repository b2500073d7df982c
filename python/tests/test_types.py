# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What type checkers are told is what is there."""

import ast
import dataclasses
import inspect
import pathlib
import re

import counterpart3d as cp
import pytest
from counterpart3d import _core

FOLDER = pathlib.Path(cp.__file__).parent


def public(names):
    return {name for name in names if not name.startswith("_")}


def test_the_stub_names_what_the_module_has():
    tree = ast.parse((FOLDER / "_core.pyi").read_text())
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    values = {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)}
    assert public({*classes, *functions, *values}) == public(vars(_core))
    for name, node in classes.items():
        members = {child.name for child in node.body if isinstance(child, ast.FunctionDef)}
        assert public(members) == public(vars(getattr(_core, name))), name


def test_the_package_is_marked_as_typed():
    assert (FOLDER / "py.typed").exists()


def test_the_page_lists_everything():
    """docs/python.md is read in the repository: of each function the first line of its help; results by name."""
    page = pathlib.Path(__file__).parent.parent.parent / "docs" / "python.md"
    if not page.exists():
        pytest.skip("not in the repository")
    text = page.read_text()
    listed = dict(re.findall(r"^- `(\w+)`: (.*(?:\n  .*)*)$", text, re.MULTILINE))
    results = re.findall(r"`(\w+)`", " ".join(re.findall(r"^Results: [^.]*", text, re.MULTILINE)))
    values = {name: getattr(cp, name) for name in cp.__all__}
    expected = {name for name, value in values.items() if inspect.isfunction(value) or inspect.isclass(value)}
    assert sorted([*listed, *results]) == sorted(expected)
    for name, words in listed.items():
        assert words.split() == inspect.getdoc(values[name]).split("\n\n")[0].split(), name


def test_help_describes_every_field():
    for name in cp.__all__:
        value = getattr(cp, name)
        if dataclasses.is_dataclass(value):
            described = re.findall(r"^(\w+) : \S.*\n    \S", inspect.getdoc(value), re.MULTILINE)
            assert described == [field.name for field in dataclasses.fields(value)], name
        elif inspect.isclass(value):
            for member, what in vars(value).items():
                if (not member.startswith("_") and isinstance(what, (property, classmethod))) or inspect.isfunction(
                    what
                ):
                    assert member.startswith("_") or inspect.getdoc(getattr(value, member)), f"{name}.{member}"


def test_mypy_refuses_what_is_no_mesh(tmp_path):
    """Only if mypy is here: the types must refuse what the functions refuse, and let through what they take."""
    api = pytest.importorskip("mypy.api")
    file = tmp_path / "calls.py"
    file.write_text(
        """import numpy as np
import counterpart3d as cp

v, t = cp.make_icosphere(1)
shape = cp.SpectralShape((v, t))
found = cp.match(shape, (v, t), initial=cp.SurfaceMap(t[:, 0], v))
cp.match("a.obj", [v, t])
cp.evaluate(cp.reorder("a.obj", "b.obj"), shape, found, ([0, 1], [2, 3]))
cp.map_quality((v, t), (v, t), [0, 1, 2])
np.asarray(found)
cp.match(3, (v, t))
cp.match((v, t), None)
cp.map_quality((v, t), (v, t), 3.5)
"""
    )
    shown, _, _ = api.run([str(file), "--no-incremental", "--cache-dir", str(tmp_path), "--strict"])
    wrong = [int(line.split(":")[1]) for line in shown.splitlines() if ": error:" in line]
    assert wrong == [11, 12, 13], shown


def test_every_function_and_class_says_what_it_does():
    for name in cp.__all__:
        value = getattr(cp, name)
        if inspect.isfunction(value) or (inspect.isclass(value) and value.__module__.startswith("counterpart3d")):
            assert value.__doc__ and not value.__doc__.startswith(name + "("), name
            if inspect.isfunction(value) and len(inspect.signature(value).parameters) > 4:
                assert "Parameters\n" in value.__doc__, name
