# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Pictures of meshes and maps, and the page that shows them in a browser."""

from __future__ import annotations

import os
import pathlib
import sys
import tempfile
import webbrowser
from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _core
from ._arrays import FloatArray, floats
from ._calls import ProgressLike, reporting
from ._core import InvalidInput
from ._evaluation import truth_pairs
from ._maps import MapLike, vertex_map_of
from ._match_results import Alternative, MatchResult, PartialAlternative, PartialResult, SpectralResult
from ._meshes import MeshLike, core_mesh
from ._messages import Telling

Show = Literal["colors", "checker", "lines"]
Colormap = Literal["viridis", "cividis", "magma"]
Up = Literal["auto", "x", "y", "z", "-x", "-y", "-z"]


class Picture(np.ndarray[Any, np.dtype[np.uint8]]):
    """An image as an array of uint8, height x width x 3, which notebooks show."""

    def png(self) -> bytes:
        """The bytes of a PNG file, the same as the program writes."""
        return _core.encode_png(np.ascontiguousarray(self).view(np.ndarray))

    def save(self, file: str | os.PathLike[str]) -> None:
        """Write a PNG file."""
        with open(file, "wb") as opened:
            opened.write(self.png())

    def show(self) -> None:
        """Open the picture: in a notebook it appears there; else in the program that the system has for PNG files."""
        _open(self.png(), ".png", self)

    def _repr_png_(self) -> bytes | None:
        return self.png() if self.ndim == 3 and self.shape[2] == 3 and self.dtype == np.uint8 else None


def render(
    source: MeshLike,
    target: MeshLike | None = None,
    target_from_source: MapLike | None = None,
    *,
    show: Show = "colors",
    colors: Any = None,
    values: Any = None,
    max_value: float | None = None,
    colormap: Colormap = "viridis",
    size: tuple[int, int] = (1600, 1000),
    view: str = "auto",
    up: str = "auto",
    lines: int = 80,
    seed: int = 1,
    n_threads: int = 0,
    progress: ProgressLike = None,
) -> Picture:
    """Draw a mesh, or two meshes and the map between them. Needs no display.

    Parameters
    ----------
    source : MeshLike
    target : MeshLike, optional
    target_from_source : MapLike, optional
        Needed with `target`.
    show : {"colors", "checker", "lines"}
        Two meshes: the source colored by position and its colors on the target; the same with a checkerboard, which
        shows stretch and tears; or lines between matched points.
    colors : array_like, (n_source, 3), optional
        One mesh: colors of its vertices, 0 .. 1.
    values : array_like, (n_source,), optional
        One mesh: values of its vertices, 0 .. `max_value`, through `colormap`.
    max_value : float, optional
        Default: the largest value.
    colormap : {"viridis", "cividis", "magma"}
    size : (int, int)
        Width and height in pixels, 1 .. 16384.
    view : str
        auto, front, back, left, right, top, bottom, or "AZIMUTH,ELEVATION" in degrees.
    up : str
        auto, x, y, z, -x, -y or -z.
    lines : int
        Largest number of lines; 0 for all.
    seed : int
        Selects them.
    n_threads : int
    progress : ProgressLike

    Returns
    -------
    Picture
        uint8, height x width x 3. The same for any number of threads.

    Examples
    --------
    >>> import counterpart3d as cp
    >>> cp.render(cp.make_torus(), size=(64, 48)).shape
    (48, 64, 3)
    """
    options = _core.PictureOptions()
    options.width, options.height = size
    options.view, options.up, options.n_threads = view, up, n_threads
    mesh = core_mesh(source)
    with reporting(progress, "rendering") as report:
        if target is not None:
            if target_from_source is None:
                raise InvalidInput("two meshes need the map between them")
            goal = core_mesh(target)
            image = vertex_map_of(target_from_source, goal)
            pixels = _core.render_map(mesh, goal, image, show, lines, seed, options, report)
        elif colors is not None:
            pixels = _core.render_colors(mesh, floats(colors, "colors", (mesh.n_vertices, 3)), options, report)
        elif values is not None:
            given = floats(values, "values", (mesh.n_vertices,))
            most = _largest(given) if max_value is None else max_value
            pixels = _core.render_values(mesh, given, most, colormap, options, report)
        else:
            pixels = _core.render_mesh(mesh, options, report)
    return pixels.view(Picture)


def _open(content: bytes, extension: str, shown: Any) -> None:
    if "IPython" in sys.modules:
        from IPython import get_ipython  # type: ignore[import-not-found,unused-ignore]
        from IPython.display import display  # type: ignore[import-not-found,unused-ignore]

        shell: Any = get_ipython()  # type: ignore[no-untyped-call,unused-ignore]
        if shell is not None and hasattr(shell, "kernel"):
            display(shown)  # type: ignore[no-untyped-call,unused-ignore]
            return
    file = tempfile.NamedTemporaryFile(prefix="counterpart-", suffix=extension, delete=False)  # noqa: SIM115
    with file:
        file.write(content)
    webbrowser.open(pathlib.Path(file.name).as_uri())


def _largest(values: FloatArray) -> float:
    finite = values[np.isfinite(values)]
    most = float(finite.max()) if len(finite) else 0.0
    return most if most > 0 else 1.0


class View:
    """A page that shows two meshes and the maps between them, in any browser, without a network."""

    __slots__ = ("html",)

    def __init__(self, page: str) -> None:
        self.html = page

    def save(self, file: str | os.PathLike[str]) -> None:
        """Write the page as a file."""
        with open(file, "w", encoding="utf-8") as opened:
            opened.write(self.html)

    def show(self) -> None:
        """Open the page: in a notebook it appears there; else in a browser."""
        _open(self.html.encode(), ".html", self)

    def _repr_html_(self) -> str:
        import html  # here, as few need it

        return (
            f'<iframe srcdoc="{html.escape(self.html)}" style="width: 100%; height: 600px; border: 0" '
            'title="counterpart"></iframe>'
        )

    def __repr__(self) -> str:
        return f"View({len(self.html) / 1e6:.1f} MB; save() writes it)"


def view(
    source: MeshLike,
    target: MeshLike,
    maps: MapLike | Mapping[str, MapLike],
    *,
    truth: Any = None,
    source_name: str = "source",
    target_name: str = "target",
    up: Up = "auto",
) -> View:
    """A page that shows two meshes and the maps between them: in a notebook, or as a file with `View.save`.

    Parameters
    ----------
    source, target : MeshLike
    maps : MapLike, or mapping of str to MapLike
        One map, or several by name. Of results the page tells the verdict, what may be wrong and the confidence; of a
        single one its runners-up too.
    truth : array_like of int, optional
        The true map: the page then shows errors.
    source_name, target_name : str
    up : {"auto", "x", "y", "z", "-x", "-y", "-z"}
        What points up on the screen; auto guesses it from the source's shape, as `render` does.
    """
    named = dict(maps) if isinstance(maps, Mapping) else {"map": maps, **_runners_up(maps)}
    ends = core_mesh(source), core_mesh(target)
    images = [vertex_map_of(image, ends[1], name) for name, image in named.items()]
    true = np.empty(0, np.int32)
    errors: list[FloatArray] = []
    if truth is not None:
        pairs = truth_pairs(truth, *ends)
        for image in images:
            found = _core.evaluate(*ends, image, pairs, True, 0, np.empty(0), 0, None)
            errors.append(_mean_errors(found, pairs, ends[0].n_vertices))
        true = np.full(ends[0].n_vertices, -1, np.int32)
        true[pairs[::-1, 0]] = pairs[::-1, 1]
    told = [_told(found) for found in named.values()]
    return View(
        _core.viewer_page(
            *ends,
            list(named),
            images,
            errors,
            [confidence for confidence, _, _ in told],
            [verdict for _, verdict, _ in told],
            [warnings for _, _, warnings in told],
            true,
            source_name,
            target_name,
            up,
        )
    )


def _runners_up(found: Any) -> dict[str, MapLike]:
    """By what they are, numbered where that is the same."""
    details = found if isinstance(found, (SpectralResult, PartialResult)) else None
    if isinstance(found, MatchResult):
        details = found.spectral or found.partial
    if details is None:
        return {}
    described: dict[str, MapLike] = {}
    for other in details.alternatives:
        name, number = _described(other), 1
        while (numbered := name if number == 1 else f"{name} ({number})") in described:
            number += 1
        described[numbered] = other
    return described


def _described(other: Alternative | PartialAlternative) -> str:
    if isinstance(other, Alternative):
        return other.description
    return f"runner-up: {100 * other.moved:.0f} % of the vertices go elsewhere"


def _told(found: Any) -> tuple[FloatArray, str, list[str]]:
    """The confidence, the verdict and the warnings of a map, as far as it has them."""
    warnings = [str(message) for message in found.warnings] if isinstance(found, Telling) else []
    verdict = found.verdict.advice if isinstance(found, MatchResult) else ""
    is_graded = isinstance(found, (MatchResult, SpectralResult, PartialResult))
    return found.confidence if is_graded else np.empty(0), verdict, warnings


def _mean_errors(found: dict[str, Any], pairs: npt.NDArray[np.int32], n_vertices: int) -> FloatArray:
    error = found["error"] * (100 / np.sqrt(found["target_area"]))
    known = ~np.isnan(error)
    total = np.bincount(pairs[known, 0], error[known], n_vertices)
    count = np.bincount(pairs[known, 0], minlength=n_vertices)
    with np.errstate(invalid="ignore"):
        mean: FloatArray = np.where(count > 0, total / np.maximum(count, 1), np.nan)
    return mean
