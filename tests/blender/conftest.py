# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""A file of Blender's with the character for each test, and the extension registered."""

import importlib.util
import os
import pathlib
import sys

import bpy
import characters
import pytest

ROOT = pathlib.Path(__file__).parents[2]
EXTENSION = pathlib.Path(os.environ.get("COUNTERPART_EXTENSION") or ROOT / "apps" / "blender")


def load_extension(folder=EXTENSION, name="counterpart_extension"):
    folder = pathlib.Path(folder).resolve()
    spec = importlib.util.spec_from_file_location(
        name, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
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
    extension.unregister()  # Blender's module does not end while classes are registered


@pytest.fixture(scope="session")
def hero_file(tmp_path_factory):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    characters.make_character()
    file = str(tmp_path_factory.mktemp("files") / "hero.blend")
    bpy.ops.wm.save_as_mainfile(filepath=file)
    return file


@pytest.fixture
def hero(hero_file):
    bpy.ops.wm.open_mainfile(filepath=hero_file)
    return bpy.data.objects["Hero"]
