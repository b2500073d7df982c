// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/anchoring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace counterpart {
namespace {

using Centers = std::vector<Eigen::RowVector3d>;
struct ClassCenters {
    Centers source, target;
};

bool is_shared(const IslandClass& kind) { return !kind.source.empty() && !kind.target.empty(); }

Eigen::RowVector3d mean(const std::vector<PointPair>& points, Eigen::RowVector3d PointPair::*side) {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const PointPair& point : points) sum += point.*side;
    return sum / static_cast<double>(points.size());
}

ClassCenters centers_of(const IslandClass& kind, const PairGeometry& geometry) {
    ClassCenters centers;
    for (const Member& member : kind.source)
        centers.source.push_back(
            mean(geometry.points({&kind, &member, &kind.target[0], {}}, 64), &PointPair::source));
    for (const Member& member : kind.target)
        centers.target.push_back(
            mean(geometry.points({&kind, &kind.source[0], &member, {}}, 64), &PointPair::target));
    return centers;
}

// The sum of squared distances from moved centres to the closest of their kind, over some of the islands.
double strangeness(const std::vector<ClassCenters>& classes, std::size_t step, const Motion& motion) {
    double sum = 0;
    std::size_t i = 0;
    for (const ClassCenters& kind : classes) {
        for (const Eigen::RowVector3d& center : kind.source) {
            if (i++ % step != 0) continue;
            const Eigen::RowVector3d moved = motion(center);
            double closest = std::numeric_limits<double>::infinity();
            for (const Eigen::RowVector3d& other : kind.target)
                closest = std::min(closest, (moved - other).squaredNorm());
            sum += closest;
        }
    }
    return sum;
}

struct Start {
    Motion motion;
    double lengths, strangeness;
};

}  // namespace

std::vector<Motion> starting_motions(const MatchedMaps& maps, const PairGeometry& geometry, bool turned,
                                     std::size_t most) {
    constexpr std::size_t most_looked_at = 32, most_tried = 4096, most_comparisons = 20'000'000;
    const IslandClass* anchor = nullptr;
    std::size_t fewest = 0, n_islands = 0;
    const auto group_of = [&](const IslandClass& kind) -> const AutomorphismGroup& {
        return maps.groups[static_cast<std::size_t>(&kind - maps.classes.data())];
    };
    for (const IslandClass& kind : maps.classes) {
        if (!is_shared(kind)) continue;
        n_islands += kind.source.size();
        const std::size_t choices = kind.target.size() * group_of(kind).order();
        if (anchor != nullptr && choices >= fewest) continue;
        anchor = &kind;
        fewest = choices;
    }
    if (anchor == nullptr || n_islands < 2 || fewest > most_tried) return {};

    std::vector<ClassCenters> classes;
    std::size_t n_targets = 0;
    for (const IslandClass& kind : maps.classes) {
        if (!is_shared(kind)) continue;
        classes.push_back(centers_of(kind, geometry));
        n_targets = std::max(n_targets, kind.target.size());
    }
    const std::size_t step = (n_islands + most_looked_at - 1) / most_looked_at;
    if (fewest * most_looked_at * n_targets > most_comparisons) return {};

    const bool mirror = turned && !group_of(*anchor).mirror.empty();
    const bool exchange = turned && !mirror && !maps.source.is_one_sided(anchor->island);
    std::vector<Start> starts;
    for (const Member& target : anchor->target) {
        IslandPair pair{anchor, &anchor->source[0], &target, {}};
        if (((pair.source->parity ^ target.parity) != 0) != exchange) continue;
        for (Images& images :
             rank_automorphisms(maps, group_of(*anchor), geometry, pair, mirror, nullptr, fewest)) {
            pair.automorphism = std::move(images);
            const Motion motion = fit_similarity(geometry.points(pair, 200), turned);
            starts.push_back(
                {motion, geometry.length_disagreement(pair, 200), strangeness(classes, step, motion)});
        }
    }
    if (starts.empty()) return {};
    const double least = std::min_element(starts.begin(), starts.end(), [](const Start& a, const Start& b) {
                             return a.lengths < b.lengths;
                         })->lengths;
    // Generous: in another pose equal islands keep their lengths only nearly.
    const double limit = 4 * least + std::pow(1e-5 * geometry.mean_length(), 2);
    std::erase_if(starts, [&](const Start& start) { return start.lengths > limit; });
    std::stable_sort(starts.begin(), starts.end(),
                     [](const Start& a, const Start& b) { return a.strangeness < b.strangeness; });
    if (starts.size() > most) starts.resize(most);
    std::vector<Motion> motions;
    for (const Start& start : starts) motions.push_back(start.motion);
    return motions;
}

}  // namespace counterpart
