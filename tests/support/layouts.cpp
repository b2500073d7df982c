// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/layouts.hpp"

#include "support/character.hpp"
#include "support/edits.hpp"
#include "support/polygons.hpp"

#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>

namespace counterpart::test {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

LaidOut laid_out_character() {
    AttributedMesh content = make_character({.subdivisions = 0}).content;
    return {std::move(content.mesh), std::move(content.texture_coordinates.at(0))};
}

LaidOut laid_out_ball() {
    LaidOut result{make_icosphere(3), {}};
    const TriangleMesh& ball = result.mesh;
    result.uv = {Matrix(2 * ball.n_vertices(), 2), ball.triangles};
    const auto from_pole = [](double x, double y, double z) -> Eigen::RowVector2d {  // stereographic
        return Eigen::RowVector2d(x, y) / std::max(1 + z, 0.1);
    };
    for (Index v = 0; v < ball.n_vertices(); ++v) {
        const Eigen::RowVector3d p = ball.vertices.row(v);
        result.uv.values.row(2 * v) = from_pole(p[0], p[1], p[2]);
        result.uv.values.row(2 * v + 1) = from_pole(-p[0], p[1], -p[2]) + Eigen::RowVector2d(4, 0);
    }
    for (Index t = 0; t < ball.n_triangles(); ++t) {
        const Index back = ball.vertices(ball.triangles.row(t), 2).sum() < 0 ? 1 : 0;
        result.uv.corners.row(t) = 2 * ball.triangles.row(t).array() + back;
    }
    result.mesh = deform(ball, {.warp = 0.2});
    return result;
}

LaidOut retriangulated(const LaidOut& original, std::uint64_t seed) {
    // A vertex for each row, so that seams are boundaries, which stay.
    TriangleMesh split{Points(original.uv.values.rows(), 3), original.uv.corners};
    std::vector<Index> vertex_of_row(at(split.n_vertices()));
    for (Index t = 0; t < split.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) vertex_of_row[at(split.triangles(t, c))] = original.mesh.triangles(t, c);
    for (Index row = 0; row < split.n_vertices(); ++row)  // of rows that no corner has: that of vertex 0
        split.vertices.row(row) = original.mesh.vertices.row(vertex_of_row[at(row)]);
    const RetriangulateResult other = retriangulate(split, {.seed = seed});
    LaidOut result;
    result.uv = {original.uv.values(other.original_from_mesh, Eigen::all), other.mesh.triangles};
    std::vector<Index> number(at(original.mesh.n_vertices()), -1);
    result.mesh.triangles.resize(other.mesh.n_triangles(), 3);
    for (Index t = other.mesh.n_triangles() - 1; t >= 0; --t)  // another order
        for (int c = 0; c < 3; ++c) {
            const Index v = vertex_of_row[at(other.original_from_mesh[at(other.mesh.triangles(t, c))])];
            if (number[at(v)] < 0) {
                number[at(v)] = static_cast<Index>(result.original_from_mesh.size());
                result.original_from_mesh.push_back(v);
            }
            result.mesh.triangles(t, c) = number[at(v)];
        }
    result.mesh.vertices = original.mesh.vertices(result.original_from_mesh, Eigen::all);
    return result;
}

LaidOut laid_out_square(int cells, std::uint64_t seed) {
    PolygonList quads;
    const Index n = cells + 1;
    for (Index i = 0; i < n * n; ++i) quads.vertices.emplace_back(i % n, i / n, 0);
    for (Index i = 0; i + n < n * n; ++i)
        if (i % n < cells) quads.add({i, i + 1, i + 1 + n, i + n});
    LaidOut result{cut_at_random(quads.cut(), seed), {}};
    result.mesh.polygons = {};
    result.mesh.vertices /= cells;
    result.uv = {result.mesh.vertices.leftCols<2>(), result.mesh.triangles};
    return result;
}

LaidOut joined(const LaidOut& a, const LaidOut& b) {
    LaidOut result{joined(a.mesh, b.mesh), {}};
    const Index n = static_cast<Index>(a.uv.values.rows());
    result.uv.values.resize(n + b.uv.values.rows(), 2);
    result.uv.values << a.uv.values, b.uv.values;
    result.uv.corners.resize(result.mesh.triangles.rows(), 3);
    result.uv.corners << a.uv.corners, (b.uv.corners.array() + n).matrix();
    return result;
}

}  // namespace counterpart::test
