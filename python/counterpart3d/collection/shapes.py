# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""One specimen: its mesh as it is matched, and what is known of it before it meets another."""

from __future__ import annotations

import os

import numpy as np

from .. import InvalidInput, Mesh, SpectralShape, read
from .._arrays import FloatArray
from .descriptors import descriptor
from .folder import MeshFile
from .store import Arrays, Store, compute_once, key_of
from .surfaces import area, diagonal, farthest_points

N_SAMPLES = 300  # on which maps are compared


def shape_key(content: str) -> str:
    return key_of("shapes", content)


def prepare(store: Store, file: MeshFile) -> str | None:
    """Read a mesh and describe it: the result `shapes`. Returns the message of a failure."""
    return compute_once(store, "shapes", shape_key(file.content), lambda: _prepared(store, file.path))


def _prepared(store: Store, path: str) -> Arrays:
    mesh = read(path)
    used = np.unique(mesh.triangles)
    if not len(used):
        raise InvalidInput(f"{os.path.basename(path)}: has no triangles")
    vertices = np.ascontiguousarray(mesh.vertices[used])
    number = np.full(mesh.n_vertices, -1, np.int32)
    number[used] = np.arange(len(used))
    triangles = np.ascontiguousarray(number[mesh.triangles])
    prepared((vertices, triangles), store)
    return {
        "vertices": vertices,
        "triangles": triangles,
        "used": used.astype(np.int32),  # their numbers in the file
        "n_in_file": np.array(mesh.n_vertices),
        **described(vertices, triangles),
        "notices": np.array([*mesh.notices, ""]),
    }


def described(vertices: FloatArray, triangles: np.ndarray) -> Arrays:
    """What a shape is known by: area, diagonal, samples, descriptor."""
    return {
        "area": np.array(area(vertices, triangles)),
        "diagonal": np.array(diagonal(vertices)),
        "samples": farthest_points(vertices, N_SAMPLES),
        "descriptor": descriptor((vertices, triangles)),
    }


def mesh_of(shape: Arrays, *, mirrored: bool = False) -> Mesh:
    """The mesh of a result `shapes`; or its mirror image, with the same vertices."""
    vertices, triangles = shape["vertices"], shape["triangles"]
    return Mesh(*reflected(vertices, triangles)) if mirrored else Mesh(vertices, triangles)


def reflected(vertices: FloatArray, triangles: np.ndarray) -> tuple[FloatArray, np.ndarray]:
    """The mirror image in the yz plane, facing outward."""
    return vertices * [-1, 1, 1], np.ascontiguousarray(triangles[:, ::-1])


def prepared(mesh: Mesh | tuple[FloatArray, np.ndarray], store: Store) -> SpectralShape:
    """The mesh as the matcher knows it, kept in the store."""
    return SpectralShape(mesh, cache=os.path.join(store.folder, "prepared"), n_threads=1)
