#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""random_calls.py COUNT [FIRST]: calls of the package at random, with arrays of every type, layout and content.

Each call is drawn from its own number, so `random_calls.py 1 N` repeats call N. A call must return or raise one of the
documented exceptions and leave its arrays as they were; during every sixth call another thread changes them. Prints how
the calls of each function ended, as JSON. The file that RANDOM_CALLS_LOG names, if any, holds the number of the
call that runs: for a sanitizer that ends the process.
"""

import copy
import json
import os
import pickle
import sys
import tempfile
import threading
import time
import warnings

import counterpart3d as cp
import numpy as np

# TypeError: of an option that has the wrong type.
DOCUMENTED = (cp.InvalidInput, cp.IoError, cp.NumericalError, TypeError)
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


class Calls:
    """What one call is drawn from."""

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

    # ---- the functions ----
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

    def call_compare(self):
        return cp.compare(self.mesh(), self.mesh())

    def call_choose_method(self):
        method = self.pick("auto", "exact", "spectral", "partial", "place", "nearest", odd=["none"])
        options = {"landmarks": self.pairs(), "excluded": self.pairs(), "seed": self.number(0, 1)}
        return cp.choose_method(self.mesh(), self.mesh(), method, **options)

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

    def call_landmark_file(self):
        with tempfile.TemporaryDirectory() as folder:
            ending = self.pick(".mrk.json", ".fcsv", ".json", ".csv", odd=[".tps", ".none"])
            file = os.path.join(folder, "points" + ending)
            axes = self.pick("LPS", "RAS", odd=[None, "XYZ"])
            cp.write_landmarks(self.landmarks(self.mesh()), file, axes=axes)
            return cp.read_landmarks(file)

    def call_polygons(self):
        sizes = self.random.integers(2 if self.rarely() else 3, 6, self.pick(0, 1, 4))
        n_corners = max(sizes.sum() + self.pick(0, odd=[1, -1]), 0)
        corners = self.random.integers(-1 if self.rarely() else 0, 9, n_corners)
        points = self.handed(self.random.normal(size=(9, 3)), FLOATS)
        mesh = cp.Mesh.from_polygons(points, self.handed(sizes, INTEGERS), self.handed(corners, INTEGERS))
        return cp.shuffle(mesh), cp.inspect(pickle.loads(pickle.dumps(mesh)))

    def call_objects(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mesh" + self.pick(".obj", ".glb", ".stl", ".off", odd=[".none"]))
            cp.write(self.mesh(), file)
            return [cp.read(file, object=thing.number) for thing in cp.objects(file)]

    def call_map_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, self.pick("map.txt", "map.npy", odd=["none/map.txt"]))
            cp.write_map(self.map(None), file, one_based=self.pick(True, False))
            return cp.read_map(file)

    def call_mesh_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(
                folder,
                "mesh" + self.pick(".off", ".obj", ".ply", ".stl", ".glb", ".gltf", ".vtk", ".vtp", odd=[".none"]),
            )
            cp.write(self.mesh(), file)
            return cp.read(file)

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

    def call_mesh_attributes(self):
        a = self.mesh()
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, self.pick("a.glb", "a.obj", "a.ply"))
            cp.write(cp.Mesh(*a, **self.attributes(a)), file)
            return cp.read(file)

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

    def call_render(self):
        a, size = self.mesh(), self.pick((32, 24), (1, 1), odd=[(0, 5), (2**20, 1), (-1, 3), (2.5, 3)])
        view, up = self.pick("auto", "front", "30,20", odd=["nan,1", "x"]), self.pick("auto", "-z", odd=["w"])
        what = self.pick(
            {},
            {"colors": self.values(a, 3)},
            {"values": self.values(a, 0), "max_value": self.number(None, 1)},
            {"target": self.mesh(), "target_from_source": self.map(a), "show": self.pick("colors", "checker", "lines")},
        )
        return cp.render(a, size=size, view=view, up=up, n_threads=1, **what).png()

    def call_view(self):
        a, truth = self.mesh(), self.pick(None, self.pairs())
        return cp.view(a, self.mesh(), {"one": self.map(a), "two": self.map(a)}, truth=truth)

    def call_make(self):
        made = self.pick(
            lambda: cp.make_icosphere(self.number(0, 2)),
            lambda: cp.make_torus(self.number(3, 4), self.number(3, 5)),
            lambda: cp.make_grid(self.pick(1, 3, odd=[0, -1]), self.pick(1, 3, odd=[-5])),
            lambda: cp.make_body(self.number(0, 1), symmetric=self.pick(True, False)),
        )
        return made()

    def call_change(self):
        change = self.pick(
            cp.subdivide,
            cp.inspect,
            cp.vertex_areas,
            cp.vertex_normals,
            lambda mesh: cp.shuffle(mesh, self.number(1, 2)),
            lambda mesh: cp.move_at_random(mesh, self.number(1, 2)),
            lambda mesh: cp.deform(mesh, bend=self.number(0.5), warp=self.number(0.1), twist=self.number(1)),
        )
        return change(self.mesh())


FUNCTIONS = [name for name in vars(Calls) if name.startswith("call_")]
# Under a sanitizer these take many seconds.
SELDOM = {"call_match_spectral", "call_match_partial", "call_match_prepared", "call_match_by_shape"}


def disturb(given, stop):
    """Changes the arrays that were handed over, until it is told to stop."""
    random = np.random.default_rng(0)
    while not stop.is_set():
        for array, before in list(given):
            if not (
                isinstance(array, np.ndarray) and array.flags.writeable and array.size and array.dtype.kind in "if"
            ):
                continue
            worst = [np.nan, np.inf, -1e4] if array.dtype.kind == "f" else [np.iinfo(array.dtype).max, -1, 100]
            array.flat[random.integers(array.size)] = random.choice(worst)
            array[...] = before
        time.sleep(0)


def run(number):
    """One call; the name of what was called, and how it ended."""
    calls = Calls(number)
    name = calls.pick(*FUNCTIONS)
    if name in SELDOM and calls.chance(0.95):
        name = calls.pick(*FUNCTIONS)
    stop = threading.Event()
    disturber = threading.Thread(target=disturb, args=(calls.given, stop))
    is_disturbed = number % 6 == 5
    if is_disturbed:
        disturber.start()
    try:
        getattr(calls, name)()
        ended = "returned"
    except DOCUMENTED as error:
        ended = type(error).__name__
        assert str(error), f"{name} raised {ended} without a word"
    finally:
        stop.set()
        if is_disturbed:
            disturber.join()
    for array, before in calls.given if not is_disturbed else ():
        assert repr(array.tolist()) == repr(before.tolist()), f"{name} changed its input"
    return name.removeprefix("call_"), ended


def main():
    count, first = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0
    log = open(os.environ.get("RANDOM_CALLS_LOG", os.devnull), "w")  # noqa: SIM115
    counts, ends, failures = {}, {}, []
    warnings.simplefilter("ignore", UserWarning)  # most of the maps are not to be used
    for number in range(first, first + count):
        log.seek(0)
        log.write(f"{number}\n")
        log.flush()
        try:
            name, ended = run(number)
        except Exception as error:  # whatever it is, the rest shall be called too
            failures.append(f"call {number}: {type(error).__name__}: {error}")
            print(failures[-1], file=sys.stderr, flush=True)
            continue
        counts.setdefault(name, {}).setdefault(ended, 0)
        counts[name][ended] += 1
        ends[ended] = ends.get(ended, 0) + 1
    report = {"calls": count, "first": first, "failures": failures, "ends": ends, "functions": counts}
    print(json.dumps(report, indent=2, sort_keys=True))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
