// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/random.hpp>
#include <counterpart/mesh/disguise.hpp>

#include <numeric>

#include <Eigen/Geometry>

namespace counterpart {
namespace {

std::vector<Index> random_order(Index count, Random& random) {
    std::vector<Index> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    random.shuffle(order);
    return order;
}

}  // namespace

ShuffleResult shuffle(const TriangleMesh& mesh, std::uint64_t seed) {
    require_valid(mesh);
    Random random(seed);
    ShuffleResult result{mesh, random_order(mesh.n_vertices(), random)};
    const auto renumbered = [&](Index v) {
        return result.shuffled_from_original[static_cast<std::size_t>(v)];
    };
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        result.mesh.vertices.row(renumbered(v)) = mesh.vertices.row(v);
    const std::vector<Index> place = random_order(mesh.n_triangles(), random);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const auto first = static_cast<int>(random.below(3));
        for (int c = 0; c < 3; ++c) {
            result.mesh.triangles(place[static_cast<std::size_t>(t)], c) =
                renumbered(mesh.triangles(t, (first + c) % 3));
        }
    }
    return result;
}

TriangleMesh move_at_random(const TriangleMesh& mesh, std::uint64_t seed) {
    require_valid(mesh);
    Random random(seed);
    Eigen::Vector4d q;
    for (double& x : q) x = random.uniform(-1, 1);
    const Eigen::Matrix3d rotation = Eigen::Quaterniond(q).normalized().toRotationMatrix();
    const double scale = random.uniform(0.5, 2);
    Eigen::RowVector3d offset;
    for (double& x : offset) x = random.uniform(-3, 3);
    return {((scale * mesh.vertices) * rotation.transpose()).rowwise() + offset, mesh.triangles};
}

}  // namespace counterpart
