# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Colors that show a map on both objects."""

from __future__ import annotations

import numpy as np

MAP, CONFIDENCE, RUNNER_UP = "Counterpart map", "Counterpart confidence", "Counterpart runner-up"
ATTRIBUTES = (MAP, CONFIDENCE, RUNNER_UP)
NONE = np.array([0.2, 0.2, 0.2, 1.0], np.float32)  # of vertices without a counterpart
BAD, FAIR, GOOD = (np.array(color, np.float32) for color in ((0.75, 0.05, 0.03), (0.9, 0.6, 0.1), (0.1, 0.45, 0.75)))


def place_colors(vertices: np.ndarray) -> np.ndarray:
    """Each place of a shape has a color of its own: x, y, z as red, green, blue, (n, 4)."""
    low, extent = vertices.min(axis=0), np.ptp(vertices, axis=0)
    rgb = 0.08 + 0.84 * (vertices - low) / np.where(extent > 0, extent, 1)
    return np.column_stack([rgb, np.ones(len(rgb))]).astype(np.float32)


def carried_colors(colors: np.ndarray, image: np.ndarray) -> np.ndarray:
    return np.where((image >= 0)[:, None], colors[image], NONE)


def confidence_colors(confidence: np.ndarray) -> np.ndarray:
    """Red at 0 over yellow at a half to blue at 1, which those who see no green tell apart too."""
    t = np.clip(confidence, 0, 1)[:, None]
    rgb = np.where(t < 0.5, BAD + 2 * t * (FAIR - BAD), FAIR + (2 * t - 1) * (GOOD - FAIR))
    return np.column_stack([rgb, np.ones(len(rgb))]).astype(np.float32)


def gathered(values: np.ndarray, image: np.ndarray, n: int) -> np.ndarray:
    """For each of n vertices the mean of the values whose image it is; of those that are none's image NaN."""
    matched = image >= 0
    count = np.bincount(image[matched], minlength=n)
    total = np.bincount(image[matched], weights=values[matched], minlength=n)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)
