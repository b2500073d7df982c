# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Maps that are read off the template's mesh."""

import counterpart3d as cp
import numpy as np
import pytest

pytest.importorskip("scipy")
from counterpart3d.collection.correspondence import template_points, vertices_at

BALL = cp.make_icosphere(3)
N = BALL.n_vertices
TRIANGLES = np.vstack([BALL.triangles, BALL.triangles + N])


def two_balls(distance, size=1.0):
    return np.vstack([size * BALL.vertices, size * BALL.vertices + [distance, 0, 0]])


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("first", "second"), [(1.99, 3.0), (3.0, 1.99)])
def test_limbs_that_touch_are_told_apart(first, second, side):
    """Two balls that touch in one pose, where the template, a little too large, of each lies in the other."""
    source, target = (cp.Mesh(two_balls(d), np.ascontiguousarray(TRIANGLES[:, ::side])) for d in (first, second))
    points = template_points(source, two_balls(first, 1.02), TRIANGLES, np.arange(2 * N, dtype=np.int32))
    image = vertices_at(points, two_balls(second, 1.02), TRIANGLES, target)
    assert np.linalg.norm(target.vertices[image] - target.vertices, axis=1).max() < 0.1
