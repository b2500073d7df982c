# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The two meshes of the examples, as files: what one has from elsewhere."""

import pathlib
import sys

import counterpart3d as cp


def write_pair() -> tuple[pathlib.Path, pathlib.Path]:
    """A figure, and another triangulation of it in another pose, in the folder given or here; the paths."""
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    body = cp.make_body(0)
    other, _ = cp.shuffle(cp.subdivide(cp.deform(body, bend=0.8)))
    paths = folder / "a.ply", folder / "b.ply"
    for mesh, path in zip((body, other), paths, strict=True):
        cp.write(mesh, path)
    return paths
