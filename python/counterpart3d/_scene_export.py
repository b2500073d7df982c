# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Run by Blender, not imported: opens a scene and saves it in a format that this package reads.

Arguments: the scene, the folder to save in, 1 if polygons matter more than materials, 1 if other folders may be read.
What fails is written to `error.txt` in that folder: Blender itself also prints what is no failure.
"""

import pathlib
import sys

import bpy  # type: ignore[import-not-found,unused-ignore]


def main(scene: pathlib.Path, folder: pathlib.Path, polygons: bool, allow_external: bool) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    if scene.suffix.lower().startswith(".usd") and not allow_external:
        refuse_other_layers(scene)
    open_scene(scene)
    if not allow_external:
        leave_out_others(scene.parent)
    meshes = [thing for thing in bpy.context.scene.objects if thing.type == "MESH"]
    if not any(thing.data.polygons for thing in meshes):
        raise RuntimeError("it has no mesh with faces")
    moving = any(thing.data.shape_keys or thing.find_armature() for thing in meshes)
    triangles = all(len(polygon.vertices) == 3 for thing in meshes for polygon in thing.data.polygons)
    if moving or (triangles and not polygons):
        bpy.ops.export_scene.gltf(filepath=str(folder / "scene.glb"), export_format="GLB", use_active_scene=True)
    else:
        bpy.ops.wm.obj_export(
            filepath=str(folder / "scene.obj"), apply_modifiers=False, export_colors=True, path_mode="STRIP"
        )


def open_scene(scene: pathlib.Path) -> None:
    """Open it in the empty session; scripts that it holds are not run."""
    path = str(scene)
    ending = scene.suffix.lower()
    if ending == ".blend":
        bpy.ops.wm.open_mainfile(filepath=path, load_ui=False, use_scripts=False)
    elif ending == ".fbx" and hasattr(bpy.types, "WM_OT_fbx_import"):  # from Blender 4.5 on; knows text too
        bpy.ops.wm.fbx_import(filepath=path)
    elif ending == ".fbx":
        bpy.ops.import_scene.fbx(filepath=path)
    elif ending == ".abc":
        bpy.ops.wm.alembic_import(filepath=path, as_background_job=False)
    else:
        bpy.ops.wm.usd_import(filepath=path)


def refuse_other_layers(scene: pathlib.Path) -> None:
    """USD composes a scene from several files while it opens it."""
    getattr(bpy.utils, "expose_bundled_modules", lambda: None)()
    from pxr import UsdUtils  # type: ignore[import-not-found,unused-ignore]

    layers, _, _ = UsdUtils.ComputeAllDependencies(str(scene))
    for layer in layers:
        if layer.realPath and not pathlib.Path(layer.realPath).resolve().is_relative_to(scene.parent.resolve()):
            raise RuntimeError(f"it takes parts from {layer.realPath}, which allow_external permits")


def leave_out_others(folder: pathlib.Path) -> None:
    """Drop what the scene has taken from files outside of its folder."""

    def is_inside(path: str, library: object) -> bool:
        return pathlib.Path(bpy.path.abspath(path, library=library)).resolve().is_relative_to(folder.resolve())

    for library in list(bpy.data.libraries):
        if not is_inside(library.filepath, None):
            bpy.data.libraries.remove(library)
    for image in list(bpy.data.images):
        if image.packed_file is None and image.filepath and not is_inside(image.filepath, image.library):
            bpy.data.images.remove(image)


if __name__ == "__main__":
    scene, folder, polygons, allow_external = sys.argv[-4:]
    try:
        main(pathlib.Path(scene), pathlib.Path(folder), polygons == "1", allow_external == "1")
    except Exception as error:
        lines = [line.removeprefix("Error: ") for line in str(error).splitlines() if line.strip()]
        pathlib.Path(folder, "error.txt").write_text(lines[0] if lines else type(error).__name__, encoding="utf-8")
