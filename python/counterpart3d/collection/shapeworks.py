# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The collection as a project of ShapeWorks: its Studio opens it."""

from __future__ import annotations

import json
import pathlib

import numpy as np

from .made import Made
from .procrustes import moved
from .store import whole_file
from .surfaces import farthest_points

N_PARTICLES = 2048


def particle_files(name: str) -> set[str]:
    return {f"shapeworks/particles/{name}_{kind}.particles" for kind in ("local", "world")}


def write_shapeworks(made: Made, out: pathlib.Path) -> None:
    """shapeworks/collection.swproj, and the particles of each specimen in its own frame and in the common one."""
    folder = out / "shapeworks"
    (folder / "particles").mkdir(parents=True, exist_ok=True)
    particles = farthest_points(made.model.mean, N_PARTICLES)
    data = []
    for member in made.members():
        local = member.mesh()[0][particles]
        world = moved(member.matrix, member.fit()["vertices"][particles])
        for kind, points in (("local", local), ("world", world)):
            with whole_file(folder / "particles" / f"{member.name}_{kind}.particles") as file:
                np.savetxt(file, points, fmt="%.9g")
        flip = np.diag([-1.0 if member.mirrored else 1.0, 1, 1, 1])
        data.append(
            {
                "name": member.name,
                "shape_1": f"../meshes/{member.name}.ply",
                "groomed_1": f"../meshes/{member.name}.ply",
                "local_particles_1": f"particles/{member.name}_local.particles",
                "world_particles_1": f"particles/{member.name}_world.particles",
                "alignment_1": " ".join(f"{x:.9g}" for x in (member.matrix @ flip).ravel()),
                "procrustes_1": " ".join(f"{x:.6f}" for x in np.eye(4).ravel()),
            }
        )
    with whole_file(folder / "collection.swproj") as file:
        file.write(json.dumps({"data": data, "landmarks": []}, indent=1).encode())
