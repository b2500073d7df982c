// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/seeding.hpp"

#include "base/hash_mixing.hpp"
#include "match/differences/tuning.hpp"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace counterpart::differences {

using namespace isomorphism;

namespace {

// Open darts in their component's winding (or against it) by color; `mask` picks colors alike in both meshes.
std::vector<std::pair<Color, Dart>> colored_darts(const OpenPart& part, unsigned parity, Color mask) {
    const DartMap& map = part.map;
    std::vector<std::pair<Color, Dart>> darts;
    for (Index t = 0; t < map.n_triangles(); ++t) {
        if (part.done[to_size(t)]) continue;
        for (int c = 0; c < 3; ++c) {
            const Dart d = make_dart(t, c, map.parity(make_dart(t, c)) ^ parity);
            const Color color = finalized(dart_color(map, part.colors, d));
            if ((color & mask) == 0) darts.emplace_back(color, d);
        }
    }
    std::sort(darts.begin(), darts.end());
    return darts;
}

// Darts i .. i_end of the source and j .. j_end of the target have one color.
struct Group {
    std::size_t i, i_end, j, j_end;
    std::size_t n_ways() const { return (i_end - i) * (j_end - j); }
};

}  // namespace

std::vector<DartPair> find_seeds(const OpenPart& source, const OpenPart& target, unsigned parity, bool shared,
                                 std::size_t max_darts) {
    const auto n_open = 3 * to_size(std::count(source.done.begin(), source.done.end(), false));
    const Color mask = std::bit_ceil(1 + n_open / max_darts) - 1;
    const auto in_a = colored_darts(source, 0, mask), in_b = colored_darts(target, parity, mask);
    std::vector<Group> groups;
    for (std::size_t i = 0, j = 0; i < in_a.size() && j < in_b.size();) {
        const Color color = in_a[i].first;
        Group group{i, i, j, j};
        while (group.i_end < in_a.size() && in_a[group.i_end].first == color) ++group.i_end;
        while (j < in_b.size() && in_b[j].first < color) ++j;
        group.j = group.j_end = j;
        while (group.j_end < in_b.size() && in_b[group.j_end].first == color) ++group.j_end;
        if (group.n_ways() > 0 && (shared || group.n_ways() == 1)) groups.push_back(group);
        i = group.i_end;
        j = group.j_end;
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const Group& x, const Group& y) { return x.n_ways() < y.n_ways(); });
    std::vector<DartPair> seeds;
    for (const Group& group : groups) {
        if (shared && seeds.size() + group.n_ways() > tuning.max_rare) break;
        for (std::size_t i = group.i; i < group.i_end; ++i)
            for (std::size_t j = group.j; j < group.j_end; ++j)
                seeds.emplace_back(in_a[i].second, in_b[j].second);
    }
    return seeds;
}

std::vector<DartPair> surroundings(const DartMap& a, const DartMap& b, DartPair seed) {
    const std::size_t enough = tuning.surroundings;
    std::unordered_map<Index, Index> image, origin,
        triangles{{triangle_of(seed.first), triangle_of(seed.second)}};
    std::vector<DartPair> queue{seed};
    int agree = 0, disagree = 0;
    const auto consistent = [&](Index v, Index w) {
        const auto [to, new_v] = image.try_emplace(v, w);
        const auto [from, new_w] = origin.try_emplace(w, v);
        return to->second == w && from->second == v;
    };
    auto [f, g] = seed;
    for (int c = 0; c < 3; ++c, f = next(f), g = next(g)) consistent(a.origin(f), b.origin(g));
    for (std::size_t k = 0; k < queue.size(); ++k) {
        auto [f0, g0] = queue[k];
        for (int side = 0; side < 3; ++side, f0 = next(f0), g0 = next(g0)) {
            const Dart over_f = a.across(f0), over_g = b.across(g0);
            if (over_f == no_dart && over_g == no_dart) continue;
            if (over_f == no_dart || over_g == no_dart) {
                ++disagree;
                continue;
            }
            const auto known = triangles.find(triangle_of(over_f));
            if (known != triangles.end()) {
                ++(known->second == triangle_of(over_g) ? agree : disagree);
                continue;
            }
            if (queue.size() >= enough) continue;
            const Index v = a.apex(over_f), w = b.apex(over_g);
            const bool met = image.contains(v) || origin.contains(w);
            if (!consistent(v, w)) {
                ++disagree;
                continue;
            }
            if (met) agree += 2;
            triangles.emplace(triangle_of(over_f), triangle_of(over_g));
            queue.emplace_back(over_f, over_g);
        }
    }
    // Every step looks back over the edge it came by; that much agreement is free.
    const int earned = agree - static_cast<int>(queue.size() - 1);
    const bool whole = queue.size() < enough && disagree == 0 && queue.size() >= 4;
    if (!whole &&
        (queue.size() < enough / 2 || earned < 3 * disagree || 4 * earned < static_cast<int>(enough)))
        return {};
    return queue;
}

}  // namespace counterpart::differences
