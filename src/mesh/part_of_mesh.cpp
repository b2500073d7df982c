// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <fmt/format.h>

namespace counterpart {
namespace {

// The triangles with three kept corners.
PartOfMesh part_at(MeshView mesh, const std::vector<char>& keeps_vertex) {
    std::vector<char> is_kept;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const auto keeps = [&](int c) {
            return keeps_vertex[static_cast<std::size_t>(mesh.triangles(t, c))] != 0;
        };
        is_kept.push_back(keeps(0) && keeps(1) && keeps(2) ? 1 : 0);
    }
    return part_of(mesh, is_kept);
}

}  // namespace

PartOfMesh part_of(MeshView mesh, const std::vector<char>& is_kept) {
    require_valid(mesh);
    if (is_kept.size() != static_cast<std::size_t>(mesh.n_triangles()))
        throw InvalidInput(
            fmt::format("{} marks for a mesh of {} triangles", is_kept.size(), mesh.n_triangles()));
    std::vector<Index> number(static_cast<std::size_t>(mesh.n_vertices()), -1), kept, triangles;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (is_kept[static_cast<std::size_t>(t)] == 0) continue;
        triangles.push_back(t);
        for (int c = 0; c < 3; ++c) number[static_cast<std::size_t>(mesh.triangles(t, c))] = 0;
    }
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (number[static_cast<std::size_t>(v)] == 0) {
            number[static_cast<std::size_t>(v)] = static_cast<Index>(kept.size());
            kept.push_back(v);
        }
    PartOfMesh part;
    part.mesh.vertices = mesh.vertices(kept, Eigen::all);
    const Triangles corners = mesh.triangles(triangles, Eigen::all);
    part.mesh.triangles =
        corners.unaryExpr([&](Index v) { return number[static_cast<std::size_t>(v)]; }).eval();
    part.whole_from_part = std::move(kept);
    return part;
}

PartOfMesh cut_by_plane(MeshView mesh, const Eigen::RowVector3d& normal, double offset) {
    require_valid(mesh);
    if (!normal.allFinite() || !std::isfinite(offset))
        throw InvalidInput("the normal and the offset of a plane must be finite");
    std::vector<char> keeps;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        keeps.push_back(mesh.vertices.row(v).dot(normal) > offset ? 1 : 0);
    return part_at(mesh, keeps);
}

PartOfMesh cut_holes(MeshView mesh, int count, double radius, std::uint64_t seed) {
    require_valid(mesh);
    if (count < 0) throw InvalidInput(fmt::format("the number of holes must be 0 or more, not {}", count));
    if (!(radius >= 0 && std::isfinite(radius)))
        throw InvalidInput(fmt::format("the radius of a hole must be 0 or more, not {}", radius));
    std::vector<char> keeps(static_cast<std::size_t>(mesh.n_vertices()), 1);
    Random random(seed);
    for (int i = 0; i < count && !keeps.empty(); ++i) {
        const Eigen::RowVector3d center =
            mesh.vertices.row(static_cast<Eigen::Index>(random.below(keeps.size())));
        for (Index v = 0; v < mesh.n_vertices(); ++v)
            if ((mesh.vertices.row(v) - center).norm() <= radius) keeps[static_cast<std::size_t>(v)] = 0;
    }
    return part_at(mesh, keeps);
}

}  // namespace counterpart
