# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""What the random calls are given: arrays of every type, layout and content."""

import copy
import tempfile

import counterpart3d as cp
import numpy as np

FLOATS, ODD_FLOATS = ["f8", "f4", ">f8", "g"], ["f2", "i4", "u1", "?", "c16", "O", "U3"]
INTEGERS, ODD_INTEGERS = ["i4", "i8", ">i4", "i2", "u8"], ["u4", "u1", "f8", "?", "O", "c16"]
HUGE = [-1, 2**31 - 1, -(2**31), 2**31, 2**40, -(2**63), 2**63 - 1]

BALL = cp.make_icosphere(1)
BLOB = cp.deform(BALL, warp=0.3, seed=2)
SEEDS = [
    BALL,
    BLOB,
    cp.deform(BLOB, twist=0.2),
    cp.shuffle(BLOB, 3)[0],
    cp.make_torus(8, 5),
    cp.make_grid(6, 5),
    cp.Mesh(BLOB.vertices, BLOB.triangles[:60]),
]


def read_seeds():
    with tempfile.TemporaryDirectory() as folder:
        for number, seed in enumerate(SEEDS):
            cp.write(seed, f"{folder}/{number}.ply")
        return [cp.read(f"{folder}/{number}.ply") for number in range(len(SEEDS))]


READ = read_seeds()


def n_vertices(mesh):
    """Of what should be a mesh; 42 where it has none."""
    if isinstance(mesh, cp.Mesh):
        return mesh.n_vertices
    first = mesh[0] if isinstance(mesh, tuple) and mesh else None
    return len(first) if isinstance(first, np.ndarray) and first.ndim else 42


class Draws:
    """What one call is drawn from: its meshes, maps and numbers."""

    def __init__(self, number):
        self.random = np.random.default_rng([17, number])
        self.tame = self.random.random() < 0.6  # every layout, but nothing that must be refused
        self.given = []  # arrays handed over, and what they held

    def pick(self, *usual, odd=()):
        choices = [*usual] if self.tame else [*usual, *odd]
        return choices[self.random.integers(len(choices))]

    def chance(self, share):
        return self.random.random() < share

    def rarely(self, share=0.1):
        return not self.tame and self.chance(share)

    def lay_out(self, array):
        """The same content in another layout."""
        kind = self.random.integers(8)
        if kind == 1:
            array = np.asfortranarray(array)
        elif kind == 2 and array.ndim:
            array = np.repeat(array, 2, axis=0)[::2]
        elif kind == 3 and array.ndim:
            array = array[::-1][::-1]
        elif kind == 4 and array.ndim == 2:
            array = np.concatenate([array, array], axis=1)[:, : array.shape[1]]
        elif kind == 5:
            shifted = np.frombuffer(b"x" + array.tobytes(), np.uint8)[1:] if array.dtype.kind in "fiu" else None
            array = array if shifted is None else shifted.view(array.dtype).reshape(array.shape)
        elif kind == 6:
            array = array.copy()
            array.setflags(write=False)
        return array

    def handed(self, array, types):
        """The array as some type, in some layout, sometimes of another shape; remembered."""
        with np.errstate(all="ignore"):
            array = np.asarray(array)
            if self.chance(0.4):
                array = array.astype(self.pick(*types, odd=ODD_FLOATS if types is FLOATS else ODD_INTEGERS))
        if self.rarely(0.05):
            shapes = [array.ravel(), array[None], array[:0], array[..., :1], array[:-1], np.concatenate([array, array])]
            array = self.pick(*shapes)
        array = self.lay_out(array)
        if self.rarely(0.03):
            return self.pick(None, 5, "abc", [[1, 2], [3]], array.tolist(), object())
        self.given.append((array, array.copy()))
        return array

    def mesh(self):
        if self.rarely(0.15):
            n = self.random.integers(0, 12)
            vertices = self.random.normal(size=(n, 3))
            triangles = self.random.integers(-1, 13, (self.random.integers(0, 12), 3))
        else:
            vertices, triangles = (np.array(part) for part in self.pick(*SEEDS))
        if self.rarely() and vertices.size:
            with np.errstate(over="ignore"):
                vertices[self.random.integers(len(vertices))] = self.pick(np.nan, np.inf, 1e300, 1e-300, 0)
        if self.rarely() and triangles.size:
            triangles = triangles.astype(np.int64)
            triangles[self.random.integers(len(triangles)), self.random.integers(3)] = self.pick(*HUGE, 0, 1)
        if self.chance(0.1):  # whose arrays belong to C++
            return copy.deepcopy(self.pick(*READ))
        mesh = self.handed(vertices, FLOATS), self.handed(triangles, INTEGERS)
        return self.pick(None, 5, mesh[:1]) if self.rarely(0.01) else mesh

    def laid_out(self):
        """A mesh with texture coordinates."""
        vertices, triangles = self.pick(*SEEDS)
        rows = np.round(np.array(vertices)[:, :2], self.pick(1, 6))  # some over one another, or without area
        corners = np.array(triangles)
        if self.rarely():
            rows[self.random.integers(len(rows))] = self.pick(np.nan, np.inf, 1e300, 1e-300, 0)
        if self.rarely():
            corners[self.random.integers(len(corners)), self.random.integers(3)] = self.pick(-1, 2**31 - 1, len(rows))
        pair = self.handed(rows, FLOATS), self.handed(corners, INTEGERS)
        return cp.Mesh(vertices, triangles, texture_coordinates=[] if self.rarely() else [pair])

    def map(self, source):
        n = n_vertices(source)
        lowest = self.pick(0, 0, -1)
        image = self.random.integers(lowest, 40, n + (self.pick(1, -1) if n and self.rarely() else 0))
        if self.rarely() and image.size:
            image[self.random.integers(len(image))] = self.pick(*HUGE)
        if self.chance(0.1):
            weights = self.random.dirichlet([1, 1, 1], len(image))
            if self.rarely() and len(weights):
                weights[0] = self.pick(np.nan, -1, 1e300, np.inf)
            return cp.SurfaceMap(self.handed(image, INTEGERS), self.handed(weights, FLOATS))
        return self.handed(image, INTEGERS)

    def pairs(self):
        pairs = self.random.integers(
            -1 if self.rarely() else 0, 43 if self.rarely() else 40, (self.pick(0, 1, 2, 5), 2)
        )
        return None if self.chance(0.5) else self.handed(pairs, INTEGERS)

    def number(self, *usual):
        return self.pick(*HUGE, 0, 1.5, "x", None, np.nan) if self.rarely() else self.pick(*usual)

    def direction(self):
        return self.pick(None, "x", "-z", [0, 0, 1], odd=("w", [0, 0, 0], [np.nan, 0, 1], [1, 2]))

    def values(self, source, width):
        n = n_vertices(source)
        return self.handed(self.random.random((n, width) if width else n), FLOATS)

    def spectrum(self, k=6):
        basis = cp.spectrum(self.pick(*SEEDS), k)
        if self.chance(0.3):
            return cp.Spectrum(
                *(self.handed(part, FLOATS) for part in (basis.eigenvalues, basis.eigenfunctions, basis.mass))
            )
        return basis
