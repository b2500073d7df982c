# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""The model as statismo and scalismo read it, where h5py is installed."""

from __future__ import annotations

import importlib.util
import io
import pathlib

import numpy as np

from .statistics import Model
from .store import whole_file


def statismo_is_written() -> bool:
    """Whether h5py is installed."""
    return importlib.util.find_spec("h5py") is not None


def write_statismo(model: Model, path: pathlib.Path) -> bool:
    """A statistical shape model of format 0.9. False if h5py is not installed."""
    if not statismo_is_written():
        return False
    import h5py

    # statismo's basis is orthonormal vertex by vertex, ours under areas
    flat = model.modes.reshape(len(model.modes), -1) * np.sqrt(model.variances)[:, None]
    values, vectors = np.linalg.eigh(flat @ flat.T)
    order = np.argsort(values)[::-1]
    variance = values[order]
    basis = (flat.T @ vectors[:, order]) / np.sqrt(np.maximum(variance, 1e-300))
    content = io.BytesIO()
    with h5py.File(content, "w") as file:
        file["/model/mean"] = model.mean.ravel().astype("f4")
        file["/model/pcaBasis"] = basis.astype("f4")
        file["/model/pcaVariance"] = variance.astype("f4")
        file["/model/noiseVariance"] = np.float32(0)
        file["/representer/points"] = model.mean.T.astype("f4")
        file["/representer/cells"] = model.triangles.T.astype("i4")
        file["/representer"].attrs["name"] = "vtkStandardMeshRepresenter"
        file["/representer"].attrs["version"] = "0.1"
        file["/representer"].attrs["datasetType"] = "POLYGON_MESH"
        file["/version/majorVersion"], file["/version/minorVersion"] = np.int32(0), np.int32(9)
        file["/modelinfo/scores"] = np.zeros((0, 0), "f4")
    with whole_file(path) as written:
        written.write(content.getbuffer())
    return True
