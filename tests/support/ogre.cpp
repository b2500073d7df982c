// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/ogre.hpp"

#include "numerics/rotation.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <vector>

#include <Eigen/Geometry>

namespace counterpart::test {
namespace {

// A horn, `length` long, that tapers along `along` and leans to one side.
TriangleMesh horn(const Eigen::Vector3d& root, const Eigen::Vector3d& along, double length) {
    TriangleMesh mesh = make_icosphere(1);
    const Eigen::Quaterniond turn = numerics::shortest_rotation(Eigen::Vector3d::UnitZ(), along);
    for (auto p : mesh.vertices.rowwise()) {
        const double height = (p[2] + 1) / 2, width = 0.25 * (1 - 0.6 * height);
        const Eigen::Vector3d shaped(width * p[0] + 0.3 * height * height, 0.8 * width * p[1], height);
        p = (root + length * (turn * shaped)).transpose();
    }
    return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
    const Index n = mesh.n_vertices(), m = mesh.n_triangles();
    mesh.vertices.conservativeResize(n + part.n_vertices(), 3);
    mesh.vertices.bottomRows(part.n_vertices()) = part.vertices;
    mesh.triangles.conservativeResize(m + part.n_triangles(), 3);
    mesh.triangles.bottomRows(part.n_triangles()) = part.triangles.array() + n;
}

// The vertex farthest in a direction, among those above or below a height.
Eigen::Vector3d extreme(const TriangleMesh& body, const Eigen::Vector3d& direction, double least_y,
                        double most_y) {
    Index best = -1;
    for (Index v = 0; v < body.n_vertices(); ++v) {
        if (body.vertices(v, 1) < least_y || body.vertices(v, 1) > most_y) continue;
        if (best < 0 || body.vertices.row(v).dot(direction) > body.vertices.row(best).dot(direction))
            best = v;
    }
    return body.vertices.row(best).transpose();
}

}  // namespace

TriangleMesh make_ogre() {
    const TriangleMesh body = make_body({.subdivisions = 1});
    const double low = body.vertices.col(1).minCoeff(), high = body.vertices.col(1).maxCoeff();
    const double height = high - low;
    TriangleMesh ogre = body;
    const auto add_claws = [&](const Eigen::Vector3d& tip, const Eigen::Vector3d& along,
                               const Eigen::Vector3d& across) {
        for (int i = -2; i <= 2; ++i)
            append(ogre, horn(tip + 0.012 * i * height * across, along, 0.03 * height));
    };
    for (const double side : {-1.0, 1.0}) {
        const Eigen::Vector3d out(side, 0, 0), front = Eigen::Vector3d::UnitZ();
        add_claws(extreme(body, out, low, high), out, front);
        add_claws(extreme(body, front + 0.5 * out - Eigen::Vector3d::UnitY(), low, low + 0.1 * height), front,
                  out);
    }
    const Eigen::Vector3d face = extreme(body, Eigen::Vector3d::UnitZ(), high - 0.15 * height, high);
    for (const double row : {-1.0, 1.0})
        for (int i = -5; i <= 5; ++i) {
            const double x = 0.008 * i * height;
            const Eigen::Vector3d root = face + Eigen::Vector3d(x, 0.012 * row * height, -4 * x * x / height);
            append(ogre, horn(root, {0, -row, 0.2}, 0.01 * height));
        }
    for (const double side : {-1.0, 1.0})
        append(ogre,
               horn(face + height * Eigen::Vector3d(0.025 * side, 0.05, -0.005), {0, 0, 1}, 0.02 * height));
    return ogre;
}

}  // namespace counterpart::test
