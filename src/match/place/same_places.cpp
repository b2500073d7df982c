// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/place/same_places.hpp"

#include "base/to_size.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <tuple>
#include <vector>

namespace counterpart::place {
namespace {

using Edge = std::array<Index, 2>;  // from, to, as its triangle runs

// Of coordinates written with five digits and more; never as much as a twentieth of an edge.
double rounding(MeshView mesh) {
    constexpr double digits = 2e-5, of_edge = 0.05;
    const double extent =
        (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).maxCoeff();
    return std::min(digits * extent, of_edge * mean_edge_length(mesh));
}

std::vector<char> in_triangles(MeshView mesh) {
    std::vector<char> result(to_size(mesh.n_vertices()), 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) result[to_size(mesh.triangles(t, c))] = 1;
    return result;
}

// The target's vertices at the place of each source vertex, increasing; no list where one that is in a
// triangle, here or there, is alone.
using Candidates = std::vector<std::vector<Index>>;
std::optional<Candidates> candidates(MeshView source, MeshView target) {
    const double near = std::min(rounding(source), rounding(target));
    const Eigen::RowVector3d low =
                                 source.vertices.colwise().minCoeff() - target.vertices.colwise().minCoeff(),
                             high =
                                 source.vertices.colwise().maxCoeff() - target.vertices.colwise().maxCoeff();
    const std::vector<char> used_here = in_triangles(source), used_there = in_triangles(target);
    const bool all_used = std::count(used_here.begin(), used_here.end(), 0) == 0 &&
                          std::count(used_there.begin(), used_there.end(), 0) == 0;
    if (all_used && std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()) > near)
        return std::nullopt;
    const numerics::NearestNeighbors neighbors(target.vertices);
    std::vector<char> is_met(used_there.size(), 0);
    Candidates found(used_here.size());
    for (Index v = 0; v < source.n_vertices(); ++v) {
        for (const auto& other : neighbors.within(source.vertices.row(v), near))
            found[to_size(v)].push_back(other.index);
        if (found[to_size(v)].empty() && used_here[to_size(v)] != 0) return std::nullopt;
        std::sort(found[to_size(v)].begin(), found[to_size(v)].end());
        for (const Index w : found[to_size(v)]) is_met[to_size(w)] = 1;
    }
    for (std::size_t w = 0; w < is_met.size(); ++w)
        if (used_there[w] != 0 && is_met[w] == 0) return std::nullopt;
    return found;
}

std::vector<Edge> sorted_edges(MeshView mesh, const std::vector<Index>& name) {
    std::vector<Edge> edges;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            edges.push_back(
                {name[to_size(mesh.triangles(t, c))], name[to_size(mesh.triangles(t, (c + 1) % 3))]});
    std::sort(edges.begin(), edges.end());
    return edges;
}

// Places that the edges at each vertex lead to, and come from.
class Surroundings {
  public:
    Surroundings(MeshView mesh, const std::vector<Index>& place) : around_(to_size(mesh.n_vertices())) {
        for (Index t = 0; t < mesh.n_triangles(); ++t)
            for (int c = 0; c < 3; ++c) {
                const Index v = mesh.triangles(t, c), w = mesh.triangles(t, (c + 1) % 3);
                around_[to_size(v)].push_back(2 * std::int64_t{place[to_size(w)]});
                around_[to_size(w)].push_back(2 * std::int64_t{place[to_size(v)]} + 1);
            }
        for (auto& all : around_) std::sort(all.begin(), all.end());
    }
    std::size_t in_common(Index v, const Surroundings& other, Index w) const {
        std::vector<std::int64_t> common;
        const auto &ours = around_[to_size(v)], &theirs = other.around_[to_size(w)];
        std::set_intersection(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                              std::back_inserter(common));
        return common.size();
    }

  private:
    std::vector<std::vector<std::int64_t>> around_;
};

// Of several vertices at one place: those that have most in common first, one to one while that is possible.
std::vector<Index> choose(MeshView source, MeshView target, const Candidates& candidates) {
    std::vector<Index> image(candidates.size(), VertexMap::unmatched),
        place_there(to_size(target.n_vertices()), -1);
    std::vector<Index> place_here(candidates.size(), -1);
    bool is_clear = true;
    for (std::size_t v = 0; v < candidates.size(); ++v) {
        if (candidates[v].empty()) continue;
        is_clear = is_clear && candidates[v].size() == 1 && place_there[to_size(candidates[v][0])] < 0;
        image[v] = place_here[v] = candidates[v][0];
        for (const Index w : candidates[v]) place_there[to_size(w)] = candidates[v][0];
    }
    if (is_clear) return image;
    const Surroundings here(source, place_here), there(target, place_there);
    std::vector<std::tuple<std::size_t, Index, Index>> ways;  // how many are not in common
    for (std::size_t v = 0; v < candidates.size(); ++v)
        for (const Index w : candidates[v])
            ways.emplace_back(~here.in_common(static_cast<Index>(v), there, w), static_cast<Index>(v), w);
    std::sort(ways.begin(), ways.end());
    std::vector<char> taken(place_there.size(), 0);
    std::fill(image.begin(), image.end(), VertexMap::unmatched);
    for (const bool one_to_one : {true, false})
        for (const auto& [unlike, v, w] : ways) {
            if (image[to_size(v)] >= 0 || (one_to_one && taken[to_size(w)] != 0)) continue;
            image[to_size(v)] = w;
            taken[to_size(w)] = 1;
        }
    return image;
}

Index count_same_faces(MeshView source, MeshView target, const std::vector<Index>& image) {
    const auto sorted = [](std::array<Index, 3> face) {
        std::sort(face.begin(), face.end());
        return face;
    };
    std::vector<std::array<Index, 3>> ours, theirs, common;
    for (Index t = 0; t < source.n_triangles(); ++t)
        ours.push_back(sorted({image[to_size(source.triangles(t, 0))], image[to_size(source.triangles(t, 1))],
                               image[to_size(source.triangles(t, 2))]}));
    for (Index u = 0; u < target.n_triangles(); ++u)
        theirs.push_back(sorted({target.triangles(u, 0), target.triangles(u, 1), target.triangles(u, 2)}));
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    std::set_intersection(ours.begin(), ours.end(), theirs.begin(), theirs.end(), std::back_inserter(common));
    return static_cast<Index>(common.size());
}

// Whether the surfaces face opposite ways where they have a vertex in common.
bool is_reversed(MeshView source, MeshView target, const std::vector<Index>& image) {
    const Points ours = vertex_normals(source), theirs = vertex_normals(target);
    double sum = 0;
    for (Index v = 0; v < source.n_vertices(); ++v)
        if (image[to_size(v)] >= 0) sum += ours.row(v).dot(theirs.row(image[to_size(v)]));
    return sum < 0;
}

// The share of the edges of either mesh that are edges of the other, the smaller one.
double share_of_edges(MeshView source, MeshView target, const std::vector<Index>& image) {
    std::vector<Index> itself(to_size(target.n_vertices()));
    std::iota(itself.begin(), itself.end(), 0);
    const auto undirected = [](std::vector<Edge> edges) {
        for (Edge& edge : edges)
            if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        return edges;
    };
    const std::vector<Edge> ours = undirected(sorted_edges(source, image)),
                            theirs = undirected(sorted_edges(target, itself));
    std::vector<Edge> common;
    std::set_intersection(ours.begin(), ours.end(), theirs.begin(), theirs.end(), std::back_inserter(common));
    return static_cast<double>(common.size()) /
           static_cast<double>(std::max({ours.size(), theirs.size(), std::size_t{1}}));
}

}  // namespace

std::optional<SamePlaces> find_same_places(MeshView source, MeshView target) {
    if (source.n_triangles() == 0 || target.n_triangles() == 0) return std::nullopt;
    const auto found = candidates(source, target);
    if (!found) return std::nullopt;
    std::vector<Index> image = choose(source, target, *found);
    constexpr double least_share = 0.4;
    if (share_of_edges(source, target, image) < least_share) return std::nullopt;
    const Index n_same = count_same_faces(source, target, image);
    const bool reversed = is_reversed(source, target, image);
    return SamePlaces{VertexMap(std::move(image), target.n_vertices()), n_same, reversed};
}

namespace {

// The vertices of each polygon, or of each triangle of a mesh without polygons, renamed and increasing;
// sorted.
std::vector<std::vector<Index>> sorted_polygons(MeshView mesh, const std::vector<Index>& name) {
    std::vector<std::vector<Index>> all;
    Index first = 0;
    const Index count = mesh.polygons != nullptr ? mesh.polygons->count() : mesh.n_triangles();
    for (Index p = 0; p < count; ++p) {
        const Index n_triangles = mesh.polygons != nullptr ? mesh.polygons->size(p) - 2 : 1;
        std::vector<Index> polygon;
        for (Index t = first; t < first + n_triangles; ++t)
            for (int c = 0; c < 3; ++c) polygon.push_back(name[to_size(mesh.triangles(t, c))]);
        first += n_triangles;
        std::sort(polygon.begin(), polygon.end());
        polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
        all.push_back(std::move(polygon));
    }
    return all;
}

// Whether each of the triangles has all its corners in one of the polygons.
bool lie_inside(const std::vector<std::vector<Index>>& triangles,
                const std::vector<std::vector<Index>>& polygons, Index n_vertices) {
    std::vector<std::vector<std::size_t>> polygons_at(to_size(n_vertices));
    for (std::size_t p = 0; p < polygons.size(); ++p)
        for (const Index v : polygons[p])
            if (v >= 0) polygons_at[to_size(v)].push_back(p);
    return std::all_of(triangles.begin(), triangles.end(), [&](const std::vector<Index>& triangle) {
        if (triangle.empty() || triangle[0] < 0) return false;
        const auto& around = polygons_at[to_size(triangle[0])];
        return std::any_of(around.begin(), around.end(), [&](std::size_t p) {
            return std::includes(polygons[p].begin(), polygons[p].end(), triangle.begin(), triangle.end());
        });
    });
}

}  // namespace

bool keeps_polygons(MeshView source, MeshView target, const VertexMap& target_from_source) {
    std::vector<Index> itself(to_size(target.n_vertices()));
    std::iota(itself.begin(), itself.end(), 0);
    std::vector<std::vector<Index>> ours = sorted_polygons(source, target_from_source.image()),
                                    theirs = sorted_polygons(target, itself);
    if (source.polygons == nullptr) return lie_inside(ours, theirs, target.n_vertices());
    if (target.polygons == nullptr) return lie_inside(theirs, ours, target.n_vertices());
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    return ours == theirs;
}

Triangles corners_by_vertices(MeshView source, MeshView target, const VertexMap& target_from_source) {
    std::vector<std::vector<Index>> corners_at(to_size(target.n_vertices()));
    for (Index u = 0; u < target.n_triangles(); ++u)
        for (Index c = 0; c < 3; ++c) corners_at[to_size(target.triangles(u, c))].push_back(3 * u + c);
    Triangles result = Triangles::Constant(source.n_triangles(), 3, -1);
    for (Index t = 0; t < source.n_triangles(); ++t) {
        std::array<Index, 3> images{};
        for (int c = 0; c < 3; ++c) images[to_size(c)] = target_from_source[source.triangles(t, c)];
        const auto n_met = [&](Index corner) {
            int count = 0;
            for (int c = 0; c < 3; ++c)
                for (const Index image : images) count += target.triangles(corner / 3, c) == image ? 1 : 0;
            return count;
        };
        for (int c = 0; c < 3; ++c) {
            if (images[to_size(c)] < 0) continue;
            const std::vector<Index>& around = corners_at[to_size(images[to_size(c)])];
            if (around.empty()) continue;
            result(t, c) = *std::max_element(around.begin(), around.end(),
                                             [&](Index x, Index y) { return n_met(x) < n_met(y); });
        }
    }
    return result;
}

}  // namespace counterpart::place
