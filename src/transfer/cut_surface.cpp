// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "transfer/cut_surface.hpp"

#include "mesh/edge_table.hpp"

#include <algorithm>
#include <unordered_set>

namespace counterpart::attributes {
namespace {

// Decides whether an attribute goes on from one triangle to the next.
struct Continuity {
    MeshView mesh;
    const CornerAttribute& attribute;
    const std::vector<Index>& labels;
    double tolerance;

    bool same_rows(Index a, Index b) const {
        if (a == b) return true;
        if (a < 0 || b < 0) return false;
        return (attribute.values.row(a) - attribute.values.row(b)).cwiseAbs().maxCoeff() <= tolerance;
    }
    Index row_at(Index triangle, Index vertex) const {
        for (int c = 0; c < 3; ++c)
            if (mesh.triangles(triangle, c) == vertex) return attribute.corners(triangle, c);
        return -1;
    }
    bool operator()(Index t, Index u, Index low, Index high) const {
        if (!labels.empty() && labels[static_cast<std::size_t>(t)] != labels[static_cast<std::size_t>(u)])
            return false;
        return same_rows(row_at(t, low), row_at(u, low)) && same_rows(row_at(t, high), row_at(u, high));
    }
};

double range_of(const Matrix& values) {
    if (values.rows() == 0) return 0;
    return (values.colwise().maxCoeff() - values.colwise().minCoeff()).maxCoeff();
}

}  // namespace

bool intersect(std::span<const Index> a, std::span<const Index> b) {
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
        if (a[i] == b[j]) return true;
        a[i] < b[j] ? ++i : ++j;
    }
    return false;
}

CutSurface::CutSurface(MeshView mesh, const CornerAttribute& attribute, const std::vector<Index>& labels)
    : mesh_(mesh),
      fans_(mesh.triangles, mesh.n_vertices()),
      across_(3 * static_cast<std::size_t>(mesh.n_triangles()), -1),
      smooth_(across_.size(), 0) {
    const Continuity continuous{mesh, attribute, labels, 1e-6 * range_of(attribute.values)};
    const mesh::EdgeTable edges(mesh);
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto sides = edges.half_edges(e);
        for (std::size_t i = 0; i < sides.size() && sides.size() > 1; ++i) {
            const mesh::EdgeTable::HalfEdge &here = sides[i], &next = sides[(i + 1) % sides.size()];
            const auto place =
                3 * static_cast<std::size_t>(here.triangle) + static_cast<std::size_t>(here.corner);
            across_[place] = next.triangle;
            smooth_[place] = continuous(here.triangle, next.triangle, edges.low(e), edges.high(e));
        }
    }
}

std::vector<Index> CutSurface::around(const SurfacePoint& point) const {
    std::vector<Index> vertices;
    for (int c = 0; c < 3; ++c)
        if (point.weights[c] > 0) vertices.push_back(mesh_.triangles(point.triangle, c));
    if (vertices.size() == 3) return {point.triangle};
    const auto fan = fans_.around(vertices[0]);
    std::vector<Index> found;
    std::copy_if(fan.begin(), fan.end(), std::back_inserter(found), [&](Index t) {
        return vertices.size() == 1 || (mesh_.triangles.row(t).array() == vertices[1]).any();
    });
    // A triangle that names a vertex twice is listed twice.
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

SurfacePoint CutSurface::seen_from(Index triangle, const SurfacePoint& point) const {
    if (triangle == point.triangle) return point;
    SurfacePoint same{triangle, Eigen::Vector3d::Zero()};
    for (int c = 0; c < 3; ++c) {
        if (!(point.weights[c] > 0)) continue;
        for (int d = 0; d < 3; ++d) {
            if (mesh_.triangles(triangle, d) != mesh_.triangles(point.triangle, c)) continue;
            same.weights[d] += point.weights[c];
            break;
        }
    }
    return same;
}

Eigen::Vector3d CutSurface::position(const SurfacePoint& point) const {
    return mesh_.vertices(mesh_.triangles.row(point.triangle).transpose(), Eigen::all).transpose() *
           point.weights;
}

std::vector<Index> CutSurface::reach(std::span<const Index> start, const Eigen::Vector3d& center,
                                     double radius, Seams seams) const {
    std::vector<Index> found(start.begin(), start.end());
    std::unordered_set<Index> seen(start.begin(), start.end());
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (std::size_t side = 0; side < 3; ++side) {
            const std::size_t place = 3 * static_cast<std::size_t>(found[i]) + side;
            const Index next = across_[place];
            if (next < 0 || (seams == Seams::block && !smooth_[place]) || !seen.insert(next).second) continue;
            if (closest_among({&next, 1}, center).squared_distance <= radius * radius) found.push_back(next);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

numerics::ClosestPoint CutSurface::closest_among(std::span<const Index> triangles,
                                                 const Eigen::Vector3d& query) const {
    return numerics::closest_among(triangles, mesh_.vertices, mesh_.triangles, query);
}

}  // namespace counterpart::attributes
