// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/isomorphism/component_classes.hpp"

#include "base/hash_mixing.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <optional>

namespace counterpart::isomorphism {
namespace {

struct Named {
    Color signature;
    Index component;
    bool in_target;
};

// Sums over the triangles, so that neither order nor winding matters.
void add_signatures(const DartMap& map, const std::vector<Color>& colors, bool in_target,
                    std::vector<Named>& names) {
    for (Index i = 0; i < map.n_components(); ++i) {
        const auto begin = 3 * to_size(map.component_begin[to_size(i)]);
        const auto end = 3 * to_size(map.component_begin[to_size(i) + 1]);
        Color signature = finalized(end - begin);
        for (std::size_t h = begin; h < end; ++h) signature += colors[to_size(map.corner[h])];
        names.push_back({signature, i, in_target});
    }
}

// A dart that leaves a vertex of the rarest color.
Dart rarest_dart(const DartMap& map, const std::vector<Color>& colors, Index component) {
    const auto begin = to_size(map.component_begin[to_size(component)]),
               size = to_size(map.component_size(component));
    // Counted by the low bits of the color: a collision can only make a rare color look less rare.
    const std::size_t n_counters = std::min<std::size_t>(std::bit_ceil(6 * size), 1U << 16U);
    std::vector<std::uint32_t> counts(n_counters, 0);
    const auto slot = [&](std::size_t h) {
        return to_size(colors[to_size(map.corner[h])]) & (n_counters - 1);
    };
    for (std::size_t h = 3 * begin; h < 3 * (begin + size); ++h) ++counts[slot(h)];
    std::size_t rarest = 3 * begin;
    for (std::size_t h = 3 * begin; h < 3 * (begin + size); ++h)
        if (counts[slot(h)] < counts[slot(rarest)]) rarest = h;
    const auto t = static_cast<Index>(rarest / 3);
    const int c = static_cast<int>(rarest % 3);
    const Dart forward = make_dart(t, c);
    return map.parity(forward) == 0 ? forward : make_dart(t, c == 0 ? 2 : c - 1, 1);
}

class Classifier {
  public:
    Classifier(const DartMap& source, const DartMap& target, int rounds, std::size_t budget)
        : maps_{&source, &target},
          traversals_{SimultaneousTraversal(source, source), SimultaneousTraversal(source, target),
                      SimultaneousTraversal(target, target)},
          budget_(budget) {
        parallel_invoke([&] { result_.source_colors = vertex_colors(source, rounds); },
                        [&] { result_.target_colors = vertex_colors(target, rounds); });
    }

    // Nothing if too many traversals failed: the colors are too coarse.
    std::optional<Classification> run() {
        std::vector<Named> names;
        add_signatures(*maps_[0], result_.source_colors, false, names);
        add_signatures(*maps_[1], result_.target_colors, true, names);
        // The source's components come first within a signature: one of them represents the class.
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
        const DartMap& map = *maps_[named.in_target];
        for (std::size_t k = first_class; k < result_.classes.size(); ++k) {
            ComponentClass& kind = result_.classes[k];
            if (maps_[kind.in_target]->component_size(kind.component) != map.component_size(named.component))
                continue;
            SimultaneousTraversal& traversal =
                traversals_[(kind.in_target ? 1U : 0U) + (named.in_target ? 1U : 0U)];
            const DartsByParity darts = darts_like(*maps_[kind.in_target], colors(kind.in_target), kind.root,
                                                   map, colors(named.in_target), named.component);
            for (unsigned parity = 0; parity < 2; ++parity) {
                for (const Dart f : darts[parity]) {
                    const std::size_t before = traversal.steps();
                    Images images = traversal.run(kind.component, kind.root, f);
                    if (!images.empty()) {
                        (named.in_target ? kind.target : kind.source)
                            .push_back({named.component, std::move(images), parity});
                        return true;
                    }
                    wasted_ += traversal.steps() - before;
                    if (wasted_ > budget_) return true;
                }
            }
        }
        return false;
    }

    void found(const Named& named) {
        const DartMap& map = *maps_[named.in_target];
        const auto begin = map.component_begin[to_size(named.component)];
        Images identity(to_size(map.component_size(named.component)));
        for (std::size_t k = 0; k < identity.size(); ++k)
            identity[k] = make_dart(begin + static_cast<Index>(k), 0);
        ComponentClass kind;
        kind.in_target = named.in_target;
        kind.component = named.component;
        kind.first = begin;
        kind.root = rarest_dart(map, colors(named.in_target), named.component);
        (named.in_target ? kind.target : kind.source).push_back({named.component, std::move(identity), 0});
        result_.classes.push_back(std::move(kind));
    }

    std::array<const DartMap*, 2> maps_;
    std::array<SimultaneousTraversal, 3> traversals_;
    Classification result_;
    std::size_t budget_, wasted_ = 0;
};

}  // namespace

Classification classify_components(const DartMap& source, const DartMap& target) {
    // Few rounds tell nearly all meshes apart. More are worth their time only where traversals fail late, and
    // beyond the last budget traversals are what decides.
    const auto n = to_size(source.n_triangles() + target.n_triangles());
    for (const int rounds : {2, 8, 32, 128})
        if (auto result = Classifier(source, target, rounds, 10 * n + 100'000).run())
            return std::move(*result);
    return std::move(*Classifier(source, target, 128, std::numeric_limits<std::size_t>::max()).run());
}

}  // namespace counterpart::isomorphism
