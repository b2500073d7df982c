// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The figure is built of unit cubes; the outer squares of the cubes, each cut into four triangles around its
// middle (a cut that a mirror does not change), are subdivided and smoothed.
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <array>
#include <map>
#include <set>
#include <vector>

namespace counterpart {
namespace {

using Cell = std::array<int, 3>;  // x to the left, y up, z to the front

void add_box(std::set<Cell>& cells, const Cell& low, const Cell& high) {
    for (int x = low[0]; x <= high[0]; ++x)
        for (int y = low[1]; y <= high[1]; ++y)
            for (int z = low[2]; z <= high[2]; ++z) cells.insert({x, y, z});
}

std::set<Cell> body_cells(bool symmetric) {
    std::set<Cell> cells;
    add_box(cells, {-1, 3, 0}, {1, 6, 0});   // trunk
    add_box(cells, {0, 7, 0}, {0, 9, 0});    // neck and head
    add_box(cells, {0, 8, 1}, {0, 8, 1});    // nose
    add_box(cells, {0, 3, -3}, {0, 3, -1});  // tail
    add_box(cells, {0, 4, -3}, {0, 4, -3});  // its tip
    for (const int side : {-1, 1}) {
        add_box(cells, {side, 0, 0}, {side, 2, 0});  // leg
        add_box(cells, {side, 0, 1}, {side, 0, 1});  // foot
    }
    add_box(cells, {-5, 6, 0}, {-2, 6, 0});                // right arm
    add_box(cells, {2, 6, 0}, {5, 6, 0});                  // left arm
    if (!symmetric) add_box(cells, {5, 7, 0}, {5, 8, 0});  // raised
    return cells;
}

TriangleMesh outer_squares(const std::set<Cell>& cells) {
    std::map<Cell, Index> number_of;  // by twice the coordinates: cubes are odd, corners even
    std::vector<Eigen::RowVector3d> vertices;
    const auto vertex = [&](const Cell& twice) {
        const auto [entry, is_new] = number_of.try_emplace(twice, static_cast<Index>(vertices.size()));
        if (is_new) vertices.push_back(0.05 * Eigen::RowVector3d(twice[0], twice[1], twice[2]));
        return entry->second;
    };
    std::vector<std::array<Index, 3>> triangles;
    for (const Cell& cell : cells) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int sign : {-1, 1}) {
                const auto a = static_cast<std::size_t>(axis), b = (a + 1) % 3, c = (a + 2) % 3;
                Cell next = cell;
                next[a] += sign;
                if (cells.contains(next)) continue;
                Cell middle = {2 * cell[0], 2 * cell[1], 2 * cell[2]};
                middle[a] += sign;
                std::array<Index, 4> corner;
                for (const std::size_t i : {0U, 1U, 2U, 3U}) {  // counter-clockwise seen from outside
                    Cell at = middle;
                    at[b] += i == 1 || i == 2 ? sign : -sign;
                    at[c] += i >= 2 ? 1 : -1;
                    corner[i] = vertex(at);
                }
                for (const std::size_t i : {0U, 1U, 2U, 3U})
                    triangles.push_back({vertex(middle), corner[i], corner[(i + 1) % 4]});
            }
        }
    }
    TriangleMesh mesh{Points(static_cast<Index>(vertices.size()), 3),
                      Triangles(static_cast<Index>(triangles.size()), 3)};
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        mesh.vertices.row(v) = vertices[static_cast<std::size_t>(v)];
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            mesh.triangles(t, c) = triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(c)];
    return mesh;
}

// Every vertex halfway to the mean of its neighbors.
Points smoothed(MeshView mesh) {
    const Adjacency adjacency(mesh);
    Points result(mesh.n_vertices(), 3);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (const Index w : adjacency.neighbors(v)) sum += mesh.vertices.row(w);
        result.row(v) = 0.5 * mesh.vertices.row(v) + 0.5 / double(adjacency.neighbors(v).size()) * sum;
    }
    return result;
}

}  // namespace

TriangleMesh make_body(const BodyOptions& options) {
    if (options.subdivisions < 0 || options.subdivisions > 7)
        throw InvalidInput("make_body: subdivisions must be 0 to 7");
    TriangleMesh mesh = outer_squares(body_cells(options.symmetric));
    for (int i = 0; i < options.subdivisions; ++i) {
        mesh = subdivide(mesh);
        for (int round = 0; round < 2; ++round) mesh.vertices = smoothed(mesh);
    }
    return mesh;
}

}  // namespace counterpart
