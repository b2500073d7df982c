# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""A collection that has been made: what Python code works with."""

from __future__ import annotations

import json
import os
import pathlib
from typing import Any

import numpy as np

from .. import InvalidInput, Mesh, SurfaceMap
from .._arrays import FloatArray, IntArray
from .._landmarks import Axes
from .addition import Base, add
from .correspondence import template_points, vertices_at
from .engine import build
from .points import require_on
from .retrieval import Answer, retrieve
from .runner import Progress, running
from .settings import Mirror, Pairs, Settings
from .shapes import mesh_of, reflected
from .statistics import Model
from .store import Arrays, Store

PathLike = str | os.PathLike[str]
N_CHECKED = 100  # of points that are carried: those farthest from the surface


def _require_begun(folder: pathlib.Path) -> None:
    if not folder.is_dir():
        raise InvalidInput(f"{folder}: no such folder")
    if not ((folder / "collection.json").exists() or (folder / "work").is_dir()):
        raise InvalidInput(f"{folder}: is not a collection: choose a folder that one was written to")


class Collection:
    """All meshes of a folder in one correspondence.

    Parameters
    ----------
    folder : path
        What `build` or `counterpart collection` wrote.

    Raises
    ------
    InvalidInput
        There is no finished collection.

    Attributes
    ----------
    names : list of str
        The specimens.
    left_out : dict of str to str
        Files that are not part of it, and why.
    notices : list of str
        What was chosen, and what to know.
    model : Model
        Mean, modes, variances, scores.
    measures : dict
        Of the whole: see measures.csv.
    """

    def __init__(self, folder: PathLike) -> None:
        self.folder = pathlib.Path(folder)
        _require_begun(self.folder)
        try:
            content = json.loads((self.folder / "collection.json").read_text())
            with np.load(self.folder / "model.npz", allow_pickle=False) as file:
                self._arrays = dict(file)
        except (OSError, ValueError) as error:
            raise InvalidInput(f"{self.folder}: holds no finished collection ({error}); run it again") from None
        if "members" not in content:
            raise InvalidInput(f"{self.folder}: holds no finished collection; run it again")
        self._content: dict[str, Any] = content
        self._store = Store(str((self.folder / "work").resolve()))
        self.names: list[str] = [member["name"] for member in content["members"]]
        self.left_out: dict[str, str] = content["left_out"]
        self.notices: list[str] = content["notices"]
        self.measures: dict[str, Any] = content["measures"]
        fields = ("mean", "triangles", "weights", "modes", "variances", "scores")
        n_members = len(self.names)
        for name in ("scores", "sizes", "matrices", "names"):
            if len(self._arrays[name]) < n_members:
                raise InvalidInput(f"{self.folder}: model.npz holds fewer specimens than collection.json; run it again")
            self._arrays[name] = self._arrays[name][:n_members]  # more are left of an addition that was killed
        self.model = Model(*(self._arrays[name] for name in fields))

    @classmethod
    def build(
        cls,
        folder: PathLike,
        out: PathLike,
        *,
        template: PathLike | None = None,
        landmarks: PathLike | None = None,
        landmark_axes: Axes | None = None,
        semi: int = 0,
        mirror: Mirror = "never",
        same_scale: bool = False,
        pairs: Pairs = "sparse",
        rounds: int = 3,
        seed: int = 0,
        scheduler: str | None = None,
        workers: int = 0,
        progress: bool = True,
    ) -> Collection:
        """Make a collection of the meshes in a folder; what has been made before is not made again.

        Parameters
        ----------
        folder : path
            One mesh for each specimen.
        out : path
            Folder to write to; it keeps the results of all stages in `work`.
        template, landmarks, landmark_axes, semi, mirror, same_scale, pairs, rounds, seed
            See `Settings`.
        scheduler : str, optional
            Address of a Dask scheduler, which sees `folder` and `out` under the same paths; "inline" for this process;
            default: processes on this machine.
        workers : int
            How many; 0 for one for each processor.
        progress : bool
            Say on standard error what is being done.

        Raises
        ------
        InvalidInput
            A folder or option cannot be used. Specimens that cannot be used are no error: see `left_out`.
        OSError
            A result cannot be written; what was written stays.
        """
        settings = Settings(
            None if template is None else os.fspath(template),
            None if landmarks is None else os.fspath(landmarks),
            semi,
            mirror,
            same_scale,
            pairs,
            rounds,
            seed,
            landmark_axes,
        )
        lines = Progress(not progress)
        with running(scheduler, workers, lines.say) as runner:
            build(os.fspath(folder), os.fspath(out), settings, runner, lines)
        return cls(out)

    @property
    def mean(self) -> Mesh:
        """The mean shape."""
        return Mesh(self.model.mean, self.model.triangles)

    def file(self, name: str) -> str:
        """The file that a specimen was read from."""
        return str(self._member(name)["file"])

    def mesh(self, name: str) -> Mesh:
        """The template's mesh on a specimen, in its own frame."""
        member = self._member(name)
        vertices, triangles = self._fit(name)["vertices"], self.model.triangles
        return Mesh(*reflected(vertices, triangles)) if member["mirrored"] else Mesh(vertices, triangles)

    def template_points(self, name: str) -> SurfaceMap:
        """The point of the template for each vertex of a specimen's file; -1 for vertices in no triangle."""
        from .made import scattered

        shape, fit = self._shape(name), self._fit(name)
        scan = mesh_of(shape, mirrored=self._member(name)["mirrored"])
        found = template_points(scan, fit["vertices"], self.model.triangles, fit["template_from_scan"])
        return scattered(found, shape["used"], int(shape["n_in_file"]))

    def map(self, source: str, target: str) -> IntArray:
        """Which vertex of one specimen is each vertex of another? (n_source,), -1 for vertices in no triangle."""
        points, mesh, shape = self.template_points(source), self.mesh(target), self._shape(target)
        matched = points.triangle >= 0
        reached = SurfaceMap(points.triangle[matched], points.weights[matched])
        image = np.full(len(points.triangle), -1, np.int32)
        image[matched] = shape["used"][vertices_at(reached, mesh.vertices, self.model.triangles, mesh_of(shape))]
        return image

    def carry(self, points: Any, source: str, target: str) -> FloatArray:
        """Points on one specimen, (n, 3) in its frame, on another, in its.

        Raises
        ------
        InvalidInput
            A coordinate is not finite, or a point lies far from the specimen: in another frame (LPS and RAS) or unit.
        """
        from .surfaces import nearest_points

        begin, end = self.mesh(source), self.mesh(target)
        at = np.asarray(points, float).reshape(-1, 3)
        if not np.isfinite(at).all():
            raise InvalidInput("a point has a coordinate that is not finite")
        triangle, weights, distance = nearest_points(at, begin.vertices, begin.triangles)
        farthest = np.argsort(-distance)[:N_CHECKED]
        require_on({str(i): at[i] for i in farthest}, mesh_of(self._shape(source)))
        result: FloatArray = np.einsum("nk,nkd->nd", weights, end.vertices[begin.triangles[triangle]])
        return result

    def retrieve(self, query: PathLike, k: int = 5) -> list[Answer]:
        """The k specimens that are most like a mesh, best first."""
        members = {member["name"]: member["shape"] for member in self._content["members"]}
        return retrieve(self._store, os.fspath(query), members, k)

    def add(
        self, folder: PathLike, *, scheduler: str | None = None, workers: int = 0, progress: bool = True
    ) -> Collection:
        """The collection with the meshes of a folder added; its mean and modes stay as they are.

        Each new specimen is matched with the three that are nearest by descriptor. See `build` for the options.
        """
        base = Base(self.folder, self._store, self._content, self._arrays, self.model)
        lines = Progress(not progress)
        with running(scheduler, workers, lines.say) as runner:
            add(base, os.fspath(folder), runner, lines)
        return Collection(self.folder)

    def _member(self, name: str) -> dict[str, Any]:
        for member in self._content["members"]:
            if member["name"] == name:
                return dict(member)
        why = f": {self.left_out[name]}" if name in self.left_out else ""
        raise InvalidInput(f"there is no specimen '{name}' in {self.folder}{why}")

    def _shape(self, name: str) -> Arrays:
        return self._store.get("shapes", self._member(name)["shape"])

    def _fit(self, name: str) -> Arrays:
        return self._store.get("registrations", self._member(name)["registration"])

    def __repr__(self) -> str:
        return f"Collection({len(self.names)} specimens, {len(self.model.mean)} vertices each)"
