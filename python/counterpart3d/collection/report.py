# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""One page, without a network: every specimen at a glance, the mean and its modes, scores, what to look at."""

from __future__ import annotations

import base64
import dataclasses
import html
import pathlib
import string
from collections.abc import Callable
from importlib import resources
from typing import Any

import numpy as np

from .. import render
from .._arrays import FloatArray
from .made import Made
from .plots import bars, scatter
from .quality import Row
from .runner import Progress
from .statistics import Model, compactness
from .store import whole_file

PICTURE = (240, 180)
N_MODES, N_PICTURES = 5, 500
Pair = tuple[str, str, float, bool]


@dataclasses.dataclass(frozen=True)
class Shown:
    """What the report shows.

    Attributes
    ----------
    model : Model
    names : list of str
        Of the specimens, in the order of the model's scores.
    aligned : callable
        The mesh of the specimen of this place, on the mean.
    quality : list of Row
    notices : list of str
    pairs : list of (str, str, float, bool)
        Those that disagree most: names, error, whether it was kept out of the choice.
    measures : dict
    mirror : bool
        Mirror images were looked for.
    """

    model: Model
    names: list[str]
    aligned: Callable[[int], FloatArray]
    quality: list[Row]
    notices: list[str]
    pairs: list[Pair]
    measures: dict[str, Any]
    mirror: bool


def shown(made: Made, measures: dict[str, Any]) -> Shown:
    """A collection that was just made."""
    members = made.members()
    names = [member.name for member in members]
    aligned = lambda place: members[place].aligned()  # noqa: E731
    mirror = made.settings.mirror == "auto"
    return Shown(made.model, names, aligned, made.quality, made.registered.notices, worst_pairs(made), measures, mirror)


def worst_pairs(made: Made) -> list[Pair]:
    worst = sorted(made.between.items(), key=lambda item: -item[1])[:10]
    name = [specimen.name for specimen in made.specimens]
    return [(name[i], name[j], error, (i, j) in made.network.held_out) for (i, j), error in worst]


def write_report(made: Shown, path: pathlib.Path, progress: Progress) -> None:
    """Write the report."""
    page = string.Template(resources.files(__package__).joinpath("report.html").read_text(encoding="utf-8"))
    text = page.substitute(
        title=html.escape(path.parent.resolve().name),
        summary=_summary(made.measures),
        notices=_notices(made),
        sheet=_contact_sheet(made, progress),
        modes=_mode_sliders(made),
        mean=_base64(_viewer_vertices(made)),
        triangles=_base64(made.model.triangles.astype("<u4")),
        displacements=_base64(_viewer_modes(made)),
        colors=_base64((255 * position_colors(made.model.mean)).astype("u1")),
        scatter=scatter(made.model.scores, made.names, made.model.variances),
        compactness=bars(compactness(made.model)),
        table=_table(made),
        pairs=_pairs(made),
        viewer=resources.files(__package__).joinpath("report.js").read_text(encoding="utf-8"),
    )
    with whole_file(path) as file:
        file.write(text.encode())


def position_colors(mean: FloatArray) -> FloatArray:
    """A color for each point of the template, by its place along the mean's principal axes."""
    turned = upright(mean)
    low, high = turned.min(axis=0), turned.max(axis=0)
    result: FloatArray = 0.1 + 0.85 * (turned - low) / np.maximum(high - low, 1e-300)
    return result


def upright(mean: FloatArray) -> FloatArray:
    """Turned so that the longest axis lies across the picture and the shortest points at who looks."""
    return mean @ view_axes(mean).T


def view_axes(mean: FloatArray) -> FloatArray:
    """The rotation that `upright` applies."""
    axes = np.linalg.svd((mean - mean.mean(axis=0)).T @ (mean - mean.mean(axis=0)))[0].T
    axes[2] *= np.sign(np.linalg.det(axes))
    result: FloatArray = axes
    return result


def _viewer_vertices(made: Shown) -> FloatArray:
    turned = upright(made.model.mean)
    center = (turned.max(axis=0) + turned.min(axis=0)) / 2
    result: FloatArray = ((turned - center) / np.abs(turned - center).max()).astype("<f4")
    return result


def _viewer_modes(made: Shown) -> FloatArray:
    """Displacements of one standard deviation, in the viewer's units."""
    turned = upright(made.model.mean)
    scale = np.abs(turned - (turned.max(axis=0) + turned.min(axis=0)) / 2).max()
    sigmas = np.sqrt(made.model.variances[:N_MODES])[:, None, None]
    result: FloatArray = (made.model.modes[:N_MODES] * sigmas @ view_axes(made.model.mean).T / scale).astype("<f4")
    return result


def _base64(array: np.ndarray) -> str:
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode()


def _contact_sheet(made: Shown, progress: Progress) -> str:
    colors, axes = position_colors(made.model.mean), view_axes(made.model.mean)
    remarks = {row["subject"]: str(row["remark"]) for row in made.quality}
    place = {row["subject"]: k for k, row in enumerate(made.quality)}
    members = sorted(range(len(made.names)), key=lambda i: place[made.names[i]])[:N_PICTURES]
    cells = []
    progress.start()
    for done, i in enumerate(members):
        mesh = made.aligned(i) @ axes.T, made.model.triangles
        picture = render(mesh, colors=colors, size=PICTURE, view="front", up="y", n_threads=1)
        remark, name = html.escape(remarks[made.names[i]]), html.escape(made.names[i])
        cells.append(
            f'<figure class="{"suspect" if remark else "fine"}" title="{remark}">'
            f'<img loading="lazy" alt="{name}" src="data:image/png;base64,{base64.b64encode(picture.png()).decode()}">'
            f"<figcaption>{name}</figcaption></figure>"
        )
        progress.step("pictures", done + 1, len(members))
    return "\n".join(cells)


def _mode_sliders(made: Shown) -> str:
    share = made.model.variances / max(made.model.variances.sum(), 1e-300)
    return "\n".join(
        f"<label>mode {k + 1} <small>{100 * share[k]:.0f} %</small>"
        f'<input type="range" min="-3" max="3" step="0.05" value="0" data-mode="{k}"><output>0</output></label>'
        for k in range(min(N_MODES, len(share)))
    )


WORDS = {
    "specimens": "specimens in one correspondence",
    "left_out": "left out",
    "pairs_matched": "pairs matched",
    "held_out_cycle_error": "error of the pairs that were kept out of the choice, x 100 / sqrt(area)",
    "generalization": "generalization: error of a specimen that the model has not seen, mesh units",
    "specificity": "specificity: from what the model makes to the nearest specimen, mesh units",
    "modes_for_95_percent": "modes hold 95 % of the variance",
    "last_movement_of_the_mean": "of the diagonal: how far the mean still moved in the last round",
}


def _summary(measures: dict[str, Any]) -> str:
    return "\n".join(
        f"<li><b>{measures[name]:.4g}</b> {words}</li>" for name, words in WORDS.items() if name in measures
    )


def _notices(made: Shown) -> str:
    said = [*made.notices]
    bad = sum(bool(row["remark"]) for row in made.quality)
    if 2 * bad > len(made.quality) > 4:
        said.append(
            f"{bad} of {len(made.quality)} files have a remark in the table below, so it says little about any one of "
            "them: a template with more vertices may reach more of each, and meshes full of holes are best repaired "
            "first. The worst files come first"
        )
    elif bad:
        said.append(
            f"{bad} files or specimens have a remark in the table below. Look at their pictures: colors that sit "
            "elsewhere than on the others show a wrong map. Landmarks on one of them, a template nearer to them, "
            f"{_other_help(made.mirror)}; what does not belong is best taken out of the folder."
        )
    return "\n".join(f"<p class=notice>{html.escape(sentence)}.</p>".replace("..<", ".<") for sentence in said)


def _other_help(mirror: bool) -> str:
    return "or --pairs all help" if mirror else "--pairs all or, where left and right are mixed, --mirror auto help"


def _table(made: Shown) -> str:
    columns = {
        "subject": "specimen",
        "norm_mean": "distance, % of diagonal",
        "p99_over_mean": "p99 / mean",
        "scan_norm_mean": "scan to fit, %",
        "coverage": "covered, %",
        "turned_triangles": "turned triangles, %",
        "cycle_error": "cycle error",
        "confidence": "confidence",
        "outlier": "unusual",
        "mirrored": "mirror image",
        "remark": "remark",
    }
    percent = {"norm_mean", "scan_norm_mean", "coverage", "turned_triangles"}
    head = "".join(f"<th>{words}</th>" for words in columns.values())
    rows = []
    for row in made.quality:
        cells = []
        for name in columns:
            value = row.get(name, "")
            if isinstance(value, bool):
                value = "yes" if value else ""
            elif isinstance(value, float):
                value = f"{100 * value:.3g}" if name in percent else f"{value:.3g}"
            cells.append(f"<td>{html.escape(str(value))}</td>")
        rows.append(f'<tr class="{"suspect" if row["remark"] else "fine"}">{"".join(cells)}</tr>')
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>"


def _pairs(made: Shown) -> str:
    return "\n".join(
        f"<li>{html.escape(a)} and {html.escape(b)}: {error:.1f}{' (kept out)' if kept_out else ''}</li>"
        for a, b, error, kept_out in made.pairs
    )
