// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/walk.hpp"

namespace counterpart {

std::vector<Color> vertex_colors(const CombinatorialMap& map, int rounds) {
    const auto n = static_cast<std::size_t>(map.n_vertices());
    const std::size_t n_corners = map.corner.size();
    std::vector<Color> colors(n, 0);
    for (std::size_t h = 0; h < n_corners; ++h) {
        const auto v = static_cast<std::size_t>(map.corner[h]);
        colors[v] += 1;
        if (map.twin[h] != no_flag) continue;
        colors[v] += 1U << 16U;  // both ends of a border, alike in both directions
        colors[static_cast<std::size_t>(map.corner[h % 3 == 2 ? h - 2 : h + 1])] += 1U << 16U;
    }
    for (Color& color : colors) color = mix(color);
    return refined_colors(map, std::move(colors), rounds);
}

std::vector<Color> refined_colors(const CombinatorialMap& map, std::vector<Color> colors, int rounds) {
    const std::size_t n = colors.size(), n_corners = map.corner.size();
    std::vector<Color> sums(n);
    for (int round = 0; round < rounds; ++round) {
        sums.assign(n, 0);
        for (std::size_t h = 0; h < n_corners; h += 3) {
            const auto u = static_cast<std::size_t>(map.corner[h]),
                       v = static_cast<std::size_t>(map.corner[h + 1]),
                       w = static_cast<std::size_t>(map.corner[h + 2]);
            const Color triangle = mix(colors[u] + colors[v] + colors[w]);
            sums[u] += triangle;
            sums[v] += triangle;
            sums[w] += triangle;
        }
        for (std::size_t v = 0; v < n; ++v) colors[v] = mix(3 * colors[v] + sums[v]);
    }
    return colors;
}

// From the image of a flag to that of corner 0, direction 0 of its triangle.
static Flag image_of_first(Flag flag, Flag image) {
    const Flag corner = corner_of(flag);
    return next(image ^ direction_of(flag), corner == 0 ? 0 : 3 - corner);
}

Images Walker::walk(Index island_a, Flag root_a, Flag root_b) {
    const Index first = a_.island_begin[static_cast<std::size_t>(island_a)];
    const auto size = static_cast<std::size_t>(a_.island_size(island_a));
    if (images_.size() < size) {
        images_.resize(size, no_flag);
        queue_.resize(size + 1);  // a step writes to the place behind the last, whether or not it stays
    }
    images_[static_cast<std::size_t>(triangle_of(root_a) - first)] = image_of_first(root_a, root_b);
    queue_[0] = triangle_of(root_a);
    visited_ = 1;

    const bool agree = extend(first) && visited_ == size && vertices_agree(first, a_.island_size(island_a));
    steps_ += visited_;
    Images result;
    if (agree) result.assign(images_.begin(), images_.begin() + static_cast<std::ptrdiff_t>(size));
    for (std::size_t k = 0; k < visited_; ++k) images_[static_cast<std::size_t>(queue_[k] - first)] = no_flag;
    return result;
}

// A map that respects every edge between connected islands of one size is onto, and so one-to-one. Whether a
// neighbour is new cannot be predicted, so both cases take the same steps.
bool Walker::extend(Index first) {
    Flag* const images = images_.data();
    Index* const queue = queue_.data();
    std::size_t visited = visited_;
    bool agree = true;
    for (std::size_t k = 0; k < visited && agree; ++k) {
        Flag f = make_flag(queue[k], 0), g = images[queue[k] - first];
        for (int side = 0; side < 3; ++side, f = next(f, 1), g = next(g, 1)) {
            const Flag over_f = a_.across(f), over_g = b_.across(g);
            agree = agree && (over_f == no_flag) == (over_g == no_flag);
            if (over_f == no_flag || !agree) continue;
            const Flag image = image_of_first(over_f, over_g);
            Flag& known = images[triangle_of(over_f) - first];
            const bool is_new = known == no_flag;
            agree = is_new || known == image;
            known = is_new ? image : known;
            queue[visited] = triangle_of(over_f);
            visited += is_new ? 1 : 0;
        }
    }
    visited_ = visited;
    return agree;
}

// Edges alone do not see that fans meet in one vertex (a pinch).
bool Walker::vertices_agree(Index first, Index size) {
    vertex_image_.resize(static_cast<std::size_t>(a_.n_vertices()), -1);
    vertex_origin_.resize(static_cast<std::size_t>(b_.n_vertices()), -1);
    bool agree = true;
    seen_.clear();
    for (Index t = first; t < first + size && agree; ++t) {
        Flag g = images_[static_cast<std::size_t>(t - first)];
        for (std::size_t c = 0; c < 3; ++c, g = next(g, 1)) {
            const Index a = a_.corner[3 * static_cast<std::size_t>(t) + c], b = b_.origin(g);
            Index& image = vertex_image_[static_cast<std::size_t>(a)];
            Index& origin = vertex_origin_[static_cast<std::size_t>(b)];
            if (image < 0 && origin < 0) {
                image = b;
                origin = a;
                seen_.push_back(a);
            }
            agree = agree && image == b && origin == a;
        }
    }
    for (const Index a : seen_) {
        vertex_origin_[static_cast<std::size_t>(vertex_image_[static_cast<std::size_t>(a)])] = -1;
        vertex_image_[static_cast<std::size_t>(a)] = -1;
    }
    return agree;
}

}  // namespace counterpart
