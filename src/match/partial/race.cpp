// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/race.hpp"

#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "match/partial/anchored_map.hpp"
#include "match/partial/gain.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

namespace counterpart::partial_match {
namespace {

using Pins = std::vector<std::pair<Index, Index>>;

// A way to begin: laid down as a whole, or sample by sample.
struct Start {
    std::optional<Placement> placement;
    SampleMap anchors;  // without a placement
};

struct Runner {
    Start start;
    BentSource bent;
    Gain gained;
    SampleMap anchors;  // where the samples of the part have come to lie; each votes as far as it fits there
    double total = 0;   // the larger, the better
};

// What the bending needs, of the surfaces as they are or of copies.
class Track {
  public:
    Track(const SamplePair& pair, const Surface& part, Pins pins, const PartialTuning& tuning)
        : pair_(pair),
          part_(part),
          pins_(std::move(pins)),
          tuning_(tuning),
          fit_(part, pair.target, tuning.fit) {}

    Runner run(Start start) const {
        Runner runner{std::move(start), {}, {}, {}};
        FitStart from{{}, pins_, {}, {}};
        if (runner.start.placement)
            from.positions = placed(*runner.start.placement);
        else
            from.image = anchored_map(part_, pair_.target, runner.start.anchors, tuning_.anchoring, {});
        runner.bent = fit_(std::move(from));
        runner.gained = gain(part_, pair_.target, runner.bent, tuning_.gain);
        runner.anchors = anchors(runner);
        runner.total = runner.gained.total + tuning_.race.likeness * likeness(runner.anchors);
        return runner;
    }

  private:
    SampleMap anchors(const Runner& runner) const {
        SampleMap map;
        for (const Index v : part_.samples) {
            Eigen::Index nearest = 0;
            pair_.target.rows.col(runner.bent.image[to_size(v)]).minCoeff(&nearest);
            map.image.push_back(static_cast<Index>(nearest));
            map.vote.push_back(runner.gained.fit_of_part[to_size(v)]);
            map.support.push_back(1);
        }
        return map;
    }

    // SHOT of the samples that fit, against SHOT of those next to their images.
    double likeness(const SampleMap& map) const {
        double sum = 0, votes = 0;
        for (std::size_t u = 0; u < map.image.size(); ++u) {
            sum += map.vote[u] * pair_.similarity(static_cast<Eigen::Index>(u), map.image[u]);
            votes += map.vote[u];
        }
        return votes > 0 ? sum / votes : 0;
    }

    Points placed(const Placement& placement) const {
        Points positions = part_.mesh.vertices;
        for (Eigen::Index v = 0; v < positions.rows(); ++v)
            positions.row(v) =
                placement(positions.row(v).transpose().cast<float>()).transpose().cast<double>();
        return positions;
    }

    const SamplePair& pair_;
    const Surface& part_;
    Pins pins_;
    const PartialTuning& tuning_;
    OneWayFit fit_;
};

void sort(std::vector<Runner>& runners) {
    std::stable_sort(runners.begin(), runners.end(),
                     [](const Runner& a, const Runner& b) { return a.total > b.total; });
}

bool ends_alike(const Runner& a, const Runner& b, const RaceTuning& tuning) {
    const double apart = (a.bent.positions - b.bent.positions).rowwise().norm().mean();
    return apart < tuning.same_place;
}

// The ways in which the race begins.
std::vector<Start> starts(const SamplePair& pair, const std::vector<Placement>& placements,
                          const PartialTuning& tuning, std::uint64_t seed, Stopwatch& watch,
                          const ProgressRange& progress) {
    std::vector<Start> found;
    for (const Placement& placement : placements) found.push_back({placement, {}});
    const std::vector<SampleMap> groups = consensus_maps(pair, tuning.consensus, seed, progress.part(0, 0.9));
    watch.lap("consensus");
    for (std::size_t i = 0; i < std::min(groups.size(), tuning.race.n_groups); ++i)
        found.push_back({{}, relabel(pair, groups[i], tuning.consensus, tuning.relabeling)});
    watch.lap("relabel");
    progress.reach(1);
    return found;
}

// All at once, in the order of the starts.
std::vector<Runner> all_run(const Track& track, const std::vector<Start>& starts,
                            const ProgressRange& progress) {
    std::vector<Runner> runners(starts.size());
    std::atomic<std::size_t> n_done = 0;
    parallel_for(starts.size(), 1, [&](std::size_t i) {
        runners[i] = track.run(starts[i]);
        progress.step(n_done++, starts.size()).reach(1);
    });
    return runners;
}

// The best runners that end in different places.
std::vector<Runner> raced(const SamplePair& pair, const Pins& pins, const std::vector<Start>& starts,
                          const CoarseSurface& coarse, const PartialTuning& tuning,
                          const ProgressRange& progress) {
    const RaceTuning& race = tuning.race;
    Pins coarse_pins = pins;
    for (auto& [v, w] : coarse_pins) v = coarse.coarse_of_fine[to_size(v)];
    const Track track(pair, coarse.surface, coarse_pins, tuning);
    std::vector<Runner> runners = all_run(track, starts, progress.part(0, 0.7));
    sort(runners);
    std::vector<Start> relabeled;
    for (std::size_t i = 0; i < std::min(race.n_relabeled, starts.size()); ++i)
        relabeled.push_back({{}, relabel(pair, runners[i].anchors, tuning.consensus, tuning.relabeling)});
    for (Runner& runner : all_run(track, relabeled, progress.part(0.7, 1)))
        runners.push_back(std::move(runner));
    sort(runners);
    std::vector<Runner> leaders;
    for (Runner& runner : runners) {
        if (leaders.size() == race.n_leaders) break;
        if (std::none_of(leaders.begin(), leaders.end(),
                         [&](const Runner& other) { return ends_alike(runner, other, race); }))
            leaders.push_back(std::move(runner));
    }
    return leaders;
}

// The leader on all vertices. SHOT is compared at the images themselves.
Fit judged(Runner runner, const SamplePair& pair, const MatrixF& of_part, const PartialTuning& tuning) {
    Fit fit{std::move(runner.anchors), std::move(runner.bent), {}, 0, 0, 0};
    std::vector<Index> images;
    for (const Index v : pair.source.samples) images.push_back(fit.bent.image[to_size(v)]);
    const MatrixF at_images = pair.target.signatures_of(images, std::array{tuning.judge_radius});
    double sum = 0, votes = 0;
    for (std::size_t i = 0; i < images.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        fit.alike.push_back(of_part.row(row).dot(at_images.row(row)));
        sum += fit.anchors.vote[i] * fit.alike.back();
        votes += fit.anchors.vote[i];
    }
    const Gain& gained = runner.gained;
    fit.score = votes > 0 ? sum / votes : 0;
    fit.agreement = gained.fits > 0 ? gained.fits / (gained.fits + gained.lacks) : 0;
    fit.total = gained.total + tuning.race.likeness * fit.score;
    return fit;
}

}  // namespace

std::vector<Fit> fits_of_parts(const SamplePair& pair, const std::vector<Placement>& placements,
                               const Pins& pins, const PartialTuning& tuning, std::uint64_t seed,
                               Stopwatch& watch, const ProgressRange& progress) {
    const std::vector<Start> begun = starts(pair, placements, tuning, seed, watch, progress.part(0, 0.2));
    const CoarseSurface coarse = coarsened(pair.source, tuning.race.n_vertices);
    std::vector<Runner> leaders = raced(pair, pins, begun, coarse, tuning, progress.part(0.2, 0.7));
    watch.lap("race");
    if (coarse.surface.mesh.n_vertices() < pair.source.mesh.n_vertices()) {
        std::vector<Start> again;
        for (Runner& leader : leaders) again.push_back(std::move(leader.start));
        leaders = all_run(Track(pair, pair.source, pins, tuning), again, progress.part(0.7, 1));
    }
    const MatrixF of_part = pair.source.signatures_of(pair.source.samples, std::array{tuning.judge_radius});
    std::vector<Fit> found;
    for (Runner& leader : leaders) found.push_back(judged(std::move(leader), pair, of_part, tuning));
    watch.lap("fit");
    std::stable_sort(found.begin(), found.end(),
                     [](const Fit& a, const Fit& b) { return a.total > b.total; });
    return found;
}

double scale_of_parts(const Surface& part, const Surface& whole, Index n_landmarks, double least, double most,
                      const PartialTuning& tuning) {
    const double step = tuning.part_scale.step;
    const auto count = static_cast<std::size_t>(std::ceil(std::log(most / least) / std::log(step))) + 1;
    std::vector<double> scales = {least};
    while (scales.size() < count) scales.push_back(scales.back() * step);
    return placements(part, whole, n_landmarks, scales, tuning.part_scale.placement).front().scale;
}

}  // namespace counterpart::partial_match
