# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What `--add` writes: the new specimens beside the old ones, under the model as it is."""

from __future__ import annotations

import csv
import dataclasses
import pathlib
from typing import Any

import numpy as np

from .. import SurfaceMap, write, write_landmarks, write_map
from .._arrays import FloatArray
from .._landmarks import Axes
from .correspondence import positions, template_points
from .folder import MeshFile, in_natural_order, meshes_in
from .joining import join, joined_key
from .made import scattered
from .procrustes import aligned_to, moved, size_of_aligned
from .quality import Row, row_of, worst_first
from .report import Shown, write_report
from .runner import Progress, Runner
from .shapes import mesh_of, shape_key
from .specimens import prepared_specimens
from .statistics import Model, distances_from_mean, outliers
from .store import Arrays, Store, whole_file
from .tables import write_quality, write_table
from .written import claim, claimed, specimen_files, write_content


@dataclasses.dataclass(frozen=True)
class Base:
    """The collection that is joined."""

    folder: pathlib.Path
    store: Store
    content: dict[str, Any]
    arrays: dict[str, np.ndarray]
    model: Model


def add(base: Base, folder: str, runner: Runner, progress: Progress) -> None:
    """Register the meshes of a folder that the collection does not have, and write them, the tables and the report.

    The mean, the modes, ShapeWorks' project, and what was written of the others stay.
    """
    known = {member["content"] for member in base.content["members"]}
    names = {member["name"] for member in base.content["members"]}
    found = meshes_in(folder)
    files = [
        dataclasses.replace(file, name=_free(file.name, names)) for file in found.meshes if file.content not in known
    ]
    specimens, left_out = prepared_specimens(runner, base.store, files, progress)
    members = [(m["shape"], m["registration"], bool(m["mirrored"])) for m in base.content["members"]]
    template, usual = base.content["template"], base.content["usual_confidence"]
    items = [(base.store, template, specimen.file.content, members, usual) for specimen in specimens]
    left_out = {**{_free(name, names): why for name, why in found.left_out.items()}, **left_out}
    joined: list[MeshFile] = []
    progress.start()
    for done, (i, message) in enumerate(runner.outcomes(join, items)):
        if message is None:
            joined.append(specimens[i].file)
        else:
            left_out[specimens[i].name] = message
            progress.say(f"{specimens[i].name} is left out: {message}")
        progress.step("joined", done + 1, len(items))
    _write(base, sorted(joined, key=lambda file: in_natural_order(file.name)), left_out, progress)


def _free(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_added"
    return name


def _write(base: Base, joined: list[MeshFile], left_out: dict[str, str], progress: Progress) -> None:
    """A run that is killed here changes nothing: what collection.json, written last, does not name does not count."""
    old, points = base.content["members"], bool(base.content["points"])
    claim(base.folder, (name for file in joined for name in specimen_files(file.name, points=points)), base.content)
    size = None if base.content["keep_size"] else size_of_aligned(base.arrays["matrices"], base.arrays["sizes"])
    members, scores, sizes, matrices, distances = [], [], [], [], list(distances_from_mean(base.model))
    for file in joined:
        registration = str(_found(base, file)["registration"])
        vertices = base.store.get("registrations", registration)["vertices"]
        matrix = aligned_to(vertices, base.model.mean, base.model.weights, size=size)
        aligned = moved(matrix, vertices)
        scores.append(base.model.project(aligned))
        distances.append(float(np.sqrt(base.model.weights @ ((aligned - base.model.mean) ** 2).sum(axis=1))))
        centered = vertices - base.model.weights @ vertices
        sizes.append(float(np.sqrt(base.model.weights @ (centered**2).sum(axis=1))))
        matrices.append(matrix)
        members.append(_written_specimen(base, file, registration, vertices))
    arrays = {**base.arrays, "names": np.array([member["name"] for member in [*old, *members]])}
    for name, rows in (("scores", scores), ("sizes", sizes), ("matrices", matrices)):
        if rows:
            arrays[name] = np.concatenate([arrays[name], np.stack([np.asarray(row) for row in rows])])
    quality = _quality(base, joined, np.array(distances), left_out)
    content = {
        **base.content,
        "members": [*old, *members],
        "left_out": {row["subject"]: row["remark"] for row in quality if "mean_dist" not in row},
        "measures": {
            **base.content["measures"],
            "specimens": len(old) + len(members),
            "left_out": len(quality) - len(old) - len(members),
        },
        "quality": quality,
        "files": sorted(claimed(base.folder)),
    }
    with whole_file(base.folder / "model.npz") as out:
        np.savez_compressed(out, **arrays)  # type: ignore[arg-type]
    _extend_scores(base.folder / "scores.csv", len(old), [file.name for file in joined], sizes, scores)
    write_quality(base.folder / "quality.csv", quality)
    write_table(base.folder / "measures.csv", ["measure", "value"], content["measures"].items())
    write_report(_shown(base, content, arrays), base.folder / "report.html", progress)
    write_content(base.folder, content)


def _shown(base: Base, content: dict[str, Any], arrays: dict[str, np.ndarray]) -> Shown:
    """What the report shows of the collection with the new ones."""
    members = content["members"]

    def aligned(place: int) -> FloatArray:
        return moved(
            arrays["matrices"][place], base.store.get("registrations", members[place]["registration"])["vertices"]
        )

    return Shown(
        dataclasses.replace(base.model, scores=arrays["scores"]),
        [member["name"] for member in members],
        aligned,
        content["quality"],
        content["notices"],
        content["pairs"],
        content["measures"],
        content["mirror"],
    )


def _found(base: Base, file: MeshFile) -> Arrays:
    return base.store.get("joined", joined_key(base.content["template"], file.content))


def _quality(base: Base, joined: list[MeshFile], distances: FloatArray, left_out: dict[str, str]) -> list[Row]:
    """The table with the new ones, whose distances from the mean come last."""
    unusual = outliers(distances)[len(distances) - len(joined) :]
    rows: list[Row] = [{"subject": name, "remark": why} for name, why in left_out.items()]
    for file, value in zip(joined, unusual, strict=True):
        found = _found(base, file)
        fit = base.store.get("registrations", str(found["registration"]))
        shape = base.store.get("shapes", shape_key(file.content))
        rows.append(row_of(file.name, fit, shape, found["errors"].tolist(), float(value), mirrored=False))
    said = {row["subject"] for row in rows}  # of a file that was left out before too
    old = [row for row in base.content["quality"] if "mean_dist" in row or row["subject"] not in said]
    return worst_first([*old, *rows])


def _written_specimen(base: Base, file: MeshFile, registration: str, vertices: FloatArray) -> dict[str, Any]:
    """Writes its files; returns its entry in collection.json."""
    triangles = base.model.triangles
    shape, fit = base.store.get("shapes", shape_key(file.content)), base.store.get("registrations", registration)
    write((vertices, triangles), base.folder / "meshes" / f"{file.name}.ply")
    points = template_points(mesh_of(shape), vertices, triangles, fit["template_from_scan"])
    write_map(scattered(points, shape["used"], int(shape["n_in_file"])), base.folder / "maps" / f"{file.name}.txt")
    marks = {}
    for name, p in base.content["points"].items():
        point = SurfaceMap(np.array([p["triangle"]], np.int32), np.array([p["weights"]]))
        marks[name] = positions(point, vertices, triangles)[0]
    if marks:
        axes: Axes = "RAS" if base.content["axes"] == "RAS" else "LPS"
        write_landmarks(marks, base.folder / "landmarks" / f"{file.name}.mrk.json", axes=axes)
    return {
        "name": file.name,
        "file": file.path,
        "content": file.content,
        "shape": shape_key(file.content),
        "registration": registration,
        "mirrored": False,
    }


def _extend_scores(
    path: pathlib.Path, n_before: int, names: list[str], sizes: list[float], scores: list[FloatArray]
) -> None:
    with path.open(newline="") as file:
        rows = list(csv.reader(file))
    new = [[name, size, *row] for name, size, row in zip(names, sizes, scores, strict=True)]
    write_table(path, rows[0], [*rows[1 : n_before + 1], *new])
