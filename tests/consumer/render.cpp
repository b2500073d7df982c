// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/render/scene.hpp>

int main() {
    const counterpart::TriangleMesh mesh = counterpart::make_torus(8, 12);
    const counterpart::render::Surface torus = {
        mesh, counterpart::Points::Constant(mesh.n_vertices(), 3, 0.5), {}};
    const counterpart::render::Image image =
        counterpart::render::render({{torus}, {}, {}}, {.width = 64, .height = 40});
    return counterpart::render::encode_png(image).starts_with("\x89PNG") ? 0 : 1;
}
