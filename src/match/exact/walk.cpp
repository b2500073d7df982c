// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/walk.hpp"

namespace counterpart {

std::vector<Color> vertex_colors(const CombinatorialMap& map, int rounds) {
    const auto n = static_cast<std::size_t>(map.n_vertices());
    const std::size_t n_corners = map.corner.size();
    std::vector<Color> colors(n, 0), sums(n);
    for (std::size_t h = 0; h < n_corners; ++h) {
        const auto v = static_cast<std::size_t>(map.corner[h]);
        colors[v] += 1;
        if (map.twin[h] != no_flag) continue;
        colors[v] += 1U << 16U;  // both ends of a border, alike in both directions
        colors[static_cast<std::size_t>(map.corner[h % 3 == 2 ? h - 2 : h + 1])] += 1U << 16U;
    }
    for (Color& color : colors) color = mix(color);
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

Images Walker::walk(Index island_a, Flag root_a, Flag root_b) {
    const Index first = a_.island_begin[static_cast<std::size_t>(island_a)], size = a_.island_size(island_a);
    if (images_.size() < static_cast<std::size_t>(size))
        images_.resize(static_cast<std::size_t>(size), no_flag);
    // Image of corner 0, direction 0 of the root's triangle.
    Flag g = root_b ^ direction_of(root_a);
    for (Flag c = (root_a >> 1U) & 3U; c > 0; --c) g = previous(g);
    images_[static_cast<std::size_t>(triangle_of(root_a) - first)] = g;
    queue_.assign(1, triangle_of(root_a));

    const bool agree =
        extend(first) && queue_.size() == static_cast<std::size_t>(size) && vertices_agree(first, size);
    steps_ += queue_.size();
    Images result;
    if (agree) result.assign(images_.begin(), images_.begin() + size);
    for (const Index t : queue_) images_[static_cast<std::size_t>(t - first)] = no_flag;
    return result;
}

// A map that respects every edge between connected islands of one size is onto, and so one-to-one.
bool Walker::extend(Index first) {
    for (std::size_t k = 0; k < queue_.size(); ++k) {
        Flag f = make_flag(queue_[k], 0), g = images_[static_cast<std::size_t>(queue_[k] - first)];
        for (int side = 0; side < 3; ++side, f = next(f), g = next(g)) {
            const Flag over_f = a_.across(f), over_g = b_.across(g);
            if ((over_f == no_flag) != (over_g == no_flag)) return false;
            if (over_f == no_flag) continue;
            // From the image of the flag across to that of its triangle's corner 0, direction 0.
            Flag image = over_g ^ direction_of(over_f);
            for (Flag c = (over_f >> 1U) & 3U; c > 0; --c) image = previous(image);
            Flag& known = images_[static_cast<std::size_t>(triangle_of(over_f) - first)];
            if (known == no_flag) {
                known = image;
                queue_.push_back(triangle_of(over_f));
            } else if (known != image) {
                return false;
            }
        }
    }
    return true;
}

// Edges alone do not see that fans meet in one vertex (a pinch).
bool Walker::vertices_agree(Index first, Index size) {
    vertex_image_.resize(static_cast<std::size_t>(a_.n_vertices()), -1);
    vertex_origin_.resize(static_cast<std::size_t>(b_.n_vertices()), -1);
    bool agree = true;
    const auto for_each_pair = [&](const auto& body) {
        for (Index t = first; t < first + size; ++t) {
            Flag g = images_[static_cast<std::size_t>(t - first)];
            for (int c = 0; c < 3; ++c, g = next(g))
                body(a_.corner[3 * static_cast<std::size_t>(t) + static_cast<std::size_t>(c)], b_.origin(g));
        }
    };
    for_each_pair([&](Index a, Index b) {
        Index& image = vertex_image_[static_cast<std::size_t>(a)];
        Index& origin = vertex_origin_[static_cast<std::size_t>(b)];
        if (image < 0 && origin < 0) {
            image = b;
            origin = a;
        }
        agree = agree && image == b && origin == a;
    });
    for_each_pair([&](Index a, Index b) {
        vertex_image_[static_cast<std::size_t>(a)] = -1;
        vertex_origin_[static_cast<std::size_t>(b)] = -1;
    });
    return agree;
}

}  // namespace counterpart
