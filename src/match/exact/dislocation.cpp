// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/dislocation.hpp"

#include "match/exact/similarity.hpp"
#include "mesh/disjoint_sets.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

namespace counterpart {
namespace {

constexpr int moved_rings = 3, anchor_rings = 3;
constexpr std::size_t most_vertices = 2000, fewest_anchors = 6;

using Triple = std::array<Index, 3>;
std::size_t place(Index i) { return static_cast<std::size_t>(i); }

Triple sorted(Triple t) {
    std::sort(t.begin(), t.end());
    return t;
}

struct Region {
    std::vector<Index> moved, anchors;
};

class Mender {
  public:
    Mender(const TriangleMesh& source, const TriangleMesh& target, VertexMap map, bool turned)
        : source_(source),
          target_(target),
          map_(std::move(map)),
          turned_(turned),
          adjacency_(source),
          around_(place(source.n_vertices())),
          ring_(place(source.n_vertices()), -1) {
        for (Index t = 0; t < source.n_triangles(); ++t)
            for (int c = 0; c < 3; ++c) around_[place(source.triangles(t, c))].push_back(t);
        for (Index t = 0; t < target.n_triangles(); ++t)
            faces_.push_back(
                sorted({target.triangles(t, 0), target.triangles(t, 1), target.triangles(t, 2)}));
        std::sort(faces_.begin(), faces_.end());
    }

    VertexMap run() {
        std::vector<bool> taken(place(target_.n_vertices()), false);
        for (const Index w : map_.image)
            if (w >= 0) taken[place(w)] = true;
        for (Index w = 0; w < target_.n_vertices(); ++w)
            if (!taken[place(w)]) spare_.push_back(w);
        for (const std::vector<Index>& part : lesser_parts())
            if (!spare_.empty()) mend(region_around(part));
        std::vector<bool> done(place(source_.n_vertices()), false);
        for (Index v = 0; v < source_.n_vertices() && !spare_.empty(); ++v) {
            if (map_[v] >= 0 || done[place(v)]) continue;
            const Region region = region_around({v});
            for (const Index w : region.moved)
                if (map_[w] < 0) done[place(w)] = true;
            mend(region);
        }
        return std::move(map_);
    }

  private:
    bool is_matched(Index t) const {
        const Triple to{map_[source_.triangles(t, 0)], map_[source_.triangles(t, 1)],
                        map_[source_.triangles(t, 2)]};
        return std::binary_search(faces_.begin(), faces_.end(), sorted(to));
    }

    // The vertices of each part of the matched triangles that no edge joins to the largest part.
    std::vector<std::vector<Index>> lesser_parts() const {
        std::vector<std::array<Index, 3>> edges;  // smaller end, larger end, triangle
        DisjointSets sets(source_.n_triangles());
        for (Index t = 0; t < source_.n_triangles(); ++t) {
            if (!is_matched(t)) continue;
            for (int c = 0; c < 3; ++c) {
                const auto [a, b] = std::minmax(source_.triangles(t, c), source_.triangles(t, (c + 1) % 3));
                edges.push_back({a, b, t});
            }
        }
        std::sort(edges.begin(), edges.end());
        for (std::size_t i = 1; i < edges.size(); ++i)
            if (edges[i][0] == edges[i - 1][0] && edges[i][1] == edges[i - 1][1])
                sets.join(edges[i][2], edges[i - 1][2]);
        std::map<Index, std::set<Index>> vertices;
        for (const auto& [a, b, t] : edges) vertices[sets.root(t)].insert({a, b});
        std::vector<std::vector<Index>> parts;
        for (const auto& [set, of_part] : vertices) parts.emplace_back(of_part.begin(), of_part.end());
        std::stable_sort(parts.begin(), parts.end(),
                         [](const auto& a, const auto& b) { return a.size() > b.size(); });
        if (!parts.empty()) parts.erase(parts.begin());
        std::erase_if(parts, [](const auto& part) { return part.size() > most_vertices; });
        return parts;
    }

    // `start`, the unmatched vertices around it that hang together over at most `moved_rings` rings, these
    // rings, and those behind.
    Region region_around(const std::vector<Index>& start) {
        Region region;
        std::vector<Index> queue = start;
        for (const Index v : start) ring_[place(v)] = 0;
        for (std::size_t i = 0; i < queue.size() && queue.size() < 50 * most_vertices; ++i) {
            const Index v = queue[i];
            for (const Index w : adjacency_.neighbors(v)) {
                const int ring = map_[w] < 0 && ring_[place(v)] < moved_rings ? 0 : ring_[place(v)] + 1;
                if (ring > moved_rings + anchor_rings || (ring_[place(w)] >= 0 && ring_[place(w)] <= ring))
                    continue;
                ring_[place(w)] = ring;
                queue.push_back(w);
            }
        }
        std::sort(queue.begin(), queue.end());
        queue.erase(std::unique(queue.begin(), queue.end()), queue.end());
        for (const Index v : queue) {
            if (ring_[place(v)] <= moved_rings)
                region.moved.push_back(v);
            else if (map_[v] >= 0)
                region.anchors.push_back(v);
            ring_[place(v)] = -1;
        }
        return region;
    }

    // Where the placed vertices near `v` expect it.
    Eigen::RowVector3d expected(Index v, const std::vector<Index>& placed) const {
        const Eigen::RowVector3d at = source_.vertices.row(v);
        std::vector<PointPair> pairs;
        double extent = 0;
        for (const Index a : placed) {
            pairs.push_back({source_.vertices.row(a), target_.vertices.row(map_[a])});
            extent = std::max(extent, (pairs.back().source - at).squaredNorm());
        }
        for (PointPair& pair : pairs) {
            const double falloff = (pair.source - at).squaredNorm() + 1e-3 * extent;
            pair.weight = 1 / (falloff * falloff);
        }
        return fit_similarity(pairs, turned_)(at);
    }

    // Pairs the vertices of one layer with the closest of the candidates where both ways agree; what was
    // paired moves from the candidates to the placed.
    void place_layer(const std::vector<Index>& layer, std::vector<Index>& candidates,
                     std::vector<Index>& placed) {
        if (candidates.empty()) return;
        Points moved(static_cast<Eigen::Index>(layer.size()), 3),
            there(static_cast<Eigen::Index>(candidates.size()), 3);
        for (std::size_t i = 0; i < layer.size(); ++i)
            moved.row(static_cast<Eigen::Index>(i)) = expected(layer[i], placed);
        for (std::size_t j = 0; j < candidates.size(); ++j)
            there.row(static_cast<Eigen::Index>(j)) = target_.vertices.row(candidates[j]);
        const NearestNeighbors in_target(there), in_layer(moved);
        for (std::size_t i = 0; i < layer.size(); ++i) {
            const Index j = in_target.closest(moved.row(static_cast<Eigen::Index>(i))).index;
            if (in_layer.closest(there.row(j)).index != static_cast<Index>(i)) continue;
            map_.image[place(layer[i])] = candidates[place(j)];
            placed.push_back(layer[i]);
        }
        std::set<Index> taken;
        for (const Index v : layer) taken.insert(map_[v]);
        std::erase_if(candidates, [&](Index w) { return taken.contains(w); });
    }

    std::size_t n_matched(const std::set<Index>& triangles) const {
        return static_cast<std::size_t>(
            std::count_if(triangles.begin(), triangles.end(), [&](Index t) { return is_matched(t); }));
    }

    void mend(const Region& region) {
        if (region.anchors.size() < fewest_anchors || region.moved.size() > most_vertices) return;
        std::vector<Index> candidates = spare_, before;
        std::set<Index> triangles, left(region.moved.begin(), region.moved.end());
        for (const Index v : region.moved) {
            triangles.insert(around_[place(v)].begin(), around_[place(v)].end());
            before.push_back(map_[v]);
            if (map_[v] >= 0) candidates.push_back(map_[v]);
        }
        const std::size_t now = n_matched(triangles);
        for (const Index v : region.moved) map_.image[place(v)] = VertexMap::unmatched;

        // Inwards layer by layer: each is expected by the ones before it.
        std::vector<Index> placed = region.anchors, layer, last = region.anchors;
        for (; !last.empty(); last = layer) {
            layer.clear();
            for (const Index v : last)
                for (const Index w : adjacency_.neighbors(v))
                    if (left.erase(w) > 0) layer.push_back(w);
            if (!layer.empty()) place_layer(layer, candidates, placed);
        }
        if (n_matched(triangles) > now) {
            spare_ = candidates;
        } else {
            for (std::size_t i = 0; i < region.moved.size(); ++i)
                map_.image[place(region.moved[i])] = before[i];
        }
    }

    const TriangleMesh& source_;
    const TriangleMesh& target_;
    VertexMap map_;
    bool turned_;
    Adjacency adjacency_;
    std::vector<std::vector<Index>> around_;
    std::vector<Triple> faces_;  // of the target, sorted
    std::vector<int> ring_;      // -1 outside the region at hand
    std::vector<Index> spare_;   // target vertices without partner
};

}  // namespace

VertexMap without_dislocations(const TriangleMesh& source, const TriangleMesh& target, VertexMap map,
                               bool turned) {
    if (count_matched(map) == 0) return map;
    return Mender(source, target, std::move(map), turned).run();
}

}  // namespace counterpart
