// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/base/random.hpp>

#include <Eigen/Geometry>

namespace counterpart::test {

DisguisedMesh shuffled(const TriangleMesh& mesh, std::uint64_t seed) {
    Random random(seed);
    DisguisedMesh result{mesh, identity_map(mesh.n_vertices())};
    random.shuffle(result.mesh_from_original.image);
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        result.mesh.vertices.row(result.mesh_from_original[v]) = mesh.vertices.row(v);
    std::vector<Index> place = identity_map(mesh.n_triangles()).image;
    random.shuffle(place);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const auto first = static_cast<int>(random.below(3));
        for (int c = 0; c < 3; ++c) {
            result.mesh.triangles(place[static_cast<std::size_t>(t)], c) =
                result.mesh_from_original[mesh.triangles(t, (first + c) % 3)];
        }
    }
    return result;
}

TriangleMesh moved(const TriangleMesh& mesh, std::uint64_t seed) {
    Random random(seed);
    const Eigen::Quaterniond rotation = Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-1, 1),
                                                           random.uniform(-1, 1), random.uniform(-1, 1))
                                            .normalized();
    const double scale = random.uniform(0.5, 2);
    const Eigen::RowVector3d offset(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
    TriangleMesh result = mesh;
    result.vertices = (scale * (mesh.vertices * rotation.toRotationMatrix().transpose())).rowwise() + offset;
    return result;
}

TriangleMesh mirrored(const TriangleMesh& mesh) {
    TriangleMesh result = mesh;
    result.vertices.col(0) *= -1;
    result.triangles.col(1).swap(result.triangles.col(2));
    return result;
}

}  // namespace counterpart::test
