# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Small plots as SVG."""

from __future__ import annotations

import html

import numpy as np

from .._arrays import FloatArray

SIZE, MARGIN = 360, 40


def scatter(scores: FloatArray, names: list[str], variances: FloatArray) -> str:
    """The first two scores of each specimen, in standard deviations."""
    k = min(2, len(variances))
    unit = np.zeros((len(scores), 2))
    unit[:, :k] = scores[:, :k] / np.sqrt(np.maximum(variances[:k], 1e-300))
    reach = max(float(np.abs(unit).max(initial=0)), 3) * 1.05
    half = (SIZE - 2 * MARGIN) / 2
    dots = []
    for (x, y), name in zip(unit, names, strict=True):
        far = "far" if np.hypot(x, y) > 3 else "near"
        at = f'cx="{SIZE / 2 + half * x / reach:.1f}" cy="{SIZE / 2 - half * y / reach:.1f}"'
        dots.append(f'<circle class="{far}" r="4" {at}><title>{html.escape(name)}: {x:.2f}, {y:.2f}</title></circle>')
    return (
        f'<svg viewBox="0 0 {SIZE} {SIZE}" role="img" aria-label="scores of the first two modes">'
        f'<path class="axis" d="M{MARGIN} {SIZE / 2}H{SIZE - MARGIN}M{SIZE / 2} {MARGIN}V{SIZE - MARGIN}"/>'
        f'<text x="{SIZE - MARGIN}" y="{SIZE / 2 - 6}" text-anchor="end">mode 1</text>'
        f'<text x="{SIZE / 2 + 6}" y="{MARGIN}">mode 2</text>{"".join(dots)}</svg>'
    )


def bars(cumulative: FloatArray, most: int = 20) -> str:
    """The cumulative share of the variance."""
    shown = cumulative[:most]
    width = (SIZE - 2 * MARGIN) / max(len(shown), 1)
    height = SIZE / 2 - 2 * MARGIN + 30
    rects = "".join(
        f'<rect x="{MARGIN + k * width:.1f}" width="{max(width - 2, 1):.1f}" y="{20 + height * (1 - share):.1f}" '
        f'height="{height * share:.1f}"><title>{k + 1} modes: {100 * share:.1f} %</title></rect>'
        for k, share in enumerate(shown)
    )
    return (
        f'<svg viewBox="0 0 {SIZE} {SIZE / 2}" role="img" aria-label="share of the variance">{rects}'
        f'<text x="{MARGIN}" y="{20 + height + 18}">1</text>'
        f'<text x="{SIZE - MARGIN}" y="{20 + height + 18}" text-anchor="end">{len(shown)} modes</text>'
        f'<text x="2" y="26">100 %</text></svg>'
    )
