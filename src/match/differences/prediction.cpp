// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/prediction.hpp"

#include "match/differences/tuning.hpp"
#include "match/isomorphism/dart_map.hpp"
#include "match/symmetry/alignment.hpp"

namespace counterpart::differences {

using isomorphism::to_size;

Prediction::Prediction(MeshView source, MeshView target, bool reversed)
    : source_(source),
      target_(target),
      reversed_(reversed),
      adjacency_(source),
      seen_(to_size(source.n_vertices()), 0) {}

// Ring by ring, whole rings, until there are enough.
std::vector<Index> Prediction::anchors(Index v, const std::vector<Index>& map) {
    std::vector<Index> found;
    queue_.assign(1, v);
    seen_[to_size(v)] = ++search_;
    std::size_t begin = 0;
    for (int ring = 0; ring < tuning.rings && found.size() < tuning.enough_anchors; ++ring) {
        const std::size_t end = queue_.size();
        for (; begin < end; ++begin) {
            for (const Index w : adjacency_.neighbors(queue_[begin])) {
                if (seen_[to_size(w)] == search_) continue;
                seen_[to_size(w)] = search_;
                queue_.push_back(w);
                if (map[w] >= 0) found.push_back(w);
            }
        }
    }
    return found;
}

std::optional<Prediction::Expected> Prediction::expected(Index v, const std::vector<Index>& map) {
    const std::vector<Index> around = anchors(v, map);
    if (around.size() < tuning.min_anchors) return std::nullopt;
    std::vector<symmetry::PointPair> pairs;
    for (const Index w : around) pairs.push_back({source_.vertices.row(w), target_.vertices.row(map[w])});
    const Eigen::RowVector3d at = source_.vertices.row(v);
    const auto motion = symmetry::fit_alignment_near(at, std::move(pairs), reversed_);
    double length = 0;
    const auto neighbors = adjacency_.neighbors(v);
    for (const Index w : neighbors) length += (source_.vertices.row(w) - at).norm();
    return Expected{motion(at), motion.similarity.scale * length / static_cast<double>(neighbors.size())};
}

std::optional<double> Prediction::offset(Index v, Index image, const std::vector<Index>& map) {
    const auto here = expected(v, map);
    if (!here || !(here->edge_length > 0)) return std::nullopt;
    return (target_.vertices.row(image) - here->position).norm() / here->edge_length;
}

}  // namespace counterpart::differences
