# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""An empty file of Blender's for each test, with the extension registered."""

import importlib.util
import pathlib
import sys

import bpy
import characters
import pytest

EXTENSION = pathlib.Path(__file__).resolve().parents[2] / "apps" / "blender"


def load_extension(folder=EXTENSION, name="counterpart_extension"):
    spec = importlib.util.spec_from_file_location(name, folder / "__init__.py", submodule_search_locations=[str(folder)])
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


extension = load_extension()


@pytest.fixture(scope="session", autouse=True)
def registered():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    extension.register()
    yield
    extension.unregister()


@pytest.fixture(autouse=True)
def empty_file():
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)


@pytest.fixture
def hero():
    return characters.make_character()[0]
