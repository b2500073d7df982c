// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "mesh/tetrahedron_faces.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <numeric>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart {

using namespace mesh;

namespace {

void require_corners(const TetrahedralMesh& mesh, Index t) {
    for (int c = 0; c < 4; ++c) {
        const Index v = mesh.tetrahedra(t, c);
        if (v < 0 || v >= mesh.n_vertices())
            throw InvalidInput(fmt::format("tetrahedron {} names vertex {}, but vertices run from 0 to {}", t,
                                           v, mesh.n_vertices() - 1));
        for (int d = 0; d < c; ++d)
            if (mesh.tetrahedra(t, d) == v)
                throw InvalidInput(fmt::format("tetrahedron {} has vertex {} twice", t, v));
    }
}

std::vector<Index> random_permutation(Index count, Random& random) {
    std::vector<Index> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    random.shuffle(order);
    return order;
}

}  // namespace

void require_valid(const TetrahedralMesh& mesh) {
    if (mesh.n_tetrahedra() == 0) throw InvalidInput("the mesh has no tetrahedra");
    constexpr Index most = Index{1} << 27;
    if (mesh.tetrahedra.rows() > most)
        throw InvalidInput(fmt::format("the mesh has {} tetrahedra; at most {} are supported",
                                       mesh.tetrahedra.rows(), most));
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (!mesh.vertices.row(v).allFinite())
            throw InvalidInput(fmt::format("vertex {} has a coordinate that is not finite", v));
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) require_corners(mesh, t);
    const Vector volumes = tetrahedron_volumes(mesh);
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t)
        if (!(volumes[t] > 0))
            throw InvalidInput(
                volumes[t] < 0
                    ? fmt::format("tetrahedron {} is inverted: its volume is {:.4g}", t, volumes[t])
                    : fmt::format("tetrahedron {} has no volume", t));
}

Vector tetrahedron_volumes(const TetrahedralMesh& mesh) {
    Vector volumes(mesh.n_tetrahedra());
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) {
        const auto at = [&](int c) -> Eigen::Vector3d { return mesh.vertices.row(mesh.tetrahedra(t, c)); };
        const Eigen::Vector3d a = at(0);
        volumes[t] = (at(1) - a).cross(at(2) - a).dot(at(3) - a) / 6;
    }
    return volumes;
}

TriangleMesh all_faces(const TetrahedralMesh& mesh) {
    std::vector<Index> corners;
    corners.reserve(static_cast<std::size_t>(7 * mesh.n_tetrahedra()));
    for_each_face_group(mesh, [&](std::span<const TetrahedronFace> group) {
        const std::array<Index, 3> face = corners_of(mesh, group[0]);
        corners.insert(corners.end(), face.begin(), face.end());
    });
    TriangleMesh faces{mesh.vertices, {}};
    faces.triangles =
        Eigen::Map<const Triangles>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
    return faces;
}

SolidBoundary boundary(const TetrahedralMesh& mesh) {
    std::vector<Index> corners, number(static_cast<std::size_t>(mesh.n_vertices()), -1);
    for_each_face_group(mesh, [&](std::span<const TetrahedronFace> group) {
        if (group.size() != 1) return;
        for (const Index v : corners_of(mesh, group[0])) {
            corners.push_back(v);
            number[static_cast<std::size_t>(v)] = 0;
        }
    });
    SolidBoundary result;
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        if (number[static_cast<std::size_t>(v)] < 0) continue;
        number[static_cast<std::size_t>(v)] = static_cast<Index>(result.vertices.size());
        result.vertices.push_back(v);
    }
    for (Index& v : corners) v = number[static_cast<std::size_t>(v)];
    result.mesh.vertices = mesh.vertices(result.vertices, Eigen::all);
    result.mesh.triangles =
        Eigen::Map<const Triangles>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
    return result;
}

TetrahedralShuffleResult shuffle(const TetrahedralMesh& mesh, std::uint64_t seed) {
    require_valid(mesh);
    Random random(seed);
    TetrahedralShuffleResult result{mesh, random_permutation(mesh.n_vertices(), random)};
    const std::vector<Index>& place = result.shuffled_from_original;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        result.mesh.vertices.row(place[static_cast<std::size_t>(v)]) = mesh.vertices.row(v);
    const std::vector<Index> row = random_permutation(mesh.n_tetrahedra(), random);
    constexpr std::array<std::array<int, 4>, 3> even = {{{0, 1, 2, 3}, {1, 0, 3, 2}, {1, 2, 0, 3}}};
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) {
        const std::array<int, 4>& order = even[static_cast<std::size_t>(random.below(even.size()))];
        for (int c = 0; c < 4; ++c)
            result.mesh.tetrahedra(row[static_cast<std::size_t>(t)], c) =
                place[static_cast<std::size_t>(mesh.tetrahedra(t, order[static_cast<std::size_t>(c)]))];
    }
    return result;
}

}  // namespace counterpart
