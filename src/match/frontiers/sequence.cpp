// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The frontier method in sequence: level k is matched with the help of the levels nearer to the source. Loops
// (connected components of a frontier) are paired first, then the vertices of each pair of loops: those that
// connectivity tells apart at once, the rest by alignment. See docs/methods/frontiers.md.
#include "base/parallel.hpp"
#include "match/frontiers/loop.hpp"
#include "match/frontiers/side.hpp"
#include "numerics/rotation.hpp"

#include <counterpart/align/transform.hpp>

#include <algorithm>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

namespace counterpart::frontiers {
namespace {

constexpr Index n_start_levels = 12;  // on which the first rotation is chosen
constexpr int n_spins = 36;

class SequenceMatcher {
  public:
    SequenceMatcher(const FrontierSide& a, const FrontierSide& b, const FrontiersOptions& options)
        : a_(a), b_(b), options_(options), state_(a, b) {}

    SideMatch run(const Eigen::Matrix3d* prior) {
        const Index n_levels = a_.frontiers.count(), n_start = std::min(n_levels, n_start_levels + 1);
        start(prior != nullptr ? *prior : first_rotation(n_start));
        for (Index k = 1; k < n_levels; ++k) {
            report_progress(options_.progress, static_cast<double>(k) / n_levels);
            match_level(k, true);
        }
        SideMatch match{std::move(state_.image)};
        for (const Index n : state_.n_open) match.n_decided_by_position += n;
        return match;
    }

  private:
    void start(const Eigen::Matrix3d& rotation) {
        state_.set_pair(a_.frontiers.source(), b_.frontiers.source());
        state_.rotation[0] = rotation;
    }

    void match_level(Index k, bool allow_deformation) {
        const std::vector<LoopPair> pairs = pair_loops(a_, b_, state_, k);
        parallel_for(pairs.size(), 1, [&](std::size_t i) {
            match_loop(a_, b_, options_, allow_deformation, pairs[i], state_);
        });
        for (const Index v : a_.frontiers[k]) state_.set_preimage(v);
    }

    // The rotation about the axis from the source to the center of a near frontier is tried in steps; the one
    // wins under which the first levels keep most edges and fit best rigidly.
    Eigen::Matrix3d first_rotation(Index n_start) {
        std::optional<std::pair<Index, double>> best;
        Eigen::Matrix3d best_rotation = Eigen::Matrix3d::Identity();
        const Eigen::Vector3d axis = start_axis(a_, n_start);
        const Eigen::Matrix3d onto =
            numerics::shortest_rotation(axis, start_axis(b_, n_start)).toRotationMatrix();
        for (int spin = 0; spin < n_spins; ++spin) {
            report_progress(options_.progress, 0);
            const double angle = 2 * std::numbers::pi * spin / n_spins;
            const Eigen::Matrix3d rotation = onto * Eigen::AngleAxisd(angle, axis).toRotationMatrix();
            start(rotation);
            for (Index k = 1; k < n_start; ++k) match_level(k, false);
            const bool open =
                std::any_of(state_.n_open.begin(), state_.n_open.end(), [](Index n) { return n > 0; });
            const std::pair<Index, double> score = start_quality(n_start);
            if (!best || score > *best) {
                best = score;
                best_rotation = rotation;
            }
            state_.clear(n_start);
            if (!open) break;  // connectivity decided: every spin ends the same
        }
        return best_rotation;
    }

    static Eigen::Vector3d start_axis(const FrontierSide& side, Index n_start) {
        const Index level = std::min<Index>(8, n_start - 1);
        const Eigen::Vector3d center =
            rows_of(side.points, side.frontiers[level]).colwise().mean().transpose();
        const Eigen::Vector3d axis = center - side.points.row(side.frontiers.source()).transpose();
        return axis.norm() > 1e-9 ? Eigen::Vector3d(axis.normalized()) : Eigen::Vector3d::UnitZ();
    }

    // Kept edges among the first levels, and minus the mean squared residual of their best rigid fit.
    std::pair<Index, double> start_quality(Index n_start) const {
        Index kept = 0;
        MatchedPairs pairs;
        const auto n = to_size(a_.frontiers.first[to_size(n_start)]);
        for (const Index v : std::span(a_.frontiers.order).first(n)) {
            const Index image = state_.image[to_size(v)];
            if (image < 0) continue;
            pairs.add(v, image);
            for (const Index w : a_.adjacency.neighbors(v))
                if (state_.image[to_size(w)] >= 0 && b_.adjacency.has_edge(image, state_.image[to_size(w)]))
                    ++kept;
        }
        const Points x = rows_of(a_.points, pairs.source), y = rows_of(b_.points, pairs.target);
        return {kept, -(kabsch(x, y)(x) - y).rowwise().squaredNorm().mean()};
    }

    const FrontierSide &a_, &b_;
    const FrontiersOptions& options_;
    SequenceState state_;
};

}  // namespace

frontiers::SideMatch match_frontiers_in_sequence(const FrontierSide& source, const FrontierSide& target,
                                                 const FrontiersOptions& options,
                                                 const Eigen::Matrix3d* prior) {
    return SequenceMatcher(source, target, options).run(prior);
}

}  // namespace counterpart::frontiers
