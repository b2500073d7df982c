# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Random calls of what takes a map: changing, measuring and using it, with landmarks and spectra."""

import pickle

import counterpart3d as cp
import numpy as np
from random_draws import FLOATS, HUGE, INTEGERS, Draws, n_vertices


class Maps(Draws):
    def call_evaluate(self):
        a, b = self.mesh(), self.mesh()
        truth = self.pairs() if self.chance(0.5) else self.map(a)
        levels = self.pick((), [0, 1, 2], odd=([1, 0], [np.nan]))
        return cp.evaluate(a, b, self.map(a), truth, thresholds=levels, n_base_vertices=self.number(0, 3))

    def call_map_quality(self):
        a = self.mesh()
        return cp.map_quality(a, self.mesh(), self.map(a))

    def call_project_map(self):
        a = self.mesh()
        options = {"rings": self.number(2), "passes": self.number(3), "extend": self.number(0, 2)}
        return cp.project_map(a, self.mesh(), self.map(a), **options)

    def call_invert_map(self):
        a = self.mesh()
        return cp.invert_map(a, self.mesh(), self.map(a))

    def call_complete_map(self):
        a = self.mesh()
        return cp.complete_map(a, self.mesh(), self.map(a), max_edges=self.number(1))

    def call_compose_maps(self):
        return cp.compose_maps(self.map(None), self.map(None))

    def call_transfer_values(self):
        a = self.mesh()
        return cp.transfer_values(a, self.mesh(), self.map(a), self.values(a, self.pick(0, 1, 3)))

    def call_nearest_corners(self):
        target = self.mesh()
        found = self.map(None)
        if not isinstance(found, cp.SurfaceMap):
            found = cp.SurfaceMap(found, self.handed(np.full((n_vertices(None), 3), 1 / 3), FLOATS))
        return cp.nearest_corners(target, found)

    def landmarks(self, mesh):
        """Some of the vertices by name, or points far from them."""
        points = self.values(mesh, 3) if self.rarely(0.3) or not isinstance(mesh, tuple) else mesh[0]
        if not isinstance(points, np.ndarray) or points.ndim != 2 or points.dtype.kind != "f":
            return {"a": points}
        return {name: self.handed(row, FLOATS) for name, row in zip("abcdé", points, strict=False)}

    def call_landmark_pairs(self):
        a, b = self.mesh(), self.mesh()
        return cp.landmark_pairs(a, b, self.landmarks(a), self.landmarks(b))

    def call_carry_landmarks(self):
        a = self.mesh()
        return cp.carry_landmarks(self.landmarks(a), a, self.mesh(), self.map(a))

    def attributes(self, mesh):
        n = n_vertices(mesh)
        corners = mesh[1] if isinstance(mesh, tuple) and len(mesh) == 2 else None
        joints = self.handed(self.random.integers(-1 if self.rarely() else 0, 3, (n, 2)), INTEGERS)
        weights = self.handed(np.full((n, 2), 0.5), FLOATS)
        possible = {
            "normals": (self.values(mesh, 3), corners),
            "texture_coordinates": [(self.values(mesh, 2), corners)],
            "colors": [(self.values(mesh, self.pick(3, 4, odd=[2])), corners)],
            "skin": (joints, weights),
            "morphs": {"smile": self.values(mesh, 3)},
        }
        return {name: value for name, value in possible.items() if self.chance(0.4)}

    def call_transfer(self):
        a = self.mesh()
        source, target = cp.Mesh(*a, **self.attributes(a)), self.mesh()
        source = self.pick(source, pickle.loads(pickle.dumps(source)))
        return cp.transfer(source, target, self.map(a), max_influences=self.number(0, 1, 4))

    def call_reorder(self):
        return cp.reorder(self.mesh(), self.mesh())

    def call_morph(self):
        a = self.mesh()
        return cp.morph(a, self.mesh(), self.pick(None, self.map(a)), count=self.pick(0, 1, 3, odd=[-1, 1.5]))

    def call_align(self):
        a = self.mesh()
        how = {"model": self.pick("rigid", "similarity", "affine", odd=["none"]), "icp": self.pick(True, False)}
        how |= {"trim": self.number(0, 0.5), "known_weight": self.number(1, 0), "max_iterations": self.number(5)}
        return cp.align(a, self.mesh(), self.pick(None, self.map(a)), **how)

    def call_fit(self):
        a = self.mesh()
        options = {"stiffness": self.number(1, 5), "reach": self.number(0.1), "landmarks": self.pairs()}
        return cp.fit(a, self.mesh(), self.pick(self.map(a), None), **options)

    def call_spectrum(self):
        return cp.spectrum(self.mesh(), self.number(1, 5, 50))

    def call_functional_map(self):
        a, b = self.spectrum(), self.spectrum()
        return cp.functional_map(self.map(None), a, b, self.pick(None, 3, odd=[0, 99]))

    def call_vertex_map(self):
        matrix = self.random.normal(size=(self.pick(6, 3, odd=[9]), self.pick(6, 3, odd=[9])))
        return cp.vertex_map(self.handed(matrix, FLOATS), self.spectrum(), self.spectrum())

    def call_zoom_out(self):
        sizes = {"first": self.number(3), "last": self.number(6, 9), "step": self.number(1, 2)}
        return cp.zoom_out(self.map(None), self.spectrum(), self.spectrum(), **sizes)

    def call_signatures(self):
        signature = self.pick(cp.wave_kernel_signature, cp.heat_kernel_signature)
        return signature(self.spectrum(), self.pick(2, 5, odd=[0, -1]))

    def call_distances(self):
        sources = self.handed(self.random.integers(0, 30, 3), INTEGERS)
        return cp.distances(self.mesh(), self.pick(None, sources, 5, odd=[HUGE]), shortcuts=self.pick(True, False))
