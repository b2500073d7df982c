// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/isomorphism/spatial_order.hpp"

#include "match/isomorphism/dart_map.hpp"
#include "numerics/morton_order.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace counterpart::isomorphism {
namespace {

constexpr unsigned bits = 10;  // of each coordinate, and of each digit of the radix sort

struct Keyed {
    std::uint32_t key;
    Index vertex;
};

std::vector<Keyed> morton_keys(PointsView points) {
    const Eigen::RowVector3d low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
    // One scale for all axes: cells are cubes.
    const double extent = std::max((high - low).maxCoeff(), 1e-300), cells = (1U << bits) - 1;
    std::vector<Keyed> keys(to_size(points.rows()));
    for (Index v = 0; v < static_cast<Index>(points.rows()); ++v) {
        const auto cell = [&](int d) {
            return static_cast<std::uint64_t>((points(v, d) - low[d]) / extent * cells);
        };
        keys[to_size(v)] = {static_cast<std::uint32_t>(numerics::morton_code(cell(0), cell(1), cell(2))), v};
    }
    return keys;
}

// Stable, least significant digit first.
void radix_sort(std::vector<Keyed>& keys) {
    std::vector<Keyed> sorted(keys.size());
    for (unsigned digit = 0; digit < 3; ++digit) {
        const auto bucket = [&](Keyed k) { return (k.key >> (digit * bits)) & ((1U << bits) - 1); };
        std::array<std::uint32_t, (1U << bits) + 1> begin{};
        for (const Keyed k : keys) ++begin[bucket(k) + 1];
        for (std::size_t b = 0; b + 1 < begin.size(); ++b) begin[b + 1] += begin[b];
        for (const Keyed k : keys) sorted[begin[bucket(k)]++] = k;
        keys.swap(sorted);
    }
}

}  // namespace

SpatialOrder make_spatial_order(MeshView mesh) {
    SpatialOrder order;
    const auto n_vertices = to_size(mesh.n_vertices()), n = to_size(mesh.n_triangles());
    std::vector<Keyed> keys = morton_keys(mesh.vertices);
    radix_sort(keys);
    order.input_vertex.resize(n_vertices);
    std::vector<Index> rank(n_vertices);
    for (std::size_t k = 0; k < n_vertices; ++k) {
        order.input_vertex[k] = keys[k].vertex;
        rank[to_size(keys[k].vertex)] = static_cast<Index>(k);
    }

    // Blocks of a few thousand triangles fit the first caches; their order within is of no account.
    const auto block = [&](const Index* v) { return to_size(rank[to_size(v[0])]) >> 10U; };
    std::vector<std::uint32_t> begin((n_vertices >> 10U) + 2, 0);
    const Index* const triangles = mesh.triangles.data();
    for (std::size_t t = 0; t < n; ++t) ++begin[block(triangles + 3 * t) + 1];
    for (std::size_t b = 0; b + 1 < begin.size(); ++b) begin[b + 1] += begin[b];
    order.corner.resize(3 * n);
    order.input_triangle.resize(n);
    for (std::size_t t = 0; t < n; ++t) {
        const Index* const v = triangles + 3 * t;
        const std::size_t place = begin[block(v)]++;
        order.input_triangle[place] = static_cast<Index>(t);
        for (std::size_t c = 0; c < 3; ++c) order.corner[3 * place + c] = rank[to_size(v[c])];
    }
    return order;
}

}  // namespace counterpart::isomorphism
