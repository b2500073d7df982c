# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""From a folder to a collection, stage by stage. What a stage has made before is not made again."""

from __future__ import annotations

import os
import pathlib
from typing import Any

import numpy as np

from .. import InvalidInput, IoError, Landmarks, SurfaceMap, read
from .agreement import disagreement
from .choice import Network, network_of
from .correspondence import corners_of
from .folder import MeshFile, mesh_file, meshes_in
from .made import Made
from .outputs import write_manifest, write_outputs
from .points import checked_landmarks, on_template, require_on, semi_landmarks, specimen_of
from .quality import quality
from .report import shown, write_report
from .rounds import Registered, agreed_specimens, registered_specimens
from .runner import Progress, Runner
from .settings import Settings
from .specimens import Specimen, prepared_specimens
from .statistics import Model, compactness, generalization, principal_modes, specificity
from .store import Store


def build(folder: str, out: str, settings: Settings, runner: Runner, progress: Progress) -> Made:
    """Make a collection of the meshes in a folder, and write it.

    Raises
    ------
    InvalidInput
        The folder holds fewer than two meshes that can be used, or an option does not fit it.
    OSError
        A result cannot be written.
    """
    target = pathlib.Path(out)
    refuse_inside(target, folder)
    store = Store(os.path.abspath(target / "work"))
    files = meshes_in(folder)
    apart = _template_apart(files.meshes, settings)
    named = _landmarks_on([*files.meshes, *apart], files.left_out, settings)
    _make_folder(target)
    specimens, left_out = prepared_specimens(runner, store, [*files.meshes, *apart], progress)
    left_out = {**files.left_out, **left_out}
    _refuse_landmarks_on(named, left_out, settings)
    root = _root(specimens, settings)
    found = len(specimens) - len(apart)
    if found < 2:
        why = _first(left_out, found)
        raise InvalidInput(f"{folder}: a collection needs two meshes or more that can be used; {why}")
    alone = root if apart else None
    network = network_of(runner, store, specimens, settings, progress, root, alone)
    template = network.tree.root
    strange = {specimens[i].name: why for i, why in network.strangers.items() if i != template}
    _refuse_landmarks_on(named, strange, settings)
    progress.say(f"{specimens[template].name} is the template")
    registered = registered_specimens(runner, store, specimens, network, settings, progress, alone)
    registered = agreed_specimens(runner, store, specimens, network, settings, registered, progress)
    model = principal_modes(registered.alignment.aligned, registered.triangles, registered.weights)
    between = disagreement(store, specimens, network, registered)
    rows = quality(store, specimens, network, registered, model, between, left_out)
    points, landmarks = _points(store, specimens, network, registered, model, settings, named)
    made = Made(store, settings, specimens, left_out, network, registered, model, between, rows, points, landmarks)
    measures = measured(made)
    write_outputs(made, target, measures, progress)
    write_report(shown(made, measures), target / "report.html", progress)
    write_manifest(made, target, measures)
    return made


def refuse_inside(out: pathlib.Path, folder: str) -> None:
    """What is written must not be read as specimens by the next run, nor lie among them.

    Raises
    ------
    InvalidInput
        The output is the folder of the meshes, or in it.
    """
    target, source = out.resolve(), pathlib.Path(folder).resolve()
    if target == source or source in target.parents:
        raise InvalidInput(f"{out}: lies in {folder}, the folder of the meshes: write to another folder")


def _make_folder(out: pathlib.Path) -> None:
    try:
        out.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError):
        raise InvalidInput(f"{out}: is a file, or lies in one: write to a folder") from None


def measured(made: Made) -> dict[str, Any]:
    """What is said of the collection as a whole."""
    aligned = made.registered.alignment.aligned
    held_out = [made.between[edge] for edge in made.network.held_out if edge in made.between]
    seen = [error for edge, error in made.between.items() if edge not in made.network.held_out]
    share = compactness(made.model)
    specific = specificity(aligned, made.model)
    result: dict[str, Any] = {
        "specimens": len(made.registered.members),
        "left_out": len(made.quality) - len(made.registered.members),
        "pairs_matched": len(made.network.families),
        "pairs_failed": len(made.network.failures),
        "rounds": len(made.registered.movement),
        "last_movement_of_the_mean": made.registered.movement[-1],
        "modes_for_95_percent": int(np.searchsorted(share, 0.95) + 1) if len(share) else 0,
        "specificity": float(specific.mean()),
    }
    result["held_out_pairs"] = len(held_out)
    if held_out:
        result["held_out_cycle_error"] = float(np.median(held_out))
    if seen:
        result["cycle_error"] = float(np.median(seen))
    if len(aligned) > 2:
        result["generalization"] = float(generalization(aligned, made.model).mean())
    return result


def _template_apart(files: list[MeshFile], settings: Settings) -> list[MeshFile]:
    """The template, unless it is one of the specimens."""
    if settings.template is None:
        return []
    template = mesh_file(settings.template)
    if any(file.content == template.content for file in files):
        return []
    if any(file.name == template.name for file in files):
        template = MeshFile(f"template {template.name}", template.path, template.content)
    return [template]


def _root(specimens: list[Specimen], settings: Settings) -> int | None:
    if settings.template is None:
        return None
    content = mesh_file(settings.template).content
    for i, specimen in enumerate(specimens):
        if specimen.file.content == content:
            return i
    raise InvalidInput(f"{settings.template}: the template cannot be used")


def _landmarks_on(files: list[MeshFile], left_out: dict[str, str], settings: Settings) -> str | None:
    """The specimen that the landmarks are on, before any work is done."""
    if settings.landmarks is None:
        return None
    landmarks = checked_landmarks(settings.landmarks, settings.landmark_axes)
    name = specimen_of(settings.landmarks, [*(file.name for file in files), *left_out])
    _refuse_landmarks_on(name, left_out, settings)
    try:
        mesh = read(next(file.path for file in files if file.name == name))
    except (InvalidInput, IoError):
        return name  # which is said where the meshes are prepared
    try:
        require_on(landmarks.points, mesh)
    except InvalidInput as error:
        raise InvalidInput(f"{settings.landmarks}: {error}") from None
    return name


def _refuse_landmarks_on(name: str | None, left_out: dict[str, str], settings: Settings) -> None:
    if name is not None and name in left_out:
        raise InvalidInput(f"{settings.landmarks}: {name}, which they are on, is left out: {left_out[name]}")


def _points(
    store: Store,
    specimens: list[Specimen],
    network: Network,
    registered: Registered,
    model: Model,
    settings: Settings,
    named: str | None,
) -> tuple[dict[str, SurfaceMap], Landmarks | None]:
    """Points of the template, by name: those that were given, then the evenly spread ones."""
    points: dict[str, SurfaceMap] = {}
    landmarks = None
    if settings.landmarks is not None:
        landmarks = checked_landmarks(settings.landmarks, settings.landmark_axes)
        i = [specimen.name for specimen in specimens].index(named or "")
        if i in registered.members:
            fitted = store.get("registrations", registered.keys[registered.members.index(i)])["vertices"]
        elif i == network.tree.root:
            fitted = specimens[i].shape(store)["vertices"]
        else:
            raise InvalidInput(f"{settings.landmarks}: {named}, which they are on, could not be registered")
        points |= on_template(landmarks, fitted * ([-1, 1, 1] if network.mirrored[i] else 1), registered.triangles)
    if settings.semi:
        corners = corners_of(registered.triangles, len(model.mean))
        digits = len(str(settings.semi))
        for k, v in enumerate(semi_landmarks(model.mean, settings.semi)):
            points[f"semi{k + 1:0{digits}d}"] = SurfaceMap(corners[[v], 0], np.eye(3)[corners[[v], 1]])
    return points, landmarks


def _first(left_out: dict[str, str], found: int) -> str:
    only = "there is only one" if found else "there is none beside the template"
    return next((f"{name}: {why}" for name, why in left_out.items()), only)
