// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/rivals.hpp"

#include "match/spectral/refined_score.hpp"
#include "match/spectral/refinement.hpp"

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

// A finalist that is refined in full.
struct Rival {
    Candidate* candidate;
    bool is_settled = false;  // refining it again gains nothing

    double score() const { return candidate->refined_score; }
};

std::vector<Rival> rivals_among(std::vector<Candidate>& finalists, const RivalTuning& tuning) {
    const double least = finalists.front().scores.total - tuning.close_score;
    std::vector<Rival> rivals;
    for (Candidate& finalist : finalists)
        if (rivals.size() < tuning.n_refined && finalist.was_tried && finalist.scores.total >= least)
            rivals.push_back({&finalist});
    return rivals;
}

// Stages of the race, for progress: all once, then fewer and fewer again, then the winner by both maps.
class Race {
  public:
    Race(const SampledPair& all, const RivalTuning& tuning, const RefinementTuning& refinement,
         const ProgressRange& progress)
        : all_(all), tuning_(tuning), refinement_(refinement), progress_(progress) {}

    // One rival after the other: each takes all threads, and its memory.
    void run(std::vector<Rival>& rivals) const {
        for (std::size_t i = 0; i < rivals.size(); ++i) {
            Candidate& candidate = *rivals[i].candidate;
            candidate.on_vertices = refine(all_, candidate, refinement_, part(0).step(i, rivals.size()));
            candidate.refined_score = refined_score(all_, candidate.on_vertices, tuning_.score);
        }
        best_first(rivals);
        for (std::size_t round = 0; round < tuning_.n_repeated.size(); ++round) {
            const std::size_t n = std::min(rivals.size(), tuning_.n_repeated[round]);
            for (std::size_t i = 0; i < n; ++i) refine_again(rivals[i], part(round + 1).step(i, n));
            best_first(rivals);
        }
        if (tuning_.n_pull_rounds > 0) refine_with_both_pulling(rivals.front());
        progress_.reach(1);
    }

  private:
    // They pull from then on, also on all vertices, whether or not that gains here.
    void refine_with_both_pulling(Rival& winner) const {
        winner.candidate->both_pull = true;
        winner.is_settled = false;
        for (std::size_t i = 0; i < tuning_.n_pull_rounds; ++i)
            refine_again(winner, part(tuning_.n_repeated.size() + 1).step(i, tuning_.n_pull_rounds));
    }

    // Once more, from where the last refinement ended: from stiff to pliable, unless the tuning goes on.
    void refine_again(Rival& rival, const ProgressRange& progress) const {
        if (rival.is_settled) return;
        Candidate next = *rival.candidate;
        next.maps = between_samples(all_, next.on_vertices);
        next.on_vertices = refine(all_, next, refinement_, progress);
        next.refined_score = refined_score(all_, next.on_vertices, tuning_.score);
        rival.is_settled = next.refined_score <= rival.score();
        if (rival.is_settled) return;
        rival.candidate->on_vertices = std::move(next.on_vertices);
        rival.candidate->refined_score = next.refined_score;
    }

    static void best_first(std::vector<Rival>& rivals) {
        std::stable_sort(rivals.begin(), rivals.end(),
                         [](const Rival& x, const Rival& y) { return x.score() > y.score(); });
    }

    ProgressRange part(std::size_t round) const {
        const auto n = static_cast<double>(tuning_.n_repeated.size() + (tuning_.n_pull_rounds > 0 ? 2 : 1)),
                   k = static_cast<double>(round);
        return progress_.part(k / n, (k + 1) / n);
    }

    const SampledPair& all_;
    const RivalTuning& tuning_;
    const RefinementTuning& refinement_;
    const ProgressRange progress_;
};

}  // namespace

void refine_rivals(std::vector<Candidate>& finalists, const SampledPair& all, const RivalTuning& tuning,
                   const RefinementTuning& refinement, const ProgressRange& progress) {
    std::vector<Rival> rivals = rivals_among(finalists, tuning);
    if (rivals.empty()) return;  // no score is a number
    Race(all, tuning, refinement, progress).run(rivals);
    Candidate& winner = *rivals.front().candidate;
    const double score = winner.scores.total, best = winner.refined_score;
    for (Candidate& finalist : finalists) finalist.scores.total = std::min(finalist.scores.total, score);
    for (const Rival& rival : rivals) {
        rival.candidate->scores.total = score - (best - rival.score());
        // The map of a single one stays what it was compared by before.
        if (rivals.size() > 1) rival.candidate->maps = between_samples(all, rival.candidate->on_vertices);
    }
    // Of equals the first one stays first: the winner before those whose scores were capped to its.
    std::swap(finalists.front(), winner);
    keep_distinct(finalists, MapDistance(all), tuning.distinct, finalists.size());
}

}  // namespace counterpart::spectral_match
