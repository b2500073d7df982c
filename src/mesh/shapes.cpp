// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Two triangles for each of rows x columns squares.
void require_countable(const char* shape, int rows, int columns) {
    if (2 * std::int64_t{rows} * columns > max_triangles)
        throw InvalidInput(fmt::format("{}: {} x {} squares are more than {} triangles", shape, rows, columns,
                                       max_triangles));
}

}  // namespace

TriangleMesh make_icosphere(int subdivisions) {
    if (subdivisions < 0 || subdivisions > 10)
        throw InvalidInput("make_icosphere: subdivisions must be 0 to 10");
    constexpr double p = std::numbers::phi;
    TriangleMesh mesh{Points(12, 3), Triangles(20, 3)};
    mesh.vertices << -1, p, 0, 1, p, 0, -1, -p, 0, 1, -p, 0, 0, -1, p, 0, 1, p, 0, -1, -p, 0, 1, -p, p, 0, -1,
        p, 0, 1, -p, 0, -1, -p, 0, 1;
    mesh.vertices.rowwise().normalize();
    mesh.triangles << 0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6,
        7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9, 8, 1;
    for (int i = 0; i < subdivisions; ++i) {
        mesh = subdivide(mesh);
        mesh.vertices.rowwise().normalize();
    }
    return mesh;
}

TriangleMesh make_torus(int rings, int segments) {
    if (rings < 3 || segments < 3) throw InvalidInput("make_torus: rings and segments must be at least 3");
    require_countable("make_torus", rings, segments);
    TriangleMesh mesh{Points(rings * segments, 3), Triangles(2 * rings * segments, 3)};
    constexpr double minor = 0.4;
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < segments; ++j) {
            const double u = 2 * std::numbers::pi * i / rings, v = 2 * std::numbers::pi * j / segments;
            const double radius = 1 + minor * std::cos(v);
            mesh.vertices.row(i * segments + j) << radius * std::cos(u), radius * std::sin(u),
                minor * std::sin(v);
            const Index a = i * segments + j, b = (i + 1) % rings * segments + j;
            const Index c = (i + 1) % rings * segments + (j + 1) % segments,
                        d = i * segments + (j + 1) % segments;
            mesh.triangles.row(2 * a) << a, b, c;
            mesh.triangles.row(2 * a + 1) << a, c, d;
        }
    }
    return mesh;
}

TriangleMesh make_grid(int columns, int rows) {
    if (columns < 1 || rows < 1) throw InvalidInput("make_grid: columns and rows must be at least 1");
    require_countable("make_grid", columns, rows);
    TriangleMesh mesh{Points((columns + 1) * (rows + 1), 3), Triangles(2 * columns * rows, 3)};
    for (int y = 0; y <= rows; ++y)
        for (int x = 0; x <= columns; ++x)
            mesh.vertices.row(y * (columns + 1) + x) << double(x) / columns, double(y) / rows, 0;
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            const Index a = y * (columns + 1) + x, b = a + 1, c = b + columns + 1, d = a + columns + 1;
            mesh.triangles.row(2 * (y * columns + x)) << a, b, c;
            mesh.triangles.row(2 * (y * columns + x) + 1) << a, c, d;
        }
    }
    return mesh;
}

}  // namespace counterpart
