// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/partial_growth.hpp"

#include "match/exact/growth.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace counterpart {
namespace {

double mean_length(const TriangleMesh& mesh) {
    double sum = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            sum +=
                (mesh.vertices.row(mesh.triangles(t, c)) - mesh.vertices.row(mesh.triangles(t, (c + 1) % 3)))
                    .norm();
    return sum / (3.0 * mesh.n_triangles());
}

struct FirstSeed {
    FlagPair seed;
    bool is_ambiguous = false;  // another one, which says otherwise, does nearly as well
};

// The seed to begin with: the one from which most of the mesh is reached in agreement. Where the mesh is
// regular, or nearly symmetric, and its rare spots are cut out, connectivity alone would begin anywhere.
// Tried in three rounds, ever fewer seeds grow ever further: by the shape of what is around them, of a
// thousand triangles, and of all. `enough`: the share of the mesh from which on no other is tried.
std::optional<FirstSeed> first_seed(const std::vector<FlagPair>& seeds, const Growth& growth, double enough,
                                    double least) {
    using Ranked = std::vector<std::pair<double, FlagPair>>;
    constexpr std::size_t region = 1000, everything = static_cast<std::size_t>(-1);
    const auto budget = [&](double triangles, double fewest, double most) {
        return static_cast<std::size_t>(std::clamp(triangles / (1 + growth.n_open()), fewest, most));
    };
    const auto best_first = [](Ranked& ranked) {
        std::stable_sort(ranked.begin(), ranked.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
    };
    Ranked near;
    for (const FlagPair& seed : seeds)
        if (const double trust = growth.trust(seed); trust > 0) near.emplace_back(trust, seed);
    best_first(near);

    Ranked reached;
    std::vector<Growth> tried;  // so that no seed is tried that one before it says already
    const auto grow = [&](const FlagPair& seed, std::size_t most) {
        Growth& trial = tried.emplace_back(growth);
        trial.plant(seed);
        trial.grow(least, most);
        return trial.total_agreement();
    };
    const auto is_said = [&](const FlagPair& seed) {
        return std::any_of(tried.begin(), tried.end(),
                           [&](const Growth& trial) { return trial.holds(seed); });
    };
    if (near.size() > 1 && growth.n_open() > 2 * region) {
        const std::size_t most_regions = budget(10'000'000, 10, 300);
        for (const auto& [trust, seed] : near) {
            if (tried.size() == most_regions) break;
            if (!is_said(seed)) reached.emplace_back(grow(seed, region), seed);
        }
        best_first(reached);
        tried.clear();
    } else {
        reached = near;
    }

    std::optional<FirstSeed> best;
    double most = 0;
    const std::size_t most_trials = budget(1'000'000, 4, 40);
    for (const auto& [agreement, seed] : reached) {
        if (tried.size() == most_trials) break;
        if (is_said(seed)) continue;
        const double all = grow(seed, everything);
        const bool is_close = std::min(all, most) > 0.85 * std::max(all, most);
        if (all > most)
            best = {seed, is_close};
        else if (is_close)
            best->is_ambiguous = true;
        most = std::max(most, all);
        if (most > enough * growth.n_open()) break;
    }
    return best;
}

// A few hundred, evenly spread.
std::vector<FlagPair> some_of(const std::vector<FlagPair>& seeds) {
    const std::size_t step = 1 + seeds.size() / 500;
    std::vector<FlagPair> some;
    for (std::size_t i = 0; i < seeds.size(); i += step) some.push_back(seeds[i]);
    return some;
}

// From what is unique in the widest surroundings first: the least likely to be so by accident of an edit.
// Returns whether another beginning would have done nearly as well.
bool grow_from_seeds(Growth& growth, const SeedColors& colors, unsigned parity) {
    // The sure ones, so that no region runs over an edit before its neighbours do; but where nothing is
    // unique, one region must reach all.
    constexpr double sure = 3, likely = 0.7;
    bool is_ambiguous = false;
    const auto plant = [&](const FlagPair& seed, double least) {
        if (!growth.is_open(seed) || growth.trust(seed) <= 0) return;
        growth.plant(seed);
        growth.grow(least);
    };
    const auto seeds = [&](std::size_t r) {
        return growth.seeds(colors.source[r], colors.target[r], parity);
    };
    for (const bool unique : {true, false}) {
        for (std::size_t r = colors.source.size(); r-- > 0 && growth.n_matched() == 0;) {
            const Seeds at = seeds(r);
            const double least = unique ? sure : likely;
            const auto seed =
                first_seed(some_of(unique ? at.unique : at.rare), growth, unique ? 0.5 : 0.95, least);
            if (!seed) continue;
            plant(seed->seed, least);
            is_ambiguous = seed->is_ambiguous;
        }
    }
    if (growth.n_matched() == 0) return false;
    for (std::size_t r = colors.source.size(); r-- > 0;)
        for (const FlagPair& seed : seeds(r).unique) plant(seed, sure);
    return is_ambiguous;
}

}  // namespace

PartialMatch grow_matching(const TriangleMesh& source_mesh, const TriangleMesh& target_mesh,
                           const CombinatorialMap& source, const CombinatorialMap& target,
                           const std::vector<std::pair<Flag, Flag>>& settled) {
    const SeedColors colors(source, target);
    PartialMatch best;
    Index best_matched = -1;
    for (unsigned parity = 0; parity < 2; ++parity) {
        LengthFit fit;
        const double length_a = mean_length(source_mesh), length_b = mean_length(target_mesh);
        if (length_a > 0 && length_b > 0) fit.scale = length_b / length_a;
        // The first pass measures how lengths compare. The others forget what lies around each difference
        // and close the gaps again, now with evidence from all sides.
        constexpr int passes = 4;
        PartialMatch match;
        std::size_t most = 0;
        std::vector<FlagPair> sound;
        bool is_ambiguous = false;
        for (int pass = 0; pass < passes; ++pass) {
            Growth growth(source_mesh, target_mesh, source, target, fit);
            growth.settle(settled);
            growth.resume(sound);
            if (pass < 2) is_ambiguous = grow_from_seeds(growth, colors, parity);
            for (const double least : {3.0, 0.7, 0.3}) growth.grow(least);
            fit = growth.measure_lengths();
            if (pass == 0) continue;
            sound = growth.sound();
            if (growth.n_matched() < most) continue;
            most = growth.n_matched();
            match = growth.result();
        }
        const auto matched = static_cast<Index>(
            std::count_if(match.image.begin(), match.image.end(), [](Index w) { return w >= 0; }));
        match.turned = parity == 1;
        match.ambiguous = is_ambiguous;
        if (matched > best_matched) {
            best = std::move(match);
            best_matched = matched;
        }
        // The other way round is worth a try only if this one found little.
        if (2 * best_matched > std::min(source.n_vertices(), target.n_vertices())) break;
    }
    return best;
}

}  // namespace counterpart
