// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/frontiers/loop.hpp"

#include "base/hash_mixing.hpp"

#include <counterpart/align/tps_rpm.hpp>
#include <counterpart/align/transform.hpp>

#include <algorithm>
#include <utility>

namespace counterpart::frontiers {

SequenceState::SequenceState(const FrontierSide& a, const FrontierSide& b)
    : image(a.slot.size(), -1),
      preimage(b.slot.size(), -1),
      rotation(to_size(a.loops.count()), Eigen::Matrix3d::Identity()),
      n_open(to_size(a.loops.count()), 0),
      key_a(a.slot.size(), 0),
      key_b(b.slot.size(), 0),
      a_(a),
      b_(b) {}

void SequenceState::clear(Index n_levels) {
    for (Index k = 0; k < n_levels; ++k) {
        for (const Index v : a_.frontiers[k]) image[to_size(v)] = -1;
        for (const Index w : b_.frontiers[k]) preimage[to_size(w)] = -1;
    }
    std::fill(n_open.begin(), n_open.end(), 0);
}

namespace {

constexpr double key_penalty = 1e4;  // in squared mean edge lengths: against what connectivity says
constexpr int n_rounds = 4;          // of assignment and rigid fit
constexpr std::size_t min_spline_points = 6;

class LoopMatcher {
  public:
    LoopMatcher(const FrontierSide& a, const FrontierSide& b, const FrontiersOptions& options,
                const LoopPair& loops, SequenceState& state)
        : a_(a),
          b_(b),
          options_(options),
          check_(checking(options.progress)),
          state_(state),
          loop_(loops.source),
          ours_(a.loops[loops.source]),
          theirs_(b.loops[loops.target]),
          level_(a.frontiers.level[to_size(ours_.front())]) {}

    void run(bool allow_deformation) {
        if (options_.vertex_hashes) {
            pin();
        } else {
            open_a_.assign(ours_.begin(), ours_.end());
            open_b_.assign(theirs_.begin(), theirs_.end());
        }
        state_.n_open[to_size(loop_)] = static_cast<Index>(open_a_.size());
        anchor();
        Similarity motion = fit({});
        if (!open_a_.empty() && !open_b_.empty()) decide(motion, allow_deformation);
        state_.rotation[to_size(loop_)] = motion.rotation;
    }

  private:
    // ---- what connectivity decides ----

    // Keys from the sub-tree and the matched parents, spread along the loop until no more vertices are told
    // apart; then pairs those whose key occurs once on each side.
    void pin() {
        first_keys(a_, ours_, nullptr, state_.key_a);
        first_keys(b_, theirs_, &state_.preimage, state_.key_b);
        std::size_t n_distinct = count_distinct(), before = 0;
        while (n_distinct > before && n_distinct < ours_.size()) {
            spread_keys(a_, ours_, state_.key_a);
            spread_keys(b_, theirs_, state_.key_b);
            before = std::exchange(n_distinct, count_distinct());
        }
        const auto keyed = [](const FrontierSide& side, std::span<const Index> loop,
                              const std::vector<std::uint64_t>& keys) {
            std::vector<std::pair<std::uint64_t, Index>> result;
            for (const Index v : loop) result.emplace_back(keys[to_size(side.slot[to_size(v)])], v);
            std::sort(result.begin(), result.end());
            return result;
        };
        const auto by_key_a = keyed(a_, ours_, state_.key_a), by_key_b = keyed(b_, theirs_, state_.key_b);
        const auto less = [](const auto& entry, std::uint64_t key) { return entry.first < key; };
        std::vector<char> taken(theirs_.size(), 0);
        for (std::size_t i = 0; i < by_key_a.size(); ++i) {
            const auto [key, v] = by_key_a[i];
            const bool once = (i == 0 || by_key_a[i - 1].first != key) &&
                              (i + 1 == by_key_a.size() || by_key_a[i + 1].first != key);
            const auto it = std::lower_bound(by_key_b.begin(), by_key_b.end(), key, less);
            const bool once_there = it != by_key_b.end() && it->first == key &&
                                    (it + 1 == by_key_b.end() || (it + 1)->first != key);
            if (once && once_there) {
                state_.image[to_size(v)] = it->second;
                taken[static_cast<std::size_t>(it - by_key_b.begin())] = 1;
            } else {
                open_a_.push_back(v);
            }
        }
        for (std::size_t j = 0; j < by_key_b.size(); ++j)
            if (taken[j] == 0) open_b_.push_back(by_key_b[j].second);
        std::sort(open_a_.begin(), open_a_.end());
        std::sort(open_b_.begin(), open_b_.end());
    }

    // `source_of`: null on the source side; else the source vertex of each target vertex.
    void first_keys(const FrontierSide& side, std::span<const Index> loop,
                    const std::vector<Index>* source_of, std::vector<std::uint64_t>& keys) const {
        for (const Index v : loop) {
            std::uint64_t parents = 0;
            for (const Index p : side.adjacency.neighbors(v))
                if (side.frontiers.level[to_size(p)] < level_)
                    parents += mixed(
                        static_cast<std::uint64_t>(source_of != nullptr ? (*source_of)[to_size(p)] : p));
            keys[to_size(side.slot[to_size(v)])] = mixed(side.subtree_hash[to_size(v)], parents);
        }
    }

    void spread_keys(const FrontierSide& side, std::span<const Index> loop,
                     std::vector<std::uint64_t>& keys) const {
        std::vector<std::uint64_t> next;
        for (const Index v : loop) {
            std::uint64_t siblings = 0;
            for (const Index w : side.adjacency.neighbors(v))
                if (side.frontiers.level[to_size(w)] == level_)
                    siblings += mixed(keys[to_size(side.slot[to_size(w)])]);
            next.push_back(mixed(keys[to_size(side.slot[to_size(v)])], siblings));
        }
        for (std::size_t i = 0; i < loop.size(); ++i) keys[to_size(side.slot[to_size(loop[i])])] = next[i];
    }

    std::size_t count_distinct() const {
        std::vector<std::uint64_t> keys;
        for (const Index v : ours_) keys.push_back(state_.key_a[to_size(a_.slot[to_size(v)])]);
        std::sort(keys.begin(), keys.end());
        return static_cast<std::size_t>(std::unique(keys.begin(), keys.end()) - keys.begin());
    }

    // ---- alignment ----

    // The matched ancestors in the last three levels, nearer ones with more weight, and the pinned vertices.
    void anchor() {
        std::vector<Index> generation(ours_.begin(), ours_.end());
        for (int step = 1; step <= 3; ++step) {
            std::vector<Index> parents;
            for (const Index v : generation)
                for (const Index p : a_.adjacency.neighbors(v))
                    if (a_.frontiers.level[to_size(p)] < a_.frontiers.level[to_size(v)]) parents.push_back(p);
            std::sort(parents.begin(), parents.end());
            parents.erase(std::unique(parents.begin(), parents.end()), parents.end());
            if (step == 1) prior_ = state_.rotation[to_size(a_.loops.of_vertex[to_size(parents.front())])];
            for (const Index p : parents) add_anchor(p, 1.0 / step);
            generation = std::move(parents);
        }
        if (open_a_.size() < ours_.size())
            for (const Index v : ours_) add_anchor(v, 1);
    }

    void add_anchor(Index v, double weight) {
        if (state_.image[to_size(v)] < 0) return;
        anchors_.add(v, state_.image[to_size(v)]);
        anchor_weights_.push_back(weight);
    }

    // To the anchors and, in later rounds, with more weight to the pairs assigned to the open vertices.
    Similarity fit(const std::vector<Index>& chosen) const {
        MatchedPairs pairs = anchors_;
        std::vector<double> weights = anchor_weights_;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (chosen[i] < 0) continue;
            pairs.add(open_a_[i], open_b_[to_size(chosen[i])]);
            weights.push_back(4);
        }
        KabschOptions options;
        options.prior_rotation = prior_;
        options.prior_weight = 1;
        if (pairs.source.empty()) return {prior_};
        return kabsch(rows_of(a_.points, pairs.source), rows_of(b_.points, pairs.target),
                      Eigen::Map<const Vector>(weights.data(), static_cast<Eigen::Index>(weights.size())),
                      options);
    }

    // ---- what positions decide ----

    void decide(Similarity& motion, bool allow_deformation) {
        const Points x = rows_of(a_.points, open_a_), y = rows_of(b_.points, open_b_);
        const Matrix penalty = penalties();
        std::vector<Index> chosen;
        Matrix cost;
        Points aligned;
        for (int round = 0; round < n_rounds; ++round) {
            aligned = motion(x);
            cost = pairing_cost(open_a_, aligned, open_b_, y, options_.metric) + penalty;
            std::vector<Index> next = pair_up(cost, Pairing::optimal, check_);
            if (next == chosen) break;
            chosen = std::move(next);
            motion = fit(chosen);
        }
        if (allow_deformation && open_a_.size() >= min_spline_points && open_b_.size() >= min_spline_points &&
            mean_squared(aligned, y, chosen) > options_.deformation_threshold) {
            const Points bent = bend(aligned, y, mean_squared(aligned, y, chosen));
            const Matrix bent_cost = pairing_cost(open_a_, bent, open_b_, y, options_.metric) + penalty;
            std::vector<Index> bent_chosen = pair_up(bent_cost, Pairing::optimal, check_);
            // The guard: a deformation must not break edges that the rigid motion keeps.
            if (kept_edges(bent_chosen) >= kept_edges(chosen)) {
                chosen = std::move(bent_chosen);
                cost = bent_cost;
                motion = fit(chosen);
            }
        }
        if (options_.pairing != Pairing::optimal) chosen = pair_up(cost, options_.pairing, check_);
        assign(chosen);
    }

    // The cost of edges to matched parents that a pair would break, and of keys that differ.
    Matrix penalties() const {
        const auto n = static_cast<Eigen::Index>(open_a_.size()),
                   m = static_cast<Eigen::Index>(open_b_.size());
        Matrix penalty = Matrix::Zero(n, m);
        for (Eigen::Index i = 0; i < n; ++i) {
            const Index v = open_a_[static_cast<std::size_t>(i)];
            for (const Index p : a_.adjacency.neighbors(v)) {
                if (a_.frontiers.level[to_size(p)] >= level_ || state_.image[to_size(p)] < 0) continue;
                penalty.row(i).array() += options_.edge_penalty;
                for (const Index w : b_.adjacency.neighbors(state_.image[to_size(p)])) {
                    const auto it = std::lower_bound(open_b_.begin(), open_b_.end(), w);
                    if (it != open_b_.end() && *it == w)
                        penalty(i, it - open_b_.begin()) -= options_.edge_penalty;
                }
            }
            if (!options_.vertex_hashes) continue;
            for (Eigen::Index j = 0; j < m; ++j)
                if (state_.key_a[to_size(a_.slot[to_size(v)])] !=
                    state_.key_b[to_size(b_.slot[to_size(open_b_[static_cast<std::size_t>(j)])])])
                    penalty(i, j) += key_penalty;
        }
        return penalty;
    }

    Points bend(PointsView aligned, PointsView y, double mean_squared) const {
        TpsRpmOptions rpm;
        rpm.initial_temperature = 10 * mean_squared;
        rpm.annealing_rate = 0.9;
        rpm.iterations_per_temperature = 2;
        rpm.progress = check_;
        return tps_rpm(aligned, y, rpm).transformed;
    }

    static double mean_squared(PointsView aligned, PointsView y, const std::vector<Index>& chosen) {
        double sum = 0;
        Index count = 0;
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            if (chosen[i] < 0) continue;
            sum += (aligned.row(static_cast<Eigen::Index>(i)) - y.row(chosen[i])).squaredNorm();
            ++count;
        }
        return count > 0 ? sum / count : 0;
    }

    void assign(const std::vector<Index>& chosen) {
        for (std::size_t i = 0; i < chosen.size(); ++i)
            state_.image[to_size(open_a_[i])] = chosen[i] >= 0 ? open_b_[to_size(chosen[i])] : -1;
    }

    // Edges of the open vertices, to parents and within the loop, that lead to neighbors of the image.
    Index kept_edges(const std::vector<Index>& chosen) {
        assign(chosen);
        Index kept = 0;
        for (const Index v : open_a_) {
            const Index image = state_.image[to_size(v)];
            if (image < 0) continue;
            for (const Index w : a_.adjacency.neighbors(v))
                if (a_.frontiers.level[to_size(w)] <= level_ && state_.image[to_size(w)] >= 0 &&
                    b_.adjacency.has_edge(image, state_.image[to_size(w)]))
                    ++kept;
        }
        return kept;
    }

    const FrontierSide &a_, &b_;
    const FrontiersOptions& options_;
    Progress check_;
    SequenceState& state_;
    Index loop_;
    std::span<const Index> ours_, theirs_;
    Index level_;
    std::vector<Index> open_a_, open_b_;  // what positions must decide, in increasing order
    MatchedPairs anchors_;
    std::vector<double> anchor_weights_;
    Eigen::Matrix3d prior_ = Eigen::Matrix3d::Identity();
};

}  // namespace

void match_loop(const FrontierSide& a, const FrontierSide& b, const FrontiersOptions& options,
                bool allow_deformation, const LoopPair& loops, SequenceState& state) {
    LoopMatcher(a, b, options, loops, state).run(allow_deformation);
}

}  // namespace counterpart::frontiers
