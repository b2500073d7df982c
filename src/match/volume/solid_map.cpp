// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/volume/solid_map.hpp"

#include "base/hash_mixing.hpp"
#include "mesh/tetrahedron_faces.hpp"

namespace counterpart::volume {

SolidMap::SolidMap(const TetrahedralMesh& mesh_of_side)
    : mesh(mesh_of_side),
      across(4 * to_size(mesh.n_tetrahedra()), -1),
      colors(to_size(mesh.n_vertices()), 0) {
    find_neighbors();
    find_components();
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (colors[to_size(v)] == 0) isolated.push_back(v);
    for (Color& color : colors) color = mixed(color);
}

void SolidMap::find_neighbors() {
    constexpr Color at_boundary = Color{1} << 32U;
    for (Eigen::Index i = 0; i < mesh.tetrahedra.size(); ++i) ++colors[to_size(mesh.tetrahedra.data()[i])];
    mesh::for_each_face_group(mesh, [&](std::span<const mesh::TetrahedronFace> group) {
        if (group.size() == 2) {
            across[to_size(group[0].face)] = group[1].face;
            across[to_size(group[1].face)] = group[0].face;
            return;
        }
        ++(group.size() == 1 ? boundary_faces : overlapping_faces);
        for (const Index v : mesh::corners_of(mesh, group[0])) colors[to_size(v)] += at_boundary;
    });
}

void SolidMap::find_components() {
    std::vector<char> seen(to_size(mesh.n_tetrahedra()), 0);
    order.reserve(seen.size());
    for (Index seed = 0; seed < mesh.n_tetrahedra(); ++seed) {
        if (seen[to_size(seed)]) continue;
        component_begin.push_back(static_cast<Index>(order.size()));
        seen[to_size(seed)] = 1;
        order.push_back(seed);
        for (std::size_t done = order.size() - 1; done < order.size(); ++done) {
            for (int c = 0; c < 4; ++c) {
                const Index there = across[4 * to_size(order[done]) + to_size(c)] / 4;
                if (across[4 * to_size(order[done]) + to_size(c)] < 0 || seen[to_size(there)]) continue;
                seen[to_size(there)] = 1;
                order.push_back(there);
            }
        }
    }
    component_begin.push_back(static_cast<Index>(order.size()));
}

Color SolidMap::color_of(Index t) const {
    Color sum = 0;
    for (int c = 0; c < 4; ++c) sum += colors[to_size(corner(t, c))];
    return mixed(sum);
}

void SolidMap::refine(int rounds) {
    std::vector<Color> sums(colors.size());
    for (int round = 0; round < rounds; ++round) {
        sums.assign(colors.size(), 0);
        for (Index t = 0; t < mesh.n_tetrahedra(); ++t) {
            const Color color = color_of(t);
            for (int c = 0; c < 4; ++c) sums[to_size(corner(t, c))] += color;
        }
        for (std::size_t v = 0; v < colors.size(); ++v) colors[v] = mixed(colors[v], sums[v]);
    }
}

}  // namespace counterpart::volume
