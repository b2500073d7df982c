// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/candidates.hpp"

#include "base/parallel.hpp"
#include "match/spectral/extremity_matching.hpp"
#include "match/spectral/extrinsic_candidates.hpp"
#include "match/spectral/oriented_fit.hpp"
#include "match/spectral/promise.hpp"

#include <counterpart/spectral/functional_map.hpp>

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

std::vector<int> sizes_between(int first, int last, int step) {
    std::vector<int> sizes;
    for (int k = first; k < last; k += step) sizes.push_back(k);
    sizes.push_back(last);
    return sizes;
}

Eigen::MatrixXd unit_columns(Eigen::MatrixXd m) {
    for (Eigen::Index j = 0; j < m.cols(); ++j) m.col(j) /= std::max(m.col(j).norm(), 1e-12);
    return m;
}

// Coefficients of a shape's curvature.
Eigen::MatrixXd curvature_coefficients(const PreparedShape& shape, int k, const CandidateTuning& tuning) {
    const Eigen::MatrixXd dual =
        shape.basis.eigenfunctions.leftCols(k).transpose() * shape.basis.mass.asDiagonal();
    return unit_columns(dual * shape.curvature) * tuning.curvature_weight;
}

// The same, followed by those of heat kernels at the given vertices.
Eigen::MatrixXd with_heat_kernels(const Eigen::MatrixXd& curvature, const PreparedShape& shape,
                                  const std::vector<Index>& vertices, const std::vector<double>& times) {
    const Eigen::Index k = curvature.rows();
    Eigen::MatrixXd heat(k, static_cast<Eigen::Index>(vertices.size() * times.size()));
    Eigen::Index column = 0;
    for (const Index v : vertices)
        for (const double t : times)
            heat.col(column++) = shape.basis.eigenfunctions.row(v).head(k).transpose().array() *
                                 (-t * shape.basis.eigenvalues.head(k).array()).exp();
    Eigen::MatrixXd all(k, curvature.cols() + heat.cols());
    all << curvature, unit_columns(heat);
    return all;
}

// A candidate's first two maps, enough to tell whether it will resemble another one.
struct Beginning {
    PairedMaps maps;
    int size = 0;  // functions that it is fitted to
};

// Stage 2 in its order: starts, growth, sign flips.
class CandidateSearch {
  public:
    CandidateSearch(const SampledPair& pair, const CandidateTuning& tuning, const ProgressRange& progress,
                    std::vector<Candidate> known = {})
        : pair_(pair),
          tuning_(tuning),
          progress_(progress),
          distance_(pair),
          promise_(pair, tuning.promise),
          candidates_(std::move(known)) {}

    void add_from_anchors(const std::vector<VertexPairs>& anchors, bool plain);
    void add_reoriented();
    void add_extrinsic();
    void add_flipped();
    std::vector<Candidate> best(std::size_t count);

  private:
    Beginning begin(const PairedFunctionalMaps& start) const;
    Candidate grow(Beginning beginning) const;
    void add_grown(std::vector<Beginning> beginnings);
    std::vector<Beginning> flips() const;
    std::vector<Beginning> distinct(std::vector<Beginning> beginnings) const;

    const SampledPair& pair_;
    const CandidateTuning& tuning_;
    const ProgressRange progress_;
    const MapDistance distance_;
    const Promise promise_;
    std::vector<Candidate> candidates_;
};

Beginning CandidateSearch::begin(const PairedFunctionalMaps& start) const {
    progress_.check();
    const int size = std::min(static_cast<int>(start.a_from_b.rows()) + 1, tuning_.last_size);
    return {zoom_out(pair_.points_a, pair_.points_b, match_points(pair_.points_a, pair_.points_b, start),
                     {size}, false),
            size};
}

Candidate CandidateSearch::grow(Beginning beginning) const {
    progress_.check();
    const int last = tuning_.last_size, step = tuning_.size_step;
    Candidate candidate;
    candidate.maps = zoom_out(pair_.points_a, pair_.points_b, std::move(beginning.maps),
                              sizes_between(std::min(beginning.size + step, last), last, step), false);
    candidate.functional = fit_functional_maps(pair_.points_a, pair_.points_b, candidate.maps, last, false);
    candidate.promise = promise_(candidate.maps, candidate.functional);
    return candidate;
}

void CandidateSearch::add_grown(std::vector<Beginning> beginnings) {
    const std::size_t n_before = candidates_.size();
    candidates_.resize(n_before + beginnings.size());
    parallel_for(beginnings.size(), 1,
                 [&](std::size_t i) { candidates_[n_before + i] = grow(std::move(beginnings[i])); });
}

// In either direction, so that exchanging the shapes changes nothing.
PairedFunctionalMaps fitted_both_ways(const PreparedShape& a, const PreparedShape& b,
                                      const KnownFunctions& known) {
    const Vector &on_a = a.basis.eigenvalues, &on_b = b.basis.eigenvalues;
    return {fit_functional_map(known.on_a, on_a, known.on_b, on_b).cast<float>(),
            fit_functional_map(known.on_b, on_b, known.on_a, on_a).cast<float>()};
}

// Likewise, oriented.
PairedFunctionalMaps fitted_both_ways(const PreparedShape& a, const PreparedShape& b,
                                      const KnownFunctions& known, const CandidateTuning& tuning) {
    const auto fit = [&](const PreparedShape& x, const PreparedShape& y, const KnownFunctions& both) {
        return MatrixF(
            fit_oriented(x, y, both, tuning.orientation_weight, tuning.orientation_heat_time).cast<float>());
    };
    return {fit(a, b, known), fit(b, a, reversed(known))};
}

// Functional maps fitted to curvature and heat kernels at the anchors, each with operators there that tell
// it from its mirror image, and if `plain` without them too.
void CandidateSearch::add_from_anchors(const std::vector<VertexPairs>& anchors, bool plain) {
    const PreparedShape &a = pair_.a, &b = pair_.b;
    const int k = std::min({tuning_.first_size, a.basis.size(), b.basis.size()});
    const Eigen::MatrixXd curvature_a = curvature_coefficients(a, k, tuning_),
                          curvature_b = curvature_coefficients(b, k, tuning_);
    std::vector<Beginning> beginnings(2 * anchors.size());
    parallel_for(anchors.size(), 1, [&](std::size_t i) {
        std::vector<Index> on_a, on_b;
        for (const auto& [va, vb] : anchors[i]) {
            on_a.push_back(va);
            on_b.push_back(vb);
        }
        const KnownFunctions known{with_heat_kernels(curvature_a, a, on_a, tuning_.heat_times),
                                   with_heat_kernels(curvature_b, b, on_b, tuning_.heat_times), anchors[i]};
        if (plain) beginnings[2 * i] = begin(fitted_both_ways(a, b, known));
        if (!anchors[i].empty()) beginnings[2 * i + 1] = begin(fitted_both_ways(a, b, known, tuning_));
    });
    std::erase_if(beginnings, [](const Beginning& beginning) { return beginning.size == 0; });
    add_grown(std::move(beginnings));
}

// A candidate may take the tips of all limbs to the right ones and yet turn half the body round: its tips
// alone give another start.
void CandidateSearch::add_reoriented() {
    const PreparedShape &a = pair_.a, &b = pair_.b;
    const std::vector<Index> tips_a = samples_of_extremities(a, pair_.points_a.size()),
                             tips_b = samples_of_extremities(b, pair_.points_b.size());
    std::vector<VertexPairs> anchors;
    for (std::size_t i = 0; i < std::min(candidates_.size(), tuning_.n_reoriented); ++i) {
        const PairedMaps& maps = candidates_[i].maps;
        VertexPairs of_a, of_b;
        for (std::size_t e = 0; e < tips_a.size(); ++e)
            of_a.emplace_back(a.extremities[e].vertex, b.samples[at(maps.b_from_a[at(tips_a[e])])]);
        for (std::size_t e = 0; e < tips_b.size(); ++e)
            of_b.emplace_back(a.samples[at(maps.a_from_b[at(tips_b[e])])], b.extremities[e].vertex);
        anchors.push_back(std::move(of_a));
        anchors.push_back(std::move(of_b));
    }
    add_from_anchors(anchors, false);
}

void CandidateSearch::add_extrinsic() {
    std::vector<Beginning> beginnings;
    for (PairedMaps& maps : extrinsic_candidates(pair_, tuning_.extrinsic.n_iterations))
        beginnings.push_back({std::move(maps), tuning_.extrinsic.n_functions});
    add_grown(std::move(beginnings));
}

// The functional maps of a candidate's first columns, the last of them negated.
PairedFunctionalMaps flipped(const PairedFunctionalMaps& maps, int column) {
    const int k = column + 1;
    PairedFunctionalMaps result{maps.a_from_b.topLeftCorner(k, k), maps.b_from_a.topLeftCorner(k, k)};
    result.a_from_b.col(column) *= -1;
    result.b_from_a.row(column) *= -1;
    return result;
}

// Of the first candidates.
std::vector<Beginning> CandidateSearch::flips() const {
    std::vector<std::pair<std::size_t, int>> flips;
    for (std::size_t i = 0; i < std::min(candidates_.size(), tuning_.n_flipped); ++i) {
        const MatrixF& map = candidates_[i].functional.a_from_b;
        const auto last =
            static_cast<int>(std::min({Eigen::Index{tuning_.last_flip}, map.rows() - 1, map.cols() - 1}));
        for (int column = tuning_.first_flip; column <= last; ++column) flips.emplace_back(i, column);
    }
    std::vector<Beginning> beginnings(flips.size());
    parallel_for(flips.size(), 1, [&](std::size_t f) {
        beginnings[f] = begin(flipped(candidates_[flips[f].first].functional, flips[f].second));
    });
    return beginnings;
}

// Those that are all different.
std::vector<Beginning> CandidateSearch::distinct(std::vector<Beginning> beginnings) const {
    std::vector<Beginning> kept;
    for (Beginning& beginning : beginnings) {
        const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const Beginning& other) {
            return distance_(beginning.maps, other.maps) >= tuning_.min_new_difference;
        });
        if (is_new) kept.push_back(std::move(beginning));
    }
    return kept;
}

void CandidateSearch::add_flipped() {
    add_grown(distinct(flips()));
    keep_distinct(candidates_, distance_, tuning_.distinct, tuning_.n_pool);
}

// All of them different.
std::vector<Candidate> CandidateSearch::best(std::size_t count) {
    keep_distinct(candidates_, distance_, tuning_.distinct, count);
    return std::move(candidates_);
}

// Vertices that starts take as corresponding: landmarks, and in most starts extremities.
std::vector<VertexPairs> anchors(const SampledPair& pair, const ExtremityTuning& tuning) {
    VertexPairs landmarks;
    for (const PriorPair& landmark : pair.priors.landmarks) landmarks.emplace_back(landmark.a, landmark.b);
    std::vector<VertexPairs> result;
    for (const ExtremityMatching& matching : match_extremities(pair, tuning)) {
        result.push_back(landmarks);
        for (const auto& [i, j] : matching.pairs)
            result.back().emplace_back(pair.a.extremities[static_cast<std::size_t>(i)].vertex,
                                       pair.b.extremities[static_cast<std::size_t>(j)].vertex);
    }
    result.push_back(landmarks);
    return result;
}

}  // namespace

std::vector<Candidate> start_candidates(const SampledPair& pair, const CandidateTuning& tuning,
                                        const ProgressRange& progress) {
    CandidateSearch search(pair, tuning, progress);
    search.add_from_anchors(anchors(pair, tuning.extremities), true);
    if (tuning.extrinsic.enabled) search.add_extrinsic();
    return search.best(tuning.n_pool);
}

std::vector<Candidate> few_candidates(const SampledPair& pair, std::size_t count,
                                      const CandidateTuning& tuning) {
    ExtremityTuning few = tuning.extremities;
    few.n_matchings = count;
    few.n_fine_matchings = 0;
    std::vector<VertexPairs> starts = anchors(pair, few);
    starts.resize(std::min(starts.size(), count));
    CandidateSearch search(pair, tuning, {});
    search.add_from_anchors(starts, false);
    return search.best(tuning.n_pool);
}

std::vector<Candidate> vary_candidates(const SampledPair& pair, std::vector<Candidate> started,
                                       const CandidateTuning& tuning, const ProgressRange& progress) {
    CandidateSearch search(pair, tuning, progress, std::move(started));
    search.add_flipped();
    search.add_reoriented();
    return search.best(tuning.n_pool);
}

}  // namespace counterpart::spectral_match
