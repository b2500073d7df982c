// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/mesh/variants.hpp>

namespace counterpart::test {

DisguisedMesh shuffled(const TriangleMesh& mesh, std::uint64_t seed) {
    ShuffleResult result = shuffle(mesh, seed);
    return {std::move(result.mesh), {std::move(result.shuffled_from_original), mesh.n_vertices()}};
}

TriangleMesh moved(const TriangleMesh& mesh, std::uint64_t seed) { return move_at_random(mesh, seed); }

DisguisedMesh posed(const TriangleMesh& mesh) {
    return shuffled(moved(deform(mesh, {.bend = 0.5, .twist = 0.3}), 4), 9);
}

TriangleMesh with_separate_triangles(const TriangleMesh& mesh) {
    TriangleMesh result{Points(3 * mesh.n_triangles(), 3), Triangles(mesh.n_triangles(), 3)};
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            result.vertices.row(3 * t + c) = mesh.vertices.row(mesh.triangles(t, c));
            result.triangles(t, c) = 3 * t + c;
        }
    }
    return result;
}

TriangleMesh mirrored(const TriangleMesh& mesh) {
    TriangleMesh result = mesh;
    result.vertices.col(0) *= -1;
    result.triangles.col(1).swap(result.triangles.col(2));
    return result;
}

}  // namespace counterpart::test
