// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/island_classes.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>

namespace counterpart {
namespace {

struct Named {
    Color signature;
    Index island;
    bool in_target;
};

// Sums over the triangles, so that neither order nor winding matters.
void add_signatures(const CombinatorialMap& map, const std::vector<Color>& colors, bool in_target,
                    std::vector<Named>& names) {
    for (Index i = 0; i < map.n_islands(); ++i) {
        const auto begin = 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(i)]);
        const auto end = 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(i) + 1]);
        Color signature = mix(end - begin);
        for (std::size_t h = begin; h < end; ++h)
            signature += colors[static_cast<std::size_t>(map.corner[h])];
        names.push_back({signature, i, in_target});
    }
}

// A flag that leaves a vertex of the rarest colour.
Flag rarest_flag(const CombinatorialMap& map, const std::vector<Color>& colors, Index island) {
    const auto begin = static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(island)]),
               size = static_cast<std::size_t>(map.island_size(island));
    // Counted by the low bits of the colour: a collision can only make a rare colour look less rare.
    const std::size_t n_counters = std::min<std::size_t>(std::bit_ceil(6 * size), 1U << 16U);
    std::vector<std::uint32_t> counts(n_counters, 0);
    const auto slot = [&](std::size_t h) {
        return static_cast<std::size_t>(colors[static_cast<std::size_t>(map.corner[h])]) & (n_counters - 1);
    };
    for (std::size_t h = 3 * begin; h < 3 * (begin + size); ++h) ++counts[slot(h)];
    std::size_t rarest = 3 * begin;
    for (std::size_t h = 3 * begin; h < 3 * (begin + size); ++h)
        if (counts[slot(h)] < counts[slot(rarest)]) rarest = h;
    const auto t = static_cast<Index>(rarest / 3);
    const int c = static_cast<int>(rarest % 3);
    const Flag forward = make_flag(t, c);
    return map.parity(forward) == 0 ? forward : make_flag(t, c == 0 ? 2 : c - 1, 1);
}

class Classifier {
  public:
    Classifier(const CombinatorialMap& source, const CombinatorialMap& target, int rounds, std::size_t budget)
        : maps_{&source, &target},
          walkers_{Walker(source, source), Walker(source, target), Walker(target, target)},
          budget_(budget) {
        result_.source_colors = vertex_colors(source, rounds);
        result_.target_colors = vertex_colors(target, rounds);
    }

    // Nothing if too many walks failed: the colours are too coarse.
    std::optional<Classification> run() {
        std::vector<Named> names;
        add_signatures(*maps_[0], result_.source_colors, false, names);
        add_signatures(*maps_[1], result_.target_colors, true, names);
        // The source's islands come first within a signature: one of them represents the class.
        std::stable_sort(names.begin(), names.end(),
                         [](const Named& a, const Named& b) { return a.signature < b.signature; });
        std::size_t first_class = 0;
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (i == 0 || names[i].signature != names[i - 1].signature) first_class = result_.classes.size();
            if (!join(names[i], first_class)) found(names[i]);
            if (wasted_ > budget_) return std::nullopt;
        }
        return std::move(result_);
    }

  private:
    const std::vector<Color>& colors(bool in_target) const {
        return in_target ? result_.target_colors : result_.source_colors;
    }

    bool join(const Named& named, std::size_t first_class) {
        const CombinatorialMap& map = *maps_[named.in_target];
        for (std::size_t k = first_class; k < result_.classes.size(); ++k) {
            IslandClass& kind = result_.classes[k];
            if (maps_[kind.in_target]->island_size(kind.island) != map.island_size(named.island)) continue;
            Walker& walker = walkers_[(kind.in_target ? 1U : 0U) + (named.in_target ? 1U : 0U)];
            for (unsigned parity = 0; parity < 2; ++parity) {
                for (const Flag f : flags_like(*maps_[kind.in_target], colors(kind.in_target), kind.root, map,
                                               colors(named.in_target), named.island, parity)) {
                    const std::size_t before = walker.steps();
                    Images images = walker.walk(kind.island, kind.root, f);
                    if (!images.empty()) {
                        (named.in_target ? kind.target : kind.source)
                            .push_back({named.island, std::move(images), parity});
                        return true;
                    }
                    wasted_ += walker.steps() - before;
                    if (wasted_ > budget_) return true;
                }
            }
        }
        return false;
    }

    void found(const Named& named) {
        const CombinatorialMap& map = *maps_[named.in_target];
        const auto begin = map.island_begin[static_cast<std::size_t>(named.island)];
        Images identity(static_cast<std::size_t>(map.island_size(named.island)));
        for (std::size_t k = 0; k < identity.size(); ++k)
            identity[k] = make_flag(begin + static_cast<Index>(k), 0);
        IslandClass kind;
        kind.in_target = named.in_target;
        kind.island = named.island;
        kind.root = rarest_flag(map, colors(named.in_target), named.island);
        (named.in_target ? kind.target : kind.source).push_back({named.island, std::move(identity), 0});
        result_.classes.push_back(std::move(kind));
    }

    std::array<const CombinatorialMap*, 2> maps_;
    std::array<Walker, 3> walkers_;
    Classification result_;
    std::size_t budget_, wasted_ = 0;
};

}  // namespace

Classification classify_islands(const CombinatorialMap& source, const CombinatorialMap& target) {
    // Few rounds tell nearly all meshes apart. More are worth their time only where walks fail late, and
    // beyond the last budget walks are what decides.
    const auto n = static_cast<std::size_t>(source.n_triangles() + target.n_triangles());
    for (const int rounds : {2, 8, 32, 128})
        if (auto result = Classifier(source, target, rounds, 10 * n + 100'000).run())
            return std::move(*result);
    return std::move(*Classifier(source, target, 128, std::numeric_limits<std::size_t>::max()).run());
}

}  // namespace counterpart
