// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/race.hpp"

#include "match/spectral/candidates.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace counterpart::spectral_match {
namespace {

class Race {
  public:
    Race(const Level& level, const ProgressRange& progress, Stopwatch& watch)
        : level_(level),
          tuning_(level.tuning.race),
          progress_(progress),
          watch_(watch),
          few_(level.pair.a, level.pair.b, level.tuning.candidates.n_samples, level.pair.priors),
          between_few_(few_),
          between_all_(level.pair) {}

    Contenders run() {
        std::vector<Candidate> proposals =
            start_candidates(few_, level_.tuning.candidates, progress_.part(0, 0.2));
        watch_.lap("proposals");
        const std::vector<double> ranks = enter(proposals, tuning_.n_first, progress_.part(0.2, 0.4));
        contenders_.first_score = contenders_.leader().rank();
        if (!is_decided(progress_.part(0.4, 0.45))) {
            watch_.lap("race");
            vary(std::move(proposals), ranks);
            halve();
        }
        watch_.lap("race");
        progress_.reach(1);
        return std::move(contenders_);
    }

    double first_score(std::size_t count) {
        enter(start_candidates(few_, level_.tuning.candidates, progress_.part(0, 0.5)), count,
              progress_.part(0.5, 1));
        return contenders_.leader().rank();
    }

    double first_score_of_few(std::size_t count) {
        const std::vector<Candidate> few = few_candidates(few_, count, level_.tuning.candidates);
        if (few.empty()) return -std::numeric_limits<double>::infinity();
        enter(few, few.size(), progress_);
        return contenders_.leader().rank();
    }

  private:
    // The first schedule for those that are new; the rank of each proposal that enters, or -infinity.
    std::vector<double> enter(const std::vector<Candidate>& proposals, std::size_t most,
                              const ProgressRange& progress) {
        std::vector<Start> starts;
        std::vector<std::size_t> entered;
        for (std::size_t i = 0; i < proposals.size() && starts.size() < most; ++i) {
            const Candidate& proposal = proposals[i];
            if (proposal.rank() < proposals.front().rank() - tuning_.close_proposal) break;
            if (!is_new(proposal.maps)) continue;
            Map map;
            map.maps = match_points(level_.pair.points_a, level_.pair.points_b, proposal.functional);
            starts.push_back({std::move(map), tuning_.first});
            entered.push_back(i);
        }
        std::vector<Map> maps = refine_all(level_, starts, progress);
        std::vector<double> ranks(proposals.size(), -std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < maps.size(); ++i) {
            ranks[entered[i]] = maps[i].rank();
            contenders_.in_race.push_back(std::move(maps[i]));
        }
        keep({contenders_.in_race.size(), std::numeric_limits<double>::infinity()});
        return ranks;
    }

    // One leads by far, and is good once it is refined further.
    bool is_decided(const ProgressRange& progress) {
        if (contenders_.lead() < tuning_.sure_lead) return false;
        const Map refined = Refiner(level_)(contenders_.leader(), tuning_.second, {}, progress);
        if (refined.rank() < tuning_.sure_score) return false;
        keep({1, 0});
        contenders_.in_race.front() = refined;
        return true;
    }

    bool is_new(const PairedMaps& maps) {
        const bool result = std::all_of(seen_.begin(), seen_.end(), [&](const PairedMaps& other) {
            return between_few_(maps, other) >= tuning_.min_new_difference;
        });
        if (result) seen_.push_back(maps);
        return result;
    }

    // Flips of the leaders of the race enter as well.
    void vary(std::vector<Candidate> proposals, const std::vector<double>& ranks) {
        std::vector<std::size_t> order(proposals.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t i, std::size_t j) { return ranks[i] > ranks[j]; });
        std::vector<Candidate> leaders_first;
        for (const std::size_t i : order) leaders_first.push_back(std::move(proposals[i]));
        proposals = vary_candidates(few_, std::move(leaders_first), level_.tuning.candidates,
                                    progress_.part(0.45, 0.55));
        watch_.lap("proposals");
        enter(proposals, tuning_.n_varied, progress_.part(0.55, 0.7));
    }

    void halve() {
        keep(tuning_.after_first);
        std::vector<Start> starts;
        for (const Map& map : contenders_.in_race) starts.push_back({map, tuning_.second});
        contenders_.in_race = refine_all(level_, starts, progress_.part(0.7, 0.85));
        keep(tuning_.after_second);
        if (contenders_.in_race.size() > 1) again(progress_.part(0.85, 1));
        keep(tuning_.last);
    }

    void again(const ProgressRange& progress) {
        refine_again(contenders_.in_race, level_, tuning_.second, progress);
    }

    void keep(const Heat& heat) { contenders_.keep(heat, between_all_, tuning_.distinct); }

    const Level& level_;
    const RaceTuning& tuning_;
    const ProgressRange progress_;
    Stopwatch& watch_;
    const SampledPair few_;  // on which proposals are made
    const MapDistance between_few_, between_all_;
    std::vector<PairedMaps> seen_;  // proposals that have entered
    Contenders contenders_;
};

}  // namespace

Contenders race(const Level& level, const ProgressRange& progress, Stopwatch& watch) {
    return Race(level, progress, watch).run();
}

double first_score(const Level& level, std::size_t count, const ProgressRange& progress, Stopwatch& watch) {
    return Race(level, progress, watch).first_score(count);
}

double first_score_of_few(const Level& level, std::size_t count, const ProgressRange& progress,
                          Stopwatch& watch) {
    return Race(level, progress, watch).first_score_of_few(count);
}

}  // namespace counterpart::spectral_match
