# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What type checkers are told is what is there."""

import ast
import inspect
import pathlib

import counterpart
from counterpart import _core

FOLDER = pathlib.Path(counterpart.__file__).parent


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


def test_every_function_and_class_says_what_it_does():
    for name in counterpart.__all__:
        value = getattr(counterpart, name)
        if inspect.isfunction(value) or (inspect.isclass(value) and value.__module__.startswith("counterpart")):
            assert value.__doc__ and not value.__doc__.startswith(name + "("), name
            if inspect.isfunction(value) and len(inspect.signature(value).parameters) > 4:
                assert "Parameters\n" in value.__doc__, name
