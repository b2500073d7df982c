// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/hash_mixing.hpp"
#include "match/frontiers/loop.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace counterpart::frontiers {
namespace {

constexpr Index unknown = -1;

// Of what a loop is made and where it hangs, in numbers of the source mesh.
std::uint64_t loop_key(const FrontierSide& side, std::span<const Index> loop,
                       const std::vector<Index>* source_of) {
    std::uint64_t sum = 0;
    for (const Index v : loop) {
        sum += mixed(side.subtree_hash[to_size(v)], 1);
        for (const Index p : side.adjacency.neighbors(v)) {
            if (side.frontiers.level[to_size(p)] >= side.frontiers.level[to_size(v)]) continue;
            const Index parent = source_of != nullptr ? (*source_of)[to_size(p)] : p;
            sum += mixed(static_cast<std::uint64_t>(parent), 2);
        }
    }
    return mixed(loop.size(), sum);
}

Eigen::RowVector3d center_of(const FrontierSide& side, std::span<const Index> vertices) {
    return rows_of(side.points, vertices).colwise().mean();
}

class LoopPairing {
  public:
    LoopPairing(const FrontierSide& a, const FrontierSide& b, const SequenceState& state, Index k)
        : a_(a), b_(b), state_(state), k_(k) {}

    std::vector<LoopPair> run() {
        const Index a0 = a_.loops.first_loop[to_size(k_)], a1 = a_.loops.first_loop[to_size(k_) + 1];
        const Index b0 = b_.loops.first_loop[to_size(k_)], b1 = b_.loops.first_loop[to_size(k_) + 1];
        if (a1 - a0 == 1 && b1 - b0 == 1) return {{a0, b0}};
        std::vector<std::pair<std::uint64_t, Index>> ours, theirs;
        for (Index l = a0; l < a1; ++l) ours.emplace_back(loop_key(a_, a_.loops[l], nullptr), l);
        for (Index l = b0; l < b1; ++l) theirs.emplace_back(loop_key(b_, b_.loops[l], &state_.preimage), l);
        std::sort(ours.begin(), ours.end());
        std::sort(theirs.begin(), theirs.end());
        take_unique(ours, theirs);
        take_by_cost(ours, theirs);
        return std::move(pairs_);
    }

  private:
    using Keyed = std::vector<std::pair<std::uint64_t, Index>>;

    // Pairs keys that occur once on each side and leaves the others.
    void take_unique(Keyed& ours, Keyed& theirs) {
        Keyed rest_a, rest_b;
        std::size_t j = 0;
        for (std::size_t i = 0; i < ours.size();) {
            std::size_t i_end = i, j_end = 0;
            while (i_end < ours.size() && ours[i_end].first == ours[i].first) ++i_end;
            while (j < theirs.size() && theirs[j].first < ours[i].first) rest_b.push_back(theirs[j++]);
            for (j_end = j; j_end < theirs.size() && theirs[j_end].first == ours[i].first;) ++j_end;
            if (i_end - i == 1 && j_end - j == 1) {
                pairs_.push_back({ours[i].second, theirs[j].second});
            } else {
                rest_a.insert(rest_a.end(), ours.begin() + static_cast<std::ptrdiff_t>(i),
                              ours.begin() + static_cast<std::ptrdiff_t>(i_end));
                rest_b.insert(rest_b.end(), theirs.begin() + static_cast<std::ptrdiff_t>(j),
                              theirs.begin() + static_cast<std::ptrdiff_t>(j_end));
            }
            i = i_end;
            j = j_end;
        }
        rest_b.insert(rest_b.end(), theirs.begin() + static_cast<std::ptrdiff_t>(j), theirs.end());
        ours = std::move(rest_a);
        theirs = std::move(rest_b);
    }

    void take_by_cost(const Keyed& ours, const Keyed& theirs) {
        if (ours.empty()) return;
        Matrix cost(static_cast<Eigen::Index>(ours.size()), static_cast<Eigen::Index>(theirs.size()));
        std::vector<Eigen::RowVector3d> centers;
        for (const auto& [key, loop] : theirs) centers.push_back(center_of(b_, b_.loops[loop]));
        for (std::size_t i = 0; i < ours.size(); ++i) {
            const auto loop = a_.loops[ours[i].second];
            const std::vector<Index> votes = parent_votes(loop);
            const Index n_votes = std::max<Index>(1, static_cast<Index>(votes.size()));
            const Eigen::RowVector3d expected = expected_center(loop);
            for (std::size_t j = 0; j < theirs.size(); ++j) {
                const Index other = theirs[j].second;
                const auto n_shared = std::count(votes.begin(), votes.end(), other);
                const double away = (centers[j] - expected).squaredNorm();
                // Sizes before sub-trees before parents before position.
                cost(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
                    (loop.size() == b_.loops[other].size() ? 0 : 1e9) +
                    (ours[i].first == theirs[j].first ? 0 : 10) + 4 * (1 - double(n_shared) / n_votes) +
                    away / (1 + away);
            }
        }
        const std::vector<Index> chosen = pair_up(cost, Pairing::optimal);
        for (std::size_t i = 0; i < ours.size(); ++i) {
            const Index other = chosen[i] >= 0 ? theirs[to_size(chosen[i])].second : unknown;
            if (other < 0 || a_.loops[ours[i].second].size() != b_.loops[other].size())
                throw UnsuitableMesh(fmt::format(
                    "the connected components of frontier {} around source vertex {} and target vertex {} "
                    "differ in size; the connectivity differs or these two vertices do not correspond",
                    k_, a_.frontiers.source(), b_.frontiers.source()));
            pairs_.push_back({ours[i].second, other});
        }
    }

    // The loop of b below each edge from a matched parent; the share of a loop says how many parents they
    // share.
    std::vector<Index> parent_votes(std::span<const Index> loop) const {
        std::vector<Index> votes;
        for (const Index v : loop) {
            for (const Index p : a_.adjacency.neighbors(v)) {
                if (a_.frontiers.level[to_size(p)] >= k_ || state_.image[to_size(p)] < 0) continue;
                for (const Index w : b_.adjacency.neighbors(state_.image[to_size(p)]))
                    if (b_.frontiers.level[to_size(w)] == k_) votes.push_back(b_.loops.of_vertex[to_size(w)]);
            }
        }
        return votes;
    }

    // Where the rotation of the parents puts the loop's center.
    Eigen::RowVector3d expected_center(std::span<const Index> loop) const {
        MatchedPairs parents;
        Index parent_loop = 0;
        for (const Index v : loop) {
            for (const Index p : a_.adjacency.neighbors(v)) {
                if (a_.frontiers.level[to_size(p)] >= k_ || state_.image[to_size(p)] < 0) continue;
                parents.add(p, state_.image[to_size(p)]);
                parent_loop = a_.loops.of_vertex[to_size(p)];
            }
        }
        if (parents.source.empty()) return center_of(a_, loop);
        const Eigen::RowVector3d offset = center_of(a_, loop) - center_of(a_, parents.source);
        return center_of(b_, parents.target) + offset * state_.rotation[to_size(parent_loop)].transpose();
    }

    const FrontierSide &a_, &b_;
    const SequenceState& state_;
    Index k_;
    std::vector<LoopPair> pairs_;
};

}  // namespace

std::vector<LoopPair> pair_loops(const FrontierSide& a, const FrontierSide& b, const SequenceState& state,
                                 Index k) {
    return LoopPairing(a, b, state, k).run();
}

}  // namespace counterpart::frontiers
