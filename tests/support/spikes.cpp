// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/spikes.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <cmath>

namespace counterpart::test {

TriangleMesh three_spikes(int n_subdivisions) {
    TriangleMesh mesh = make_icosphere(n_subdivisions);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const auto p = mesh.vertices.row(v);
        mesh.vertices.row(v) *= 1 + 2 * std::exp(-10 * (1 - p[0])) + 1.2 * std::exp(-10 * (1 - p[1])) +
                                1.6 * std::exp(-10 * (1 + p[1]));
    }
    return mesh;
}

}  // namespace counterpart::test
