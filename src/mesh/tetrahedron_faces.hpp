// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace counterpart::mesh {

/// The face of a tetrahedron that is opposite to a corner: 4 * tetrahedron + corner.
struct TetrahedronFace {
    std::uint64_t others = 0;  ///< its two larger vertices, which with the smallest name it
    Index face = 0;
    bool operator<(const TetrahedronFace& other) const {
        return others != other.others ? others < other.others : face < other.face;
    }
};

/// Counter-clockwise seen from outside the tetrahedron.
inline std::array<Index, 3> corners_of(const TetrahedralMesh& mesh, const TetrahedronFace& face) {
    constexpr std::array<std::array<int, 3>, 4> opposite = {{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    const std::array<int, 3>& at = opposite[static_cast<std::size_t>(face.face % 4)];
    const Index t = face.face / 4;
    return {mesh.tetrahedra(t, at[0]), mesh.tetrahedra(t, at[1]), mesh.tetrahedra(t, at[2])};
}

/// Calls body(group) for the equal faces: one at the boundary, two inside, more where tetrahedra overlap; in
/// the order of their smallest vertex. O(T) but for sorting those at one vertex.
template <class Body>
void for_each_face_group(const TetrahedralMesh& mesh, const Body& body) {
    const auto n = static_cast<std::size_t>(mesh.n_vertices());
    std::vector<std::size_t> end(n + 2, 0);
    std::vector<TetrahedronFace> faces(static_cast<std::size_t>(mesh.tetrahedra.size()));
    const auto for_each_face = [&](const auto& visit) {
        for (Index f = 0; f < static_cast<Index>(faces.size()); ++f) {
            std::array<Index, 3> v = corners_of(mesh, {0, f});
            std::sort(v.begin(), v.end());
            visit(static_cast<std::size_t>(v[0]),
                  TetrahedronFace{
                      (static_cast<std::uint64_t>(v[1]) << 32U) | static_cast<std::uint64_t>(v[2]), f});
        }
    };
    for_each_face([&](std::size_t smallest, const TetrahedronFace&) { ++end[smallest + 2]; });
    for (std::size_t v = 0; v + 1 < end.size(); ++v) end[v + 1] += end[v];
    for_each_face(
        [&](std::size_t smallest, const TetrahedronFace& face) { faces[end[smallest + 1]++] = face; });
    for (std::size_t v = 0; v < n; ++v) {
        const std::span<TetrahedronFace> bucket = std::span(faces).subspan(end[v], end[v + 1] - end[v]);
        std::sort(bucket.begin(), bucket.end());
        for (std::size_t i = 0, j = 0; i < bucket.size(); i = j) {
            for (j = i + 1; j < bucket.size() && bucket[j].others == bucket[i].others;) ++j;
            body(std::span<const TetrahedronFace>(bucket.subspan(i, j - i)));
        }
    }
}

}  // namespace counterpart::mesh
