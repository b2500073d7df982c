// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/seeding.hpp"

#include <algorithm>
#include <unordered_map>

namespace counterpart {
namespace {

// Flags gone along with their island's winding (or against it) by colour.
std::vector<std::pair<Color, Flag>> colored_flags(const OpenPart& part, unsigned parity) {
    const CombinatorialMap& map = part.map;
    std::vector<std::pair<Color, Flag>> flags;
    for (Index t = 0; t < map.n_triangles(); ++t) {
        if (part.done[static_cast<std::size_t>(t)]) continue;
        for (int c = 0; c < 3; ++c) {
            const Flag f = make_flag(t, c, map.parity(make_flag(t, c)) ^ parity);
            flags.emplace_back(flag_color(map, part.colors, f), f);
        }
    }
    std::sort(flags.begin(), flags.end());
    return flags;
}

}  // namespace

SeedColors::SeedColors(const CombinatorialMap& a, const CombinatorialMap& b) {
    const auto each_radius = [](const CombinatorialMap& map) {
        std::vector<std::vector<Color>> colors{vertex_colors(map, 2)};
        for (const int rounds : {2, 4, 8, 16}) colors.push_back(refined_colors(map, colors.back(), rounds));
        return colors;
    };
    source = each_radius(a);
    target = each_radius(b);
}

Seeds find_seeds(const OpenPart& source, const OpenPart& target, unsigned parity) {
    constexpr std::size_t most_rare = 2000;
    struct Group {
        std::size_t i, i_end, j, j_end;
        std::size_t ways() const { return (i_end - i) * (j_end - j); }
    };
    const auto in_a = colored_flags(source, 0);
    const auto in_b = colored_flags(target, parity);
    Seeds seeds;
    std::vector<Group> groups;
    for (std::size_t i = 0, j = 0; i < in_a.size() && j < in_b.size();) {
        const Color color = std::max(in_a[i].first, in_b[j].first);
        while (i < in_a.size() && in_a[i].first < color) ++i;
        while (j < in_b.size() && in_b[j].first < color) ++j;
        if (i == in_a.size() || j == in_b.size()) break;
        if (in_a[i].first != in_b[j].first) continue;
        Group group{i, i, j, j};
        while (group.i_end < in_a.size() && in_a[group.i_end].first == in_a[i].first) ++group.i_end;
        while (group.j_end < in_b.size() && in_b[group.j_end].first == in_a[i].first) ++group.j_end;
        if (group.ways() == 1)
            seeds.unique.emplace_back(in_a[i].second, in_b[j].second);
        else if (group.ways() <= most_rare)
            groups.push_back(group);
        i = group.i_end;
        j = group.j_end;
    }
    std::stable_sort(groups.begin(), groups.end(),
                     [](const Group& x, const Group& y) { return x.ways() < y.ways(); });
    for (const Group& group : groups) {
        if (seeds.rare.size() + group.ways() > most_rare) break;
        for (std::size_t i = group.i; i < group.i_end; ++i)
            for (std::size_t j = group.j; j < group.j_end; ++j)
                seeds.rare.emplace_back(in_a[i].second, in_b[j].second);
    }
    return seeds;
}

std::vector<FlagPair> surroundings(const CombinatorialMap& a, const CombinatorialMap& b, FlagPair seed) {
    constexpr std::size_t enough = 40;
    std::unordered_map<Index, Index> image, origin,
        triangles{{triangle_of(seed.first), triangle_of(seed.second)}};
    std::vector<FlagPair> queue{seed};
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
            const Flag over_f = a.across(f0), over_g = b.across(g0);
            if (over_f == no_flag && over_g == no_flag) continue;
            if (over_f == no_flag || over_g == no_flag) {
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
    if (!whole && (queue.size() < enough / 2 || earned < 3 * disagree || earned < 10)) return {};
    return queue;
}

}  // namespace counterpart
