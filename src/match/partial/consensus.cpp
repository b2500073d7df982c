// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/consensus.hpp"

#include "base/parallel.hpp"
#include "base/random.hpp"
#include "numerics/median.hpp"
#include "numerics/product.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

namespace counterpart::partial_match {
namespace {

using Row = Eigen::Index;  // of a matrix

// Possible matches, K per source sample, side by side.
struct Matches {
    Row n_samples = 0, per_sample = 0;
    std::vector<Index> target;  // sample
    std::vector<float> similarity;

    Row size() const { return n_samples * per_sample; }
};

Matches best_matches(const MatrixF& similarity, int n_candidates) {
    Matches matches{similarity.rows(), std::min<Row>(n_candidates, similarity.cols()), {}, {}};
    std::vector<Index> order(static_cast<std::size_t>(similarity.cols()));
    for (Row u = 0; u < similarity.rows(); ++u) {
        std::iota(order.begin(), order.end(), 0);
        std::partial_sort(
            order.begin(), order.begin() + matches.per_sample, order.end(), [&](auto a, auto b) {
                return similarity(u, a) != similarity(u, b) ? similarity(u, a) > similarity(u, b) : a < b;
            });
        for (Row k = 0; k < matches.per_sample; ++k) {
            matches.target.push_back(order[static_cast<std::size_t>(k)]);
            matches.similarity.push_back(std::max(similarity(u, matches.target.back()), 0.0F));
        }
    }
    return matches;
}

// How the normals at two points are turned against each other and the line between: differs under reflection.
Eigen::Vector4f frame_features(const Surface& surface, Row a, Row b) {
    const auto at = [&](Row i) { return surface.samples[static_cast<std::size_t>(i)]; };
    const Eigen::RowVector3d line =
        (surface.mesh.vertices.row(at(b)) - surface.mesh.vertices.row(at(a))).normalized();
    const Eigen::RowVector3d n = surface.normals.row(at(a)), m = surface.normals.row(at(b));
    return Eigen::Vector4d(n.dot(m), n.dot(line), m.dot(line), n.cross(m).dot(line)).cast<float>();
}

// How much a pair of samples can say: less if its distance is long, or known only roughly.
float pair_weight(const SamplePair& pair, Row u, Row v, const ConsensusTuning& tuning) {
    if (u == v) return 0;
    const float high = pair.source.between.high(u, v), low = pair.source.between.low(u, v);
    const double more = std::min(u, v) < pair.n_landmarks ? tuning.landmark_weight : 1;
    return static_cast<float>(more) / (1 + (high - low) / static_cast<float>(tuning.interval_length)) /
           (1 + high / static_cast<float>(tuning.far_length));
}

class Affinity {
  public:
    Affinity(const SamplePair& pair, const Matches& matches, const ConsensusTuning& tuning)
        : weights(matches.n_samples, matches.n_samples), values(matches.size(), matches.size()) {
        for (Row u = 0; u < matches.n_samples; ++u)
            for (Row v = 0; v < matches.n_samples; ++v) weights(u, v) = pair_weight(pair, u, v, tuning);
        parallel_for(static_cast<std::size_t>(matches.n_samples), 4, [&](std::size_t i) {
            for (Row v = 0; v < matches.n_samples; ++v)
                fill(pair.source, pair.target, matches, tuning, static_cast<Row>(i), v);
        });
    }

    MatrixF weights;  // source samples x source samples
    MatrixF values;   // matches x matches

  private:
    // The block of one pair of source samples.
    void fill(const Surface& source, const Surface& target, const Matches& matches,
              const ConsensusTuning& tuning, Row u, Row v) {
        const Row k = matches.per_sample;
        const float high = source.between.high(u, v), low = source.between.low(u, v);
        if (u == v || high < tuning.min_distance) {
            values.block(u * k, v * k, k, k).setZero();
            return;
        }
        const auto sigma = static_cast<float>(tuning.sigma + tuning.sigma_slope * high);
        const bool is_near = high < tuning.frame_distance;
        const Eigen::Vector4f frame = is_near ? frame_features(source, u, v) : Eigen::Vector4f::Zero();
        for (Row i = u * k; i < (u + 1) * k; ++i) {
            for (Row j = v * k; j < (v + 1) * k; ++j) {
                const Row a = matches.target[static_cast<std::size_t>(i)],
                          b = matches.target[static_cast<std::size_t>(j)];
                const float x =
                    std::max({target.between.low(a, b) - high, low - target.between.high(a, b), 0.0F}) /
                    sigma;
                float w = weights(u, v) * std::exp(-0.5F * x * x) *
                          std::sqrt(matches.similarity[static_cast<std::size_t>(i)] *
                                    matches.similarity[static_cast<std::size_t>(j)]);
                if (is_near && x < 1.8F)
                    w *= std::exp(-(frame_features(target, a, b) - frame).squaredNorm() /
                                  static_cast<float>(2 * tuning.frame_sigma * tuning.frame_sigma));
                values(i, j) = w;
            }
        }
    }
};

// Matches to begin with: half are the best by the leading eigenvector, the others are drawn from the rest.
std::vector<Row> seeds(const Affinity& affinity, const Matches& matches, const ConsensusTuning& tuning,
                       std::uint64_t seed) {
    MatrixF x = MatrixF::Ones(matches.size(), 1);
    for (int i = 0; i < 15; ++i) {
        x = numerics::product(affinity.values, x);
        x /= std::max(x.maxCoeff(), 1e-30F);
    }
    std::vector<Row> order(static_cast<std::size_t>(matches.size())), found;
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Row a, Row b) { return x(a, 0) > x(b, 0); });
    std::vector<int> of_sample(static_cast<std::size_t>(matches.n_samples), 0);
    const auto n_seeds = static_cast<std::size_t>(tuning.n_seeds);
    for (const Row i : order) {
        if (of_sample[static_cast<std::size_t>(i / matches.per_sample)]++ < tuning.n_seeds_per_sample)
            found.push_back(i);
        if (found.size() == 4 * n_seeds) break;
    }
    if (found.size() <= n_seeds) return found;
    std::vector<Row> rest(found.begin() + static_cast<std::ptrdiff_t>(n_seeds / 2), found.end());
    Random(seed).shuffle(rest);
    found.resize(n_seeds / 2);
    found.insert(found.end(), rest.begin(),
                 rest.begin() + static_cast<std::ptrdiff_t>(n_seeds - n_seeds / 2));
    return found;
}

// Columns: how much each match belongs to the group of each seed, by power steps in which the candidates of a
// sample compete.
MatrixF groups(const Affinity& affinity, const Matches& matches, const std::vector<Row>& seeds,
               const ConsensusTuning& tuning) {
    const auto n_seeds = static_cast<Row>(seeds.size());
    MatrixF x = affinity.values(Eigen::all, seeds);
    for (Row s = 0; s < n_seeds; ++s) x(seeds[static_cast<std::size_t>(s)], s) = 1;
    const MatrixF gate =
        (x.array() >
         (x.colwise().maxCoeff() * static_cast<float>(tuning.gate)).replicate(x.rows(), 1).array())
            .cast<float>();
    for (int step = 0; step < tuning.n_power_steps; ++step) {
        x = numerics::product(affinity.values, x);
        if (step < tuning.n_gated_steps) x.array() *= gate.array();
        parallel_for(static_cast<std::size_t>(matches.n_samples), 16, [&](std::size_t u) {
            auto block = x.middleRows(static_cast<Row>(u) * matches.per_sample, matches.per_sample);
            for (Row s = 0; s < n_seeds; ++s) {
                const float most = std::max(block.col(s).maxCoeff(), 1e-30F);
                for (float& value : block.col(s).reshaped())
                    if (value < most)
                        value *= static_cast<float>(tuning.loser_weight) * (value / most) * (value / most);
            }
        });
        for (Row s = 0; s < n_seeds; ++s) x.col(s) /= std::max(x.col(s).maxCoeff(), 1e-30F);
    }
    return x;
}

// The group's best candidate of each sample, then in turns the candidate with most support and who may vote.
SampleMap settle(const Affinity& affinity, const Matches& matches, const MatrixF& group, Row column,
                 const ConsensusTuning& tuning) {
    const Row n = matches.n_samples, k = matches.per_sample;
    std::vector<Row> chosen(static_cast<std::size_t>(n));
    const auto choose = [&](const auto& scores) {
        for (Row u = 0; u < n; ++u) {
            Row best = 0;
            scores.segment(u * k, k).maxCoeff(&best);
            chosen[static_cast<std::size_t>(u)] = u * k + best;
        }
    };
    choose(group.col(column));
    std::vector<char> votes(static_cast<std::size_t>(n), 1);
    std::vector<float> support(static_cast<std::size_t>(n), 0);
    for (int round = 0; round < tuning.n_choice_rounds; ++round) {
        Eigen::RowVectorXf sum = Eigen::RowVectorXf::Zero(matches.size()), most = Eigen::RowVectorXf::Zero(n);
        for (Row v = 0; v < n; ++v) {
            if (votes[static_cast<std::size_t>(v)] == 0) continue;
            sum += affinity.values.row(chosen[static_cast<std::size_t>(v)]);
            most += affinity.weights.row(v);
        }
        choose(sum);
        std::vector<float> of_voters;
        for (Row u = 0; u < n; ++u) {
            const auto i = static_cast<std::size_t>(u);
            support[i] = sum[chosen[i]] / std::max(most[u], 1e-9F);
            if (votes[i] != 0) of_voters.push_back(support[i]);
        }
        const float least = static_cast<float>(tuning.min_support) * numerics::median(of_voters);
        for (std::size_t u = 0; u < votes.size(); ++u) votes[u] = support[u] > least ? 1 : 0;
    }
    SampleMap map;
    double total = 0;
    for (std::size_t u = 0; u < chosen.size(); ++u) {
        map.image.push_back(matches.target[static_cast<std::size_t>(chosen[u])]);
        map.vote.push_back(votes[u]);
        if (votes[u] == 0) continue;
        for (std::size_t v = 0; v < chosen.size(); ++v)
            if (votes[v] != 0) total += affinity.values(chosen[u], chosen[v]);
    }
    map.support = std::move(support);
    map.total = total / std::max(static_cast<double>(affinity.weights.sum()), 1e-9);
    return map;
}

}  // namespace

bool are_same(const SampleMap& a, const SampleMap& b, double share) {
    std::size_t n = 0;
    for (std::size_t u = 0; u < a.image.size(); ++u) n += a.image[u] == b.image[u] ? 1U : 0U;
    return static_cast<double>(n) > share * static_cast<double>(a.image.size());
}

SamplePair::SamplePair(const Surface& a, const Surface& b, Index landmarks, const SurfaceTuning& tuning)
    : source(a), target(b), n_landmarks(landmarks) {
    similarity = numerics::product(source.signatures, target.signatures.transpose()) /
                 static_cast<float>(tuning.radii.size());
    for (Index u = 0; u < n_landmarks; ++u) {
        similarity.row(u).setZero();
        similarity(u, u) = 1;
    }
}

std::vector<SampleMap> consensus_maps(const SamplePair& pair, const ConsensusTuning& tuning,
                                      std::uint64_t seed, const ProgressRange& progress) {
    const Matches matches = best_matches(pair.similarity, tuning.n_candidates);
    const Affinity affinity(pair, matches, tuning);
    progress.reach(0.3);
    const std::vector<Row> starts = seeds(affinity, matches, tuning, seed);
    const MatrixF group = groups(affinity, matches, starts, tuning);
    progress.reach(0.7);
    std::vector<SampleMap> settled(starts.size()), distinct;
    parallel_for(starts.size(), 1, [&](std::size_t s) {
        settled[s] = settle(affinity, matches, group, static_cast<Row>(s), tuning);
    });
    for (SampleMap& map : settled)
        if (std::none_of(distinct.begin(), distinct.end(),
                         [&](const SampleMap& other) { return are_same(map, other, tuning.same_share); }))
            distinct.push_back(std::move(map));
    std::stable_sort(distinct.begin(), distinct.end(),
                     [](const auto& a, const auto& b) { return a.total > b.total; });
    while (!distinct.empty() && (distinct.size() > tuning.n_clusters ||
                                 distinct.back().total < tuning.min_total * distinct.front().total))
        distinct.pop_back();
    return distinct;
}

}  // namespace counterpart::partial_match
