// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "spectral/intrinsic_triangulation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace counterpart::spectral {
namespace {

// Heron's formula in Kahan's order, which keeps needles accurate.
double triangle_area(double a, double b, double c) {
    if (a < b) std::swap(a, b);
    if (b < c) std::swap(b, c);
    if (a < b) std::swap(a, b);
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return 0.25 * std::sqrt(std::max(product, 0.0));
}

}  // namespace

IntrinsicTriangulation::IntrinsicTriangulation(MeshView mesh) {
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
        if (a == b || b == c || c == a) continue;
        for (int i = 0; i < 3; ++i) {
            const Index from = mesh.triangles(t, i), to = mesh.triangles(t, (i + 1) % 3);
            vertices_.push_back(from);
            lengths_.push_back((mesh.vertices.row(from) - mesh.vertices.row(to)).norm());
        }
    }
    glue();
}

void IntrinsicTriangulation::glue() {
    const auto n = vertices_.size();
    twins_.assign(n, -1);
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), 0);
    const auto ends = [&](Index h) {
        return std::minmax(vertices_[to_size(h)], vertices_[to_size(next(h))]);
    };
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return std::tuple(ends(a), a) < std::tuple(ends(b), b); });
    for (std::size_t first = 0, last = 0; first < n; first = last) {
        while (last < n && ends(order[last]) == ends(order[first])) ++last;
        const Index h = order[first];
        if (last - first == 1) continue;
        const Index twin = order[first + 1];
        if (last - first == 2 && vertices_[to_size(h)] != vertices_[to_size(twin)]) {
            twins_[to_size(h)] = twin;
            twins_[to_size(twin)] = h;
        } else {
            ++n_cut_edges_;
        }
    }
}

void IntrinsicTriangulation::mollify(double margin) {
    if (lengths_.empty()) return;
    const double mean =
        std::accumulate(lengths_.begin(), lengths_.end(), 0.0) / static_cast<double>(lengths_.size());
    double missing = 0;
    for (Index h = 0; h < static_cast<Index>(lengths_.size()); ++h) {
        const double slack = length(next(h)) + length(next(next(h))) - length(h);
        missing = std::max(missing, margin * mean - slack);
    }
    for (double& length : lengths_) length += missing;
}

double IntrinsicTriangulation::area(Index triangle) const {
    return triangle_area(length(3 * triangle), length(3 * triangle + 1), length(3 * triangle + 2));
}

double IntrinsicTriangulation::opposite_cotangent(Index h) const {
    const double a = length(h), b = length(next(h)), c = length(next(next(h)));
    const double area = triangle_area(a, b, c);
    return area > 0 ? (b * b + c * c - a * a) / (4 * area) : 0;
}

bool IntrinsicTriangulation::is_delaunay(Index h) const {
    const Index twin = twins_[to_size(h)];
    // The tolerance keeps cocircular quadrilaterals from being flipped back and forth.
    return twin < 0 || opposite_cotangent(h) + opposite_cotangent(twin) >= -1e-9;
}

// Replaces edge a-b of triangles (a, b, c) and (b, a, d) by c-d, in place: (c, d, b) and (d, c, a). Returns
// the five half-edges, the new edge first.
std::array<Index, 5> IntrinsicTriangulation::flip(Index h) {
    const Index t = twins_[to_size(h)];
    const Index bc = next(h), ca = next(bc), ad = next(t), db = next(ad);
    const double ab = length(h);
    const auto unfold = [&](double from_a, double from_b) {
        const double x = (ab * ab + from_a * from_a - from_b * from_b) / (2 * ab);
        return std::pair(x, std::sqrt(std::max(from_a * from_a - x * x, 0.0)));
    };
    const auto [cx, cy] = unfold(length(ca), length(bc));
    const auto [dx, dy] = unfold(length(ad), length(db));
    const double cd = std::hypot(cx - dx, cy + dy);
    const Index c = origin(ca), d = origin(db), a = origin(h), b = origin(t);

    struct GluedEdge {
        double length;
        Index twin;
    };
    const auto side = [&](Index half_edge) {
        return GluedEdge{length(half_edge), twins_[to_size(half_edge)]};
    };
    const GluedEdge side_bc = side(bc), side_ca = side(ca), side_ad = side(ad), side_db = side(db);
    // Triangle of h becomes c -> d -> b, that of t becomes d -> c -> a.
    const Index h1 = next(h), h2 = next(h1), t1 = next(t), t2 = next(t1);
    const std::array<Index, 4> outer{h1, h2, t1, t2};
    const std::array<GluedEdge, 4> sides{side_db, side_bc, side_ca, side_ad};
    const std::array<Index, 4> was{db, bc, ca, ad};
    vertices_[to_size(h)] = c;
    vertices_[to_size(h1)] = d;
    vertices_[to_size(h2)] = b;
    vertices_[to_size(t)] = d;
    vertices_[to_size(t1)] = c;
    vertices_[to_size(t2)] = a;
    lengths_[to_size(h)] = lengths_[to_size(t)] = cd;
    for (std::size_t i = 0; i < 4; ++i) {
        lengths_[to_size(outer[i])] = sides[i].length;
        Index twin = sides[i].twin;
        // A side may be glued to another side of the same quadrilateral.
        for (std::size_t j = 0; j < 4 && twin >= 0; ++j) {
            if (sides[i].twin == was[j]) twin = outer[j];
        }
        twins_[to_size(outer[i])] = twin;
        if (twin >= 0) twins_[to_size(twin)] = outer[i];
    }
    return {h, h1, h2, t1, t2};
}

Index IntrinsicTriangulation::make_delaunay() {
    std::vector<Index> stack;
    std::vector<char> waiting(vertices_.size(), 0);
    const auto push = [&](Index h) {
        const Index twin = twins_[to_size(h)];
        if (twin < 0) return;
        const Index name = std::min(h, twin);
        if (waiting[to_size(name)]) return;
        waiting[to_size(name)] = 1;
        stack.push_back(name);
    };
    for (Index h = 0; h < static_cast<Index>(vertices_.size()); ++h) push(h);
    // The algorithm ends; the bound guards against rounding on degenerate input.
    const auto bound = static_cast<Index>(std::min<std::size_t>(vertices_.size() * 30, 2'000'000'000));
    Index n_flips = 0;
    while (!stack.empty() && n_flips < bound) {
        const Index h = stack.back();
        stack.pop_back();
        waiting[to_size(h)] = 0;
        if (is_delaunay(h)) continue;
        const std::array<Index, 5> around = flip(h);
        ++n_flips;
        for (std::size_t i = 1; i < around.size(); ++i) push(around[i]);
    }
    return n_flips;
}

}  // namespace counterpart::spectral
