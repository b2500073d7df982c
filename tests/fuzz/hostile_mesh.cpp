// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "fuzz/hostile_mesh.hpp"

#include "base/random.hpp"

#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace counterpart::fuzz {
namespace {

TriangleMesh joined(const TriangleMesh& one, const TriangleMesh& two) {
    TriangleMesh both{Points(one.n_vertices() + two.n_vertices(), 3),
                      Triangles(one.n_triangles() + two.n_triangles(), 3)};
    both.vertices << one.vertices, two.vertices;
    both.triangles << one.triangles, (two.triangles.array() + one.n_vertices()).matrix();
    return both;
}

int from(int least, int count, Random& random) {
    return least + static_cast<int>(random.below(static_cast<std::uint64_t>(count)));
}

// In variables, since compilers differ in which argument they work out first.
TriangleMesh small_mesh(Random& random) {
    const int kind = from(0, 4, random), n = from(6, 5, random), m = from(4, 3, random);
    switch (kind) {
        case 0:
            return make_icosphere(1);
        case 1:
            return make_torus(n, m);
        case 2:
            return make_grid(n - 3, m);
        default:
            return joined(make_icosphere(n % 2), make_grid(n - 4, 4));
    }
}

TriangleMesh base_mesh(Random& random, HostileSize size) {
    if (size == HostileSize::small) return small_mesh(random);
    switch (random.below(6)) {
        case 0:
            return make_icosphere(from(1, 3, random));
        case 1:
            return make_torus(8 + static_cast<int>(random.below(12)), 5 + static_cast<int>(random.below(6)));
        case 2:
            return make_grid(4 + static_cast<int>(random.below(16)), 4 + static_cast<int>(random.below(8)));
        case 3:
            return joined(base_mesh(random, size), base_mesh(random, size));
        default: {
            BodyOptions options;
            options.subdivisions = 0;
            return make_body(options);
        }
    }
}

Index any(Random& random, Index count) {
    return static_cast<Index>(random.below(static_cast<std::uint64_t>(count)));
}

void append_triangle(TriangleMesh& mesh, Index a, Index b, Index c) {
    mesh.triangles.conservativeResize(mesh.n_triangles() + 1, 3);
    mesh.triangles.row(mesh.n_triangles() - 1) << a, b, c;
}

void append_vertex(TriangleMesh& mesh, const Eigen::RowVector3d& position) {
    mesh.vertices.conservativeResize(mesh.n_vertices() + 1, 3);
    mesh.vertices.row(mesh.n_vertices() - 1) = position;
}

// The triangles around a vertex go, but not the last one of the mesh.
void cut_hole(TriangleMesh& mesh, Random& random) {
    const Index center = any(random, mesh.n_vertices());
    std::vector<Index> kept;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if ((mesh.triangles.row(t).array() != center).all()) kept.push_back(t);
    if (!kept.empty()) mesh.triangles = mesh.triangles(kept, Eigen::all).eval();
}

void flip_triangles(TriangleMesh& mesh, Random& random) {
    const double share = random.uniform();
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (random.uniform() < share) std::swap(mesh.triangles(t, 0), mesh.triangles(t, 1));
}

void make_slivers(TriangleMesh& mesh, Random& random) {
    for (int i = 0; i < 20; ++i) {
        const auto corners = mesh.triangles.row(any(random, mesh.n_triangles()));
        mesh.vertices.row(corners(0)) =
            mesh.vertices.row(corners(1)) +
            1e-12 * (mesh.vertices.row(corners(2)) - mesh.vertices.row(corners(1)));
    }
}

void double_vertices(TriangleMesh& mesh, Random& random) {
    for (int i = 0; i < 10; ++i) {
        const Index t = any(random, mesh.n_triangles());
        const Eigen::RowVector3d position = mesh.vertices.row(mesh.triangles(t, 0));
        append_vertex(mesh, position);
        mesh.triangles(t, 0) = mesh.n_vertices() - 1;
    }
}

void double_triangles(TriangleMesh& mesh, Random& random) {
    for (int i = 0; i < 10; ++i) {
        const Eigen::RowVector3i corners = mesh.triangles.row(any(random, mesh.n_triangles()));
        append_triangle(mesh, corners(0), corners(1), corners(random.below(4) == 0 ? 1 : 2));
    }
}

void grow_fan(TriangleMesh& mesh, Random& random) {
    const Eigen::RowVector3i corners = mesh.triangles.row(any(random, mesh.n_triangles()));
    const std::uint64_t size = 1 + random.below(300);
    for (std::uint64_t i = 0; i < size; ++i)
        append_triangle(mesh, corners(0), corners(1), any(random, mesh.n_vertices()));
}

void isolate_vertices(TriangleMesh& mesh, Random& random) {
    for (int i = 0; i < 5; ++i) append_vertex(mesh, Eigen::RowVector3d::Constant(random.uniform(-2, 2)));
}

void scale_wildly(TriangleMesh& mesh, Random& random) {
    mesh.vertices *= std::pow(10, random.uniform(-140, 140));
}

void move_far_off(TriangleMesh& mesh, Random& random) {
    mesh.vertices.rowwise() += Eigen::RowVector3d::Constant(std::pow(10, random.uniform(0, 20)));
}

void flatten(TriangleMesh& mesh, Random& random) {
    const Index axis = any(random, 3), first = any(random, mesh.n_vertices());
    mesh.vertices.col(axis).tail(mesh.n_vertices() - first) *= random.below(2) == 0 ? 0 : 1e-9;
}

void spoil_coordinates(TriangleMesh& mesh, Random& random) {
    for (int i = 0; i < 3; ++i)
        mesh.vertices(any(random, mesh.n_vertices()), any(random, 3)) =
            std::pow(10, random.uniform(-300, 300));
}

void collapse(TriangleMesh& mesh, Random& random) {
    for (int i = 0; i < 30; ++i) {
        const Index t = any(random, mesh.n_triangles());
        mesh.triangles(t, 0) = mesh.triangles(t, 1);
    }
}

constexpr std::array faults = {cut_hole,         flip_triangles, make_slivers,      double_vertices,
                               double_triangles, grow_fan,       isolate_vertices,  scale_wildly,
                               move_far_off,     flatten,        spoil_coordinates, collapse};

void make_hostile(TriangleMesh& mesh, Random& random) {
    for (std::uint64_t i = random.below(7); i > 0; --i) faults[random.below(faults.size())](mesh, random);
    // A scale upon a wild coordinate may leave the range of numbers: that is no mesh.
    mesh.vertices = mesh.vertices.array().isFinite().select(mesh.vertices, 0.0).eval();
}

}  // namespace

HostilePair make_hostile_pair(std::uint64_t seed, HostileSize size) {
    Random random(seed);
    HostilePair pair;
    pair.source = base_mesh(random, size);
    if (random.below(5) == 0) {
        pair.target = base_mesh(random, size);
    } else {
        DeformOptions deformation;
        deformation.bend = random.uniform(0, 1);
        pair.target = shuffle(deform(pair.source, deformation), random.next()).mesh;
    }
    make_hostile(pair.source, random);
    make_hostile(pair.target, random);
    return pair;
}

}  // namespace counterpart::fuzz
