// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/cuts.hpp"

#include <utility>
#include <vector>

namespace counterpart::test {
namespace {

PartOfMesh with_map(counterpart::PartOfMesh part, MeshView whole) {
    return {std::move(part.mesh), VertexMap(std::move(part.whole_from_part), whole.n_vertices())};
}

}  // namespace

PartOfMesh part_of(MeshView mesh, const std::function<bool(const Eigen::RowVector3d&)>& is_kept) {
    std::vector<char> keeps;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        bool all = true;
        for (int c = 0; c < 3; ++c) all = all && is_kept(mesh.vertices.row(mesh.triangles(t, c)));
        keeps.push_back(all ? 1 : 0);
    }
    return with_map(counterpart::part_of(mesh, keeps), mesh);
}

PartOfMesh cut_by_plane(MeshView mesh, const Eigen::RowVector3d& normal, double offset) {
    return with_map(counterpart::cut_by_plane(mesh, normal, offset), mesh);
}

PartOfMesh with_holes(MeshView mesh, int count, double radius, std::uint64_t seed) {
    return with_map(cut_holes(mesh, count, radius, seed), mesh);
}

}  // namespace counterpart::test
