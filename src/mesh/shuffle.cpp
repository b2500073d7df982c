// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"

#include <counterpart/mesh/variants.hpp>

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

// Polygons in random order, each from a random corner on.
void shuffle_polygons(MeshView mesh, Random& random, ShuffleResult& result) {
    const Polygons& polygons = *mesh.polygons;
    const std::vector<Index> triangle_corner = polygons.triangle_corners();
    std::vector<Index> sizes, vertices, old_corner;
    for (const Index p : random_order(polygons.count(), random)) {
        const Index size = polygons.size(p);
        const auto start = static_cast<Index>(random.below(static_cast<std::uint64_t>(size)));
        sizes.push_back(size);
        for (Index k = 0; k < size; ++k) {
            const Index corner = triangle_corner[static_cast<std::size_t>(
                polygons.first[static_cast<std::size_t>(p)] + (start + k) % size)];
            old_corner.push_back(corner);
            vertices.push_back(
                result.shuffled_from_original[static_cast<std::size_t>(mesh.triangles.data()[corner])]);
        }
    }
    result.mesh = cut_into_triangles(result.mesh.vertices, sizes, vertices);
    result.original_corner_from_shuffled = result.mesh.polygons.corners.unaryExpr(
        [&](Index corner) { return old_corner[static_cast<std::size_t>(corner)]; });
}

}  // namespace

ShuffleResult shuffle(MeshView mesh, std::uint64_t seed) {
    require_valid(mesh);
    Random random(seed);
    ShuffleResult result{mesh.copy(), random_order(mesh.n_vertices(), random),
                         Triangles(mesh.n_triangles(), 3)};
    const auto renumbered = [&](Index v) {
        return result.shuffled_from_original[static_cast<std::size_t>(v)];
    };
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        result.mesh.vertices.row(renumbered(v)) = mesh.vertices.row(v);
    if (mesh.polygons != nullptr) {
        shuffle_polygons(mesh, random, result);
        return result;
    }
    const std::vector<Index> place = random_order(mesh.n_triangles(), random);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const auto first = static_cast<int>(random.below(3));
        for (int c = 0; c < 3; ++c) {
            const int corner = (first + c) % 3;
            result.mesh.triangles(place[static_cast<std::size_t>(t)], c) =
                renumbered(mesh.triangles(t, corner));
            result.original_corner_from_shuffled(place[static_cast<std::size_t>(t)], c) = 3 * t + corner;
        }
    }
    return result;
}

AttributedShuffleResult shuffle(const AttributedMesh& content, std::uint64_t seed) {
    ShuffleResult shuffled = shuffle(content.mesh, seed);
    Random random(seed + 1);
    AttributedShuffleResult result{content, std::move(shuffled.shuffled_from_original)};
    result.content.mesh = std::move(shuffled.mesh);
    const std::vector<Index>& place = result.shuffled_from_original;
    for (std::size_t v = 0; v < place.size(); ++v) {
        const auto old = static_cast<Index>(v);
        if (content.skin.weights.cols() > 0) {
            result.content.skin.joints.row(place[v]) = content.skin.joints.row(old);
            result.content.skin.weights.row(place[v]) = content.skin.weights.row(old);
        }
        for (std::size_t i = 0; i < content.morphs.size(); ++i)
            result.content.morphs[i].displacements.row(place[v]) = content.morphs[i].displacements.row(old);
        for (std::size_t i = 0; i < content.values.size(); ++i)
            result.content.values[i].values.row(place[v]) = content.values[i].values.row(old);
    }
    const auto shuffle_corners = [&](CornerAttribute& attribute) {
        if (attribute.corners.rows() == 0) return;
        const CornerAttribute original = attribute;
        const std::vector<Index> row_place = random_order(static_cast<Index>(original.values.rows()), random);
        for (std::size_t row = 0; row < row_place.size(); ++row)
            attribute.values.row(row_place[row]) = original.values.row(static_cast<Index>(row));
        for (Eigen::Index i = 0; i < attribute.corners.size(); ++i) {
            const Index corner = shuffled.original_corner_from_shuffled(i / 3, i % 3);
            const Index row = original.corners(corner / 3, corner % 3);
            attribute.corners(i / 3, i % 3) = row < 0 ? -1 : row_place[static_cast<std::size_t>(row)];
        }
    };
    for (CornerAttribute& attribute : result.content.texture_coordinates) shuffle_corners(attribute);
    for (CornerAttribute& attribute : result.content.colors) shuffle_corners(attribute);
    return result;
}

TriangleMesh move_at_random(MeshView mesh, std::uint64_t seed) {
    require_valid(mesh);
    Random random(seed);
    Eigen::Vector4d q;
    for (double& x : q) x = random.uniform(-1, 1);
    const Eigen::Matrix3d rotation = Eigen::Quaterniond(q).normalized().toRotationMatrix();
    const double scale = random.uniform(0.5, 2);
    Eigen::RowVector3d offset;
    for (double& x : offset) x = random.uniform(-3, 3);
    return {((scale * mesh.vertices) * rotation.transpose()).rowwise() + offset, mesh.triangles,
            mesh.polygons == nullptr ? Polygons() : *mesh.polygons};
}

}  // namespace counterpart
