# SPDX-FileCopyrightText: 2026 The counterpart authors
# SPDX-License-Identifier: MIT
"""Random calls of what reads, writes, makes, changes and shows meshes."""

import os
import pickle
import tempfile

import counterpart3d as cp
from random_draws import FLOATS, INTEGERS, Draws


class Files(Draws):
    def call_landmark_file(self):
        with tempfile.TemporaryDirectory() as folder:
            ending = self.pick(".mrk.json", ".fcsv", ".json", ".csv", odd=[".tps", ".none"])
            file = os.path.join(folder, "points" + ending)
            axes = self.pick("LPS", "RAS", odd=[None, "XYZ"])
            cp.write_landmarks(self.landmarks(self.mesh()), file, axes=axes)
            return cp.read_landmarks(file)

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

    def call_mesh_attributes(self):
        a = self.mesh()
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, self.pick("a.glb", "a.obj", "a.ply"))
            cp.write(cp.Mesh(*a, **self.attributes(a)), file)
            return cp.read(file)

    def call_polygons(self):
        sizes = self.random.integers(2 if self.rarely() else 3, 6, self.pick(0, 1, 4))
        n_corners = max(sizes.sum() + self.pick(0, odd=[1, -1]), 0)
        corners = self.random.integers(-1 if self.rarely() else 0, 9, n_corners)
        points = self.handed(self.random.normal(size=(9, 3)), FLOATS)
        mesh = cp.Mesh.from_polygons(points, self.handed(sizes, INTEGERS), self.handed(corners, INTEGERS))
        return cp.shuffle(mesh), cp.inspect(pickle.loads(pickle.dumps(mesh)))

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
