// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/automorphisms.hpp"

namespace counterpart {

std::vector<Flag> flags_like(const CombinatorialMap& root_map, const std::vector<Color>& root_colors,
                             Flag root, const CombinatorialMap& map, const std::vector<Color>& colors,
                             Index island, unsigned parity) {
    std::vector<Flag> flags;
    const bool one_sided = map.is_one_sided(island);
    if (one_sided && parity == 1) return flags;
    const Color origin = root_colors[static_cast<std::size_t>(root_map.origin(root))];
    const Color color = flag_color(root_map, root_colors, root);
    const Index begin = map.island_begin[static_cast<std::size_t>(island)],
                end = begin + map.island_size(island);
    for (Index t = begin; t < end; ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index v = map.corner[3 * static_cast<std::size_t>(t) + static_cast<std::size_t>(c)];
            if (colors[static_cast<std::size_t>(v)] != origin) continue;
            // The two flags that leave this corner.
            const Flag forward = make_flag(t, c), backward = make_flag(t, c == 0 ? 2 : c - 1, 1);
            for (const Flag f : {forward, backward})
                if ((one_sided || map.parity(f) == parity) && flag_color(map, colors, f) == color)
                    flags.push_back(f);
        }
    }
    return flags;
}

namespace {

AutomorphismGroup trivial_group(Flag root) {
    AutomorphismGroup group;
    group.orbit = {root};
    group.parent = group.generator = {0};
    return group;
}

class Search {
  public:
    Search(const CombinatorialMap& map, Index island, Flag root)
        : walker_(map, map),
          island_(island),
          root_(root),
          first_(map.island_begin[static_cast<std::size_t>(island)]),
          size_(static_cast<std::size_t>(map.island_size(island))) {
        group_ = trivial_group(root);
        good_.assign(6 * size_, 0);
        bad_.assign(6 * size_, 0);
        good_[place(root)] = 1;
    }

    AutomorphismGroup run(const std::vector<Flag>& even, const std::vector<Flag>& odd) {
        for (const Flag f : even) {
            if (good_[place(f)] || bad_[place(f)]) continue;
            if (exhausted()) break;
            Images images = walker_.walk(island_, root_, f);
            if (images.empty()) {
                rule_out(f);
            } else {
                group_.generators.push_back(std::move(images));
                rebuild_orbit();
                for (std::size_t i = 0, n = failed_.size(); i < n; ++i) rule_out_orbit(failed_[i]);
            }
        }
        for (const Flag f : odd) {
            if (bad_[place(f)]) continue;
            if (exhausted()) break;
            group_.mirror = walker_.walk(island_, root_, f);
            if (!group_.mirror.empty()) break;
            rule_out(f);
        }
        return std::move(group_);
    }

  private:
    std::size_t place(Flag f) const {
        return 2 * (halfedge_of(f) - 3 * static_cast<std::size_t>(first_)) + (f & 1U);
    }

    // Only adversarial maps come near: failing walks are either short or rule out large cosets.
    bool exhausted() {
        if (walker_.steps() > 300 * size_ + 1'000'000) group_.complete = false;
        return !group_.complete;
    }

    void rebuild_orbit() {
        std::vector<Flag>& orbit = group_.orbit;
        std::fill(good_.begin(), good_.end(), 0);
        good_[place(root_)] = 1;
        orbit = {root_};
        group_.parent = group_.generator = {0};
        for (std::size_t i = 0; i < orbit.size(); ++i) {
            for (std::size_t g = 0; g < group_.generators.size(); ++g) {
                const Flag f = image_of(group_.generators[g], first_, orbit[i]);
                if (good_[place(f)]) continue;
                good_[place(f)] = 1;
                orbit.push_back(f);
                group_.parent.push_back(static_cast<std::uint32_t>(i));
                group_.generator.push_back(static_cast<std::uint32_t>(g));
            }
        }
    }

    // If no automorphism takes the root to f, none takes it to the image of f under a known one.
    void rule_out(Flag f) {
        failed_.push_back(f);
        rule_out_orbit(f);
    }
    void rule_out_orbit(Flag f) {
        std::vector<Flag> queue{f};
        bad_[place(f)] = 2;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            for (const Images& generator : group_.generators) {
                const Flag g = image_of(generator, first_, queue[i]);
                if (bad_[place(g)] == 2) continue;
                bad_[place(g)] = 2;
                queue.push_back(g);
            }
        }
        for (const Flag g : queue) bad_[place(g)] = 1;
    }

    Walker walker_;
    Index island_;
    Flag root_;
    Index first_;
    std::size_t size_;
    AutomorphismGroup group_;
    std::vector<std::uint8_t> good_, bad_;
    std::vector<Flag> failed_;
};

}  // namespace

AutomorphismGroup find_automorphisms(const CombinatorialMap& map, const std::vector<Color>& colors,
                                     Index island, Flag root) {
    const std::vector<Flag> even = flags_like(map, colors, root, map, colors, island, 0),
                            odd = flags_like(map, colors, root, map, colors, island, 1);
    if (even.size() == 1 && odd.empty()) return trivial_group(root);
    return Search(map, island, root).run(even, odd);
}

}  // namespace counterpart
