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

TriangleMesh mirrored(const TriangleMesh& mesh) {
    TriangleMesh result = mesh;
    result.vertices.col(0) *= -1;
    result.triangles.col(1).swap(result.triangles.col(2));
    return result;
}

}  // namespace counterpart::test
