// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/isomorphism/automorphisms.hpp"

namespace counterpart::isomorphism {

DartsByParity darts_like(const DartMap& root_map, const std::vector<Color>& root_colors, Dart root,
                         const DartMap& map, const std::vector<Color>& colors, Index component) {
    DartsByParity darts;
    const bool one_sided = map.is_one_sided(component);
    const Color origin = root_colors[to_size(root_map.origin(root))];
    const Color color = dart_color(root_map, root_colors, root);
    const auto begin = 3 * to_size(map.component_begin[to_size(component)]),
               end = 3 * to_size(map.component_begin[to_size(component) + 1]);
    for (std::size_t h = begin; h < end; ++h) {
        if (colors[to_size(map.corner[h])] != origin) continue;
        // The two darts that leave this corner.
        const auto t = static_cast<Index>(h / 3);
        const int c = static_cast<int>(h % 3);
        for (const Dart f : {make_dart(t, c), make_dart(t, c == 0 ? 2 : c - 1, 1)})
            if (dart_color(map, colors, f) == color) darts[one_sided ? 0 : map.parity(f)].push_back(f);
    }
    return darts;
}

namespace {

AutomorphismGroup trivial_group(Dart root) {
    AutomorphismGroup group;
    group.orbit = {root};
    group.parent = group.generator = {0};
    return group;
}

class Search {
  public:
    Search(const DartMap& map, Index component, Dart root)
        : traversal_(map, map),
          component_(component),
          root_(root),
          first_(map.component_begin[to_size(component)]),
          size_(to_size(map.component_size(component))) {
        group_ = trivial_group(root);
        good_.assign(6 * size_, 0);
        bad_.assign(6 * size_, 0);
        good_[place(root)] = 1;
    }

    AutomorphismGroup run(const std::vector<Dart>& even, const std::vector<Dart>& odd) {
        for (const Dart f : even) {
            if (good_[place(f)] || bad_[place(f)]) continue;
            Images images = traversal_.run(component_, root_, f);
            if (images.empty()) {
                rule_out(f);
            } else {
                group_.generators.push_back(std::move(images));
                rebuild_orbit();
                for (std::size_t i = 0, n = failed_.size(); i < n; ++i) rule_out_orbit(failed_[i]);
            }
        }
        for (const Dart f : odd) {
            if (bad_[place(f)]) continue;
            group_.mirror = traversal_.run(component_, root_, f);
            if (!group_.mirror.empty()) break;
            rule_out(f);
        }
        return std::move(group_);
    }

  private:
    std::size_t place(Dart f) const { return 2 * (halfedge_of(f) - 3 * to_size(first_)) + (f & 1U); }

    void rebuild_orbit() {
        std::vector<Dart>& orbit = group_.orbit;
        std::fill(good_.begin(), good_.end(), 0);
        good_[place(root_)] = 1;
        orbit = {root_};
        group_.parent = group_.generator = {0};
        for (std::size_t i = 0; i < orbit.size(); ++i) {
            for (std::size_t g = 0; g < group_.generators.size(); ++g) {
                const Dart f = image_of(group_.generators[g], first_, orbit[i]);
                if (good_[place(f)]) continue;
                good_[place(f)] = 1;
                orbit.push_back(f);
                group_.parent.push_back(static_cast<std::uint32_t>(i));
                group_.generator.push_back(static_cast<std::uint32_t>(g));
            }
        }
    }

    // If no automorphism takes the root to f, none takes it to the image of f under a known one.
    void rule_out(Dart f) {
        failed_.push_back(f);
        rule_out_orbit(f);
    }
    void rule_out_orbit(Dart f) {
        std::vector<Dart> queue{f};
        bad_[place(f)] = 2;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            for (const Images& generator : group_.generators) {
                const Dart g = image_of(generator, first_, queue[i]);
                if (bad_[place(g)] == 2) continue;
                bad_[place(g)] = 2;
                queue.push_back(g);
            }
        }
        for (const Dart g : queue) bad_[place(g)] = 1;
    }

    SimultaneousTraversal traversal_;
    Index component_;
    Dart root_;
    Index first_;
    std::size_t size_;
    AutomorphismGroup group_;
    std::vector<std::uint8_t> good_, bad_;
    std::vector<Dart> failed_;
};

}  // namespace

AutomorphismGroup find_automorphisms(const DartMap& map, const std::vector<Color>& colors, Index component,
                                     Dart root) {
    const auto [even, odd] = darts_like(map, colors, root, map, colors, component);
    if (even.size() == 1 && odd.empty()) return trivial_group(root);
    return Search(map, component, root).run(even, odd);
}

}  // namespace counterpart::isomorphism
