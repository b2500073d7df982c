// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/regrowth.hpp"

#include "match/differences/triangle_pairs.hpp"
#include "match/differences/tuning.hpp"

#include <algorithm>
#include <tuple>

namespace counterpart::differences {

using isomorphism::to_size;

namespace {

struct Proposal {
    double cost;  // edges
    Index source, target;
    int depth;
    bool operator<(const Proposal& b) const {
        return std::tie(cost, source, target) < std::tie(b.cost, b.source, b.target);
    }
};

// Vertex colors in the mesh's own numbering.
std::array<std::vector<Color>, 3> colors_of(const PairSide& side) {
    std::array<std::vector<Color>, 3> colors;
    for (std::size_t radius = 0; radius < 3; ++radius) {
        colors[radius].assign(to_size(side.mesh.n_vertices()), 0);
        for (std::size_t v = 0; v < side.map.input_vertex.size(); ++v)
            colors[radius][to_size(side.map.input_vertex[v])] = side.colors[radius][v];
    }
    return colors;
}

class Regrowth {
  public:
    Regrowth(const PairSide& source, const PairSide& target, std::vector<Index> map, Prediction& prediction)
        : source_(source.mesh),
          target_(target.mesh),
          map_(std::move(map)),
          prediction_(prediction),
          in_target_(target.mesh),
          around_(triangles_at_vertices(source.mesh)),
          faces_(sorted_faces(target.mesh)),
          source_colors_(colors_of(source)),
          target_colors_(colors_of(target)),
          depth_(map_.size(), 0),
          taken_(to_size(target.mesh.n_vertices()), false) {
        for (const Index w : map_)
            if (w >= 0) taken_[to_size(w)] = true;
    }

    std::vector<Index> run(const std::function<void()>& report) {
        for (const double limit : tuning.new_offsets) {
            std::vector<Index> layer;
            for (std::size_t v = 0; v < map_.size(); ++v)
                if (map_[v] < 0) layer.push_back(static_cast<Index>(v));
            for (; !layer.empty(); report()) layer = grow(layer, limit);
        }
        return std::move(map_);
    }

  private:
    // Matches what it can of the layer; returns the unmatched vertices around that.
    std::vector<Index> grow(const std::vector<Index>& layer, double limit) {
        std::vector<Proposal> proposals;
        for (const Index v : layer) propose(v, limit, proposals);
        std::sort(proposals.begin(), proposals.end());
        std::vector<Index> next, found;
        for (const Proposal& best : proposals) {
            if (map_[best.source] >= 0 || taken_[to_size(best.target)]) continue;
            map_[to_size(best.source)] = best.target;
            taken_[to_size(best.target)] = true;
            depth_[to_size(best.source)] = best.depth;
            found.push_back(best.source);
            for (const Index v : prediction_.source_neighbors().neighbors(best.source)) next.push_back(v);
        }
        settle(found);
        std::sort(next.begin(), next.end());
        next.erase(std::unique(next.begin(), next.end()), next.end());
        std::erase_if(next, [&](Index v) { return map_[v] >= 0; });
        return next;
    }

    // More is known of the new pairs and those around them than when they were proposed.
    void settle(std::vector<Index> vertices) {
        const std::size_t n = vertices.size();
        for (std::size_t i = 0; i < n; ++i)
            for (const Index v : prediction_.source_neighbors().neighbors(vertices[i]))
                if (map_[v] >= 0) vertices.push_back(v);
        for (const Index v : vertices)
            if (depth_[to_size(v)] > 0 && evidence(v, map_[v]) >= tuning.settled_evidence)
                depth_[to_size(v)] = 0;
    }

    // All that are near enough, so that who loses the closest to another gets the next.
    void propose(Index v, double limit, std::vector<Proposal>& proposals) const {
        const std::vector<Index> candidates = free_around_images(v);
        if (candidates.empty()) return;
        const auto expected = prediction_.expected(v, map_);
        if (!expected || !(expected->edge_length > 0)) return;
        int least_depth = tuning.max_depth;
        for (const Index u : prediction_.source_neighbors().neighbors(v))
            if (map_[u] >= 0) least_depth = std::min(least_depth, depth_[to_size(u)]);
        for (const Index w : candidates) {
            const double offset =
                (target_.vertices.row(w) - expected->position).norm() / expected->edge_length;
            if (offset > tuning.max_new_offset) continue;
            const double for_it = evidence(v, w), cost = offset - tuning.offset_per_evidence * for_it;
            const int depth = for_it >= tuning.anchor_evidence ? 0 : least_depth + 1;
            if (cost <= limit && depth <= tuning.max_depth) proposals.push_back({cost, v, w, depth});
        }
    }

    std::vector<Index> free_around_images(Index v) const {
        std::vector<Index> found;
        const auto add = [&](Index w) {
            if (!taken_[to_size(w)]) found.push_back(w);
        };
        for (const Index neighbor : prediction_.source_neighbors().neighbors(v)) {
            if (map_[neighbor] < 0) continue;
            for (const Index near : in_target_.neighbors(map_[neighbor])) {
                add(near);
                for (const Index w : in_target_.neighbors(near)) add(w);
            }
        }
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    // Triangles that the pair would match, and equal colors.
    double evidence(Index v, Index w) const {
        double sum = 0;
        for (std::size_t radius = 0; radius < 3; ++radius)
            if (source_colors_[radius][to_size(v)] == target_colors_[radius][to_size(w)])
                sum += tuning.color_evidence[radius];
        for (const Index t : around_[to_size(v)]) {
            std::array<Index, 3> face{};
            for (int c = 0; c < 3; ++c) {
                const Index u = source_.triangles(t, c);
                face[to_size(c)] = u == v ? w : map_[u];
            }
            std::sort(face.begin(), face.end());
            sum += std::binary_search(faces_.begin(), faces_.end(), face) ? 1 : 0;
        }
        return sum;
    }

    MeshView source_;
    MeshView target_;
    std::vector<Index> map_;
    Prediction& prediction_;
    Adjacency in_target_;
    std::vector<std::vector<Index>> around_;
    std::vector<std::array<Index, 3>> faces_;
    std::array<std::vector<Color>, 3> source_colors_, target_colors_;
    std::vector<int> depth_;  // edges to a vertex that is matched by more than place
    std::vector<bool> taken_;
};

}  // namespace

std::vector<Index> regrown(const PairSide& source, const PairSide& target, std::vector<Index> map,
                           Prediction& prediction, const std::function<void()>& report) {
    if (std::count_if(map.begin(), map.end(), [](Index image) { return image >= 0; }) ==
        std::min(source.map.n_vertices(), target.map.n_vertices()))
        return map;
    return Regrowth(source, target, std::move(map), prediction).run(report);
}

}  // namespace counterpart::differences
