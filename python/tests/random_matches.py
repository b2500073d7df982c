# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Random calls of what matches and compares two meshes."""

import copy
import pickle

import counterpart3d as cp
import numpy as np
from random_draws import SEEDS, Draws


class Matches(Draws):
    def shape_options(self):
        return {
            "landmarks": self.pairs(),
            "n_alternatives": self.number(0, 1, 3),
            "seed": self.number(0, 1),
            "n_threads": self.number(1, 2),
        }

    def call_match(self):
        method = self.pick("auto", "auto", "auto", "exact", "frontiers", "nearest", "assignment", odd=["none"])
        a, b = self.mesh(), self.mesh()
        weld, shared = self.pick(None, 0, 0.1, odd=[-1, np.nan]), self.number(0.9, 0.5, 1)
        return cp.match(a, b, method, weld_distance=weld, min_shared=shared, n_threads=self.number(1, 2))

    def call_match_by_shape(self):
        method, part = self.pick("spectral", "partial", "place"), self.pick("unknown", "source", odd=["none"])
        options = self.shape_options() | {"part": part, "mirror": self.pick("auto", "never", odd=["none"])}
        found = cp.match(self.mesh(), self.mesh(), method, n_samples=self.number(200), **options)
        return pickle.loads(pickle.dumps(found)), np.asarray(found), found._repr_html_()

    def call_match_uv(self):
        a, b = (self.laid_out() for _ in "ab")
        return cp.match(a, b, "uv", n_threads=self.number(1, 2))

    def call_match_prepared(self):
        a, b = (cp.SpectralShape(self.pick(*SEEDS)) for _ in "ab")
        a = self.pick(a, copy.deepcopy(a), pickle.loads(pickle.dumps(a)))
        initial = self.map(a.mesh) if self.chance(0.5) else None
        return cp.match(a, self.pick(b, self.mesh()), initial=initial, n_threads=self.number(1, 2))

    def call_match_exact(self):
        options = {"allow_mirror": self.pick(True, False), "max_alternatives": self.number(0, 3)}
        return cp.match_exact(self.mesh(), self.mesh(), **options)

    def call_find_differences(self):
        return cp.find_differences(self.mesh(), self.mesh(), n_threads=self.number(1, 2))

    def call_match_frontiers(self):
        seed = self.number(-1, 0, 41)
        seeds = {"source_seed": seed, "target_seed": self.pick(seed, odd=[-1, 5])}
        how = {"paper": self.pick(True, False), "pairing": self.pick(None, "mutual", "optimal", odd=["none"])}
        return cp.match_frontiers(self.mesh(), self.mesh(), **seeds, **how)

    def call_match_spectral(self):
        options = self.shape_options() | {"excluded": self.pairs(), "up": self.direction(), "facing": self.direction()}
        flags = {name: self.pick(True, False) for name in ("soft_landmarks", "aligned", "symmetric")}
        size = {"basis_size": self.number(30), "n_samples": self.number(200)}
        return cp.match_spectral(self.mesh(), self.mesh(), **options, **flags, **size)

    def call_match_partial(self):
        part = self.pick("unknown", "source", "target", "both", "neither", odd=["none"])
        flags = {name: self.pick(True, False) for name in ("same_scale", "mirrored")}
        options = self.shape_options() | flags | {"part": part, "n_samples": 200}
        return cp.match_partial(self.mesh(), self.mesh(), **options)

    def call_match_nearest(self):
        return cp.match_nearest(self.mesh(), self.mesh(), similarity=self.pick(True, False))

    def call_match_assignment(self):
        return cp.match_assignment(self.mesh(), self.mesh(), max_vertices=self.number(100))

    def call_compare(self):
        return cp.compare(self.mesh(), self.mesh())

    def call_choose_method(self):
        method = self.pick("auto", "exact", "spectral", "partial", "place", "nearest", odd=["none"])
        options = {"landmarks": self.pairs(), "excluded": self.pairs(), "seed": self.number(0, 1)}
        return cp.choose_method(self.mesh(), self.mesh(), method, **options)
