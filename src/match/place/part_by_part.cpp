// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/place/part_by_part.hpp"

#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "match/place/surface.hpp"

#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>

namespace counterpart::place {
namespace {

using numerics::ClosestPoint;
using numerics::ClosestTriangle;

Components components_of(MeshView mesh) { return connected_components(Adjacency(mesh)); }

ClosestPoint facing(const ClosestTriangle& surface, MeshView source, const Points& normals, Index v,
                    double radius = std::numeric_limits<double>::infinity()) {
    return surface.closest(source.vertices.row(v).transpose(), normals.row(v).transpose(), same_way, radius);
}

// The component of the target where most of each component of the source lies; -1 for none.
std::vector<Index> homes(MeshView source, MeshView target, const Components& from, const Components& to,
                         const ClosestTriangle& surface, const Points& normals, double reach) {
    std::vector<Index> found(to_size(source.n_vertices()), -1);
    parallel_for(found.size(), 64, [&](std::size_t v) {
        const ClosestPoint point = facing(surface, source, normals, static_cast<Index>(v), reach);
        if (point.triangle >= 0) found[v] = to.of_vertex[to_size(target.triangles(point.triangle, 0))];
    });
    std::vector<std::map<Index, Index>> votes(to_size(from.count));
    std::vector<Index> n_vertices(votes.size(), 0), home(votes.size(), -1);
    for (std::size_t v = 0; v < found.size(); ++v) {
        const std::size_t part = to_size(from.of_vertex[v]);
        ++n_vertices[part];
        if (found[v] >= 0) ++votes[part][found[v]];
    }
    for (std::size_t part = 0; part < votes.size(); ++part)
        for (const auto& [other, count] : votes[part])
            if (2 * count > n_vertices[part]) home[part] = other;
    return home;
}

// Trees over single components, of which most meshes have one.
class Parts {
  public:
    Parts(MeshView mesh, const Components& components, const std::vector<Index>& wanted) {
        triangles_.resize(to_size(components.count));
        for (Index t = 0; t < mesh.n_triangles(); ++t)
            triangles_[to_size(components.of_vertex[to_size(mesh.triangles(t, 0))])].push_back(t);
        trees_.resize(triangles_.size());
        std::vector<Index> number(to_size(mesh.n_vertices()));  // in its part
        for (const Index part : wanted) {
            if (part < 0 || trees_[to_size(part)] != nullptr) continue;
            const Triangles triangles = mesh.triangles(triangles_[to_size(part)], Eigen::all);
            std::vector<Index> vertices(triangles.data(), triangles.data() + triangles.size());
            std::sort(vertices.begin(), vertices.end());
            vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
            for (std::size_t i = 0; i < vertices.size(); ++i)
                number[to_size(vertices[i])] = static_cast<Index>(i);
            trees_[to_size(part)] = std::make_unique<ClosestTriangle>(
                mesh.vertices(vertices, Eigen::all),
                triangles.unaryExpr([&](Index v) { return number[to_size(v)]; }));
        }
    }
    ClosestPoint closest(Index part, MeshView source, const Points& normals, Index v) const {
        ClosestPoint point = facing(*trees_[to_size(part)], source, normals, v);
        if (point.triangle >= 0) point.triangle = triangles_[to_size(part)][to_size(point.triangle)];
        return point;
    }

  private:
    std::vector<std::vector<Index>> triangles_;  // of each component
    std::vector<std::unique_ptr<ClosestTriangle>> trees_;
};

}  // namespace

Closest closest_part_by_part(MeshView source, MeshView target, double reach) {
    const ClosestTriangle whole(target.vertices, target.triangles);
    const Points normals = vertex_normals(source);
    const Components from = components_of(source), to = components_of(target);
    const std::vector<Index> home = homes(source, target, from, to, whole, normals, reach);
    const bool has_parts = to.count > 1;
    const Parts parts(target, to, has_parts ? home : std::vector<Index>{});
    Closest result{std::vector<Index>(to_size(source.n_vertices())),
                   std::vector<double>(to_size(source.n_vertices()))};
    parallel_for(result.vertex.size(), 64, [&](std::size_t i) {
        const auto v = static_cast<Index>(i);
        const Index part = home[to_size(from.of_vertex[i])];
        ClosestPoint point = has_parts && part >= 0 ? parts.closest(part, source, normals, v)
                                                    : facing(whole, source, normals, v);
        double squared_distance = point.squared_distance;
        if (point.triangle < 0) {
            point = whole.closest(source.vertices.row(v).transpose());
            squared_distance = std::numeric_limits<double>::infinity();
        }
        Index corner = 0;
        point.weights.maxCoeff(&corner);
        result.vertex[i] = target.triangles(point.triangle, corner);
        result.squared_distance[i] = squared_distance;
    });
    return result;
}

}  // namespace counterpart::place
