// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Several components of one connectivity: which is which is a matter of position.
#include "match/frontiers/component_match.hpp"
#include "match/frontiers/side.hpp"
#include "numerics/moments.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/align/transform.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace counterpart::frontiers {
namespace {

constexpr int n_anchors = 50;                 // matched vertices that carry a component
constexpr std::size_t max_assignment = 2000;  // components: beyond that the cost matrix is too large

// Where a component is and how it is spread.
struct Moments {
    Eigen::Vector3d mean;
    Eigen::Matrix3d spread;  // covariance over its square root of trace, in units of length
    explicit Moments(PointsView points) : mean(points.colwise().mean().transpose()) {
        const Points centered = points.rowwise() - mean.transpose();
        spread = numerics::cross_moments(centered, centered) / static_cast<double>(points.rows());
        const double size = std::sqrt(spread.trace());
        if (size > 0) spread /= size;
    }
};

// How the neighborhood of a component moves, told by the matched vertices nearest to it.
class Surroundings {
  public:
    Surroundings(MeshView source, MeshView target, const std::vector<Index>& matched)
        : source_(source), target_(target), matched_(matched) {
        for (std::size_t v = 0; v < matched.size(); ++v)
            if (matched[v] >= 0) anchors_.push_back(static_cast<Index>(v));
        if (!anchors_.empty()) nearest_.emplace(rows_of(source.vertices, anchors_));
    }

    bool known() const { return anchors_.size() >= 3; }

    Similarity at_point(const Eigen::RowVector3d& point) const {
        KabschOptions options;
        options.with_scale = true;
        if (!known()) return whole();
        MatchedPairs pairs;
        for (const auto& neighbor : nearest_->closest(point, n_anchors))
            pairs.add(anchors_[to_size(neighbor.index)],
                      matched_[to_size(anchors_[to_size(neighbor.index)])]);
        return kabsch(rows_of(source_.vertices, pairs.source), rows_of(target_.vertices, pairs.target), {},
                      options);
    }

  private:
    // Nothing is matched yet: centers of mass and sizes.
    Similarity whole() const {
        Similarity motion;
        const Eigen::RowVector3d a = source_.vertices.colwise().mean(), b = target_.vertices.colwise().mean();
        const double size_a = (source_.vertices.rowwise() - a).norm(),
                     size_b = (target_.vertices.rowwise() - b).norm();
        if (size_a > 0 && size_b > 0) motion.scale = size_b / size_a;
        motion.translation = (b - motion.scale * a).transpose();
        return motion;
    }

    MeshView source_, target_;
    const std::vector<Index>& matched_;
    std::vector<Index> anchors_;
    std::optional<numerics::NearestNeighbors> nearest_;
};

// For groups too large for an assignment: each takes the nearest center that is still free among its sixteen
// nearest, the rest whatever is left.
std::vector<Index> pair_greedily(const std::vector<Moments>& ours, const std::vector<Moments>& theirs) {
    Points centers(static_cast<Eigen::Index>(theirs.size()), 3);
    for (std::size_t j = 0; j < theirs.size(); ++j)
        centers.row(static_cast<Eigen::Index>(j)) = theirs[j].mean.transpose();
    const numerics::NearestNeighbors nearest(std::move(centers));
    std::vector<Index> chosen(ours.size(), -1);
    std::vector<char> taken(theirs.size(), 0);
    for (std::size_t i = 0; i < ours.size(); ++i) {
        for (const auto& neighbor : nearest.closest(ours[i].mean.transpose(), 16)) {
            if (taken[to_size(neighbor.index)] != 0) continue;
            chosen[i] = neighbor.index;
            taken[to_size(neighbor.index)] = 1;
            break;
        }
    }
    std::size_t free = 0;
    for (Index& choice : chosen) {
        if (choice >= 0) continue;
        while (taken[free] != 0) ++free;
        choice = static_cast<Index>(free++);
    }
    return chosen;
}

std::vector<Index> pair_by_moments(const std::vector<Moments>& ours, const std::vector<Moments>& theirs,
                                   std::pair<Index, Index> given, const Progress& progress) {
    if (ours.size() > max_assignment) return pair_greedily(ours, theirs);
    Matrix cost(static_cast<Eigen::Index>(ours.size()), static_cast<Eigen::Index>(theirs.size()));
    for (std::size_t i = 0; i < ours.size(); ++i)
        for (std::size_t j = 0; j < theirs.size(); ++j)
            cost(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                (ours[i].mean - theirs[j].mean).squaredNorm() +
                (ours[i].spread - theirs[j].spread).squaredNorm();
    if (given.first >= 0 && given.second >= 0) {
        const double forbidden = 1 + 2 * static_cast<double>(ours.size()) * cost.maxCoeff();
        cost.row(given.first).setConstant(forbidden);
        cost.col(given.second).setConstant(forbidden);
        cost(given.first, given.second) = 0;
    }
    return pair_up(cost, Pairing::optimal, progress);
}

}  // namespace

std::vector<PlacedPair> place_components(MeshView source, MeshView target,
                                         const std::vector<ComponentMesh>& source_parts,
                                         const std::vector<ComponentMesh>& target_parts,
                                         const ComponentGroup& group, const std::vector<Index>& matched,
                                         std::pair<Index, Index> given, const Progress& progress) {
    const Surroundings surroundings(source, target, matched);
    std::vector<Moments> ours, theirs;
    std::vector<PlacedPair> pairs;
    for (const std::size_t part : group.source) {
        report_progress(progress, 0);
        PointsView points = source_parts[part].mesh.vertices;
        const Similarity motion = surroundings.at_point(points.colwise().mean());
        ours.emplace_back(motion(points));
        pairs.push_back({pairs.size(), 0, std::nullopt});
        if (surroundings.known()) pairs.back().rotation = motion.rotation;
    }
    for (const std::size_t part : group.target) theirs.emplace_back(target_parts[part].mesh.vertices);
    const std::vector<Index> chosen = pair_by_moments(ours, theirs, given, progress);
    for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i].target = to_size(chosen[i]);
    return pairs;
}

}  // namespace counterpart::frontiers
