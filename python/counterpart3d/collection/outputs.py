# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Everything that is written for people and other programs."""

from __future__ import annotations

import pathlib
from typing import Any

import numpy as np

from .. import SurfaceMap, write, write_landmarks, write_map
from .._arrays import FloatArray
from .made import Made, Member
from .report import worst_pairs
from .runner import Progress
from .shapeworks import particle_files, write_shapeworks
from .statismo import statismo_is_written, write_statismo
from .store import whole_file
from .tables import write_tables
from .written import claim, remove_others, specimen_files, write_content

N_MODE_MESHES, SIGMAS = 5, (-2, 2)
FORMAT = 1  # of collection.json


def write_outputs(made: Made, out: pathlib.Path, measures: dict[str, Any], progress: Progress) -> None:
    """All but the report and `collection.json`, which `write_manifest` writes last.

    What that of an earlier run says does not hold for what is written now, so only its list of files stays, until all
    is written; those that are not written again go first.
    """
    files = files_of(made)
    claim(out, files, {"format": FORMAT})
    remove_others(out, files)
    for name in ("meshes", "maps", "modes", "landmarks"):
        (out / name).mkdir(parents=True, exist_ok=True)
    progress.start()
    members = made.members()
    carried: dict[str, dict[str, FloatArray]] = {}
    for done, member in enumerate(members):
        write(member.mesh(), out / "meshes" / f"{member.name}.ply")
        write_map(member.template_points(), out / "maps" / f"{member.name}.txt")
        if made.points:
            carried[member.name] = _write_points(made, member, out)
        progress.step("written", done + 1, len(members))
    if carried:
        write_tps(carried, out / "landmarks.tps")
    write((made.model.mean, made.model.triangles), out / "mean.ply")
    for k in range(min(N_MODE_MESHES, len(made.model.variances))):
        for sigma in SIGMAS:
            scores = np.zeros(k + 1)
            scores[k] = sigma * np.sqrt(made.model.variances[k])
            write((made.model.shape(scores), made.model.triangles), out / mode_file(k, sigma))
    write_model(made, out / "model.npz")
    write_tables(made, out, measures)
    write_shapeworks(made, out)
    write_statismo(made.model, out / "model.h5")


def files_of(made: Made) -> set[str]:
    """Those that another run may not write: of specimens, modes and landmarks."""
    files = {mode_file(k, sigma) for k in range(min(N_MODE_MESHES, len(made.model.variances))) for sigma in SIGMAS}
    for member in made.members():
        files |= specimen_files(member.name, points=bool(made.points)) | particle_files(member.name)
    return files | ({"landmarks.tps"} if made.points else set()) | ({"model.h5"} if statismo_is_written() else set())


def mode_file(k: int, sigma: int) -> str:
    return f"modes/mode{k + 1}_{'plus' if sigma > 0 else 'minus'}_{abs(sigma)}.ply"


def _write_points(made: Made, member: Member, out: pathlib.Path) -> dict[str, FloatArray]:
    names = list(made.points)
    joined = SurfaceMap(
        np.concatenate([p.triangle for p in made.points.values()]),
        np.concatenate([p.weights for p in made.points.values()]),
    )
    found = dict(zip(names, member.at(joined), strict=True))
    axes = (made.landmarks.axes if made.landmarks else None) or "LPS"
    write_landmarks(found, out / "landmarks" / f"{member.name}.mrk.json", axes=axes)
    return found


def write_tps(carried: dict[str, dict[str, FloatArray]], path: pathlib.Path) -> None:
    """All specimens in one file, for geomorph."""
    lines = []
    for name, points in carried.items():
        lines += [f"LM3={len(points)}", *(" ".join(f"{x:.9g}" for x in p) for p in points.values()), f"ID={name}"]
    with whole_file(path) as file:
        file.write(("\n".join(lines) + "\n").encode())


def write_model(made: Made, path: pathlib.Path) -> None:
    model = made.model
    with whole_file(path) as file:
        np.savez_compressed(
            file,
            mean=model.mean,
            triangles=model.triangles,
            weights=model.weights,
            modes=model.modes,
            variances=model.variances,
            scores=model.scores,
            names=np.array([member.name for member in made.members()]),
            matrices=made.registered.alignment.matrices,
            sizes=made.registered.alignment.sizes,
        )


def write_manifest(made: Made, out: pathlib.Path, measures: dict[str, Any]) -> None:
    """collection.json: what the collection is made of; `Collection` reads it."""
    content = {
        "format": FORMAT,
        "keep_size": made.settings.same_scale,
        "mirror": made.settings.mirror == "auto",
        "template": made.registered.template,
        "root": made.specimens[made.network.tree.root].name,
        "usual_confidence": made.network.usual_confidence,
        "members": [
            {
                "name": member.name,
                "file": member.specimen.file.path,
                "content": member.specimen.file.content,
                "shape": member.specimen.key,
                "registration": member.key,
                "mirrored": member.mirrored,
            }
            for member in made.members()
        ],
        "left_out": {row["subject"]: row["remark"] for row in made.quality if "mean_dist" not in row},
        "points": {
            name: {"triangle": int(p.triangle[0]), "weights": [float(x) for x in p.weights[0]]}
            for name, p in made.points.items()
        },
        "axes": made.landmarks.axes if made.landmarks else None,
        "measures": measures,
        "notices": made.registered.notices,
        "quality": made.quality,
        "pairs": worst_pairs(made),
        "files": sorted(files_of(made)),
    }
    write_content(out, content)
