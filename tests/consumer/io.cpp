// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/shapes.hpp>

int main() {
    counterpart::write_mesh(counterpart::make_torus(8, 12), "torus.glb");
    return counterpart::read_mesh("torus.glb").mesh.n_triangles() == 192 ? 0 : 1;
}
