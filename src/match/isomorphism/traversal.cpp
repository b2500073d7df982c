// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/isomorphism/traversal.hpp"

#include "base/parallel.hpp"

namespace counterpart::isomorphism {

std::vector<Color> vertex_colors(const DartMap& map, int rounds) {
    const auto n = to_size(map.n_vertices());
    const std::size_t n_corners = map.corner.size();
    std::vector<Color> colors(n, 0);
    for (std::size_t h = 0; h < n_corners; ++h) {
        const auto v = to_size(map.corner[h]);
        colors[v] += 1;
        if (map.twin[h] != no_dart) continue;
        colors[v] += 1U << 16U;  // both ends of a border, alike in both directions
        colors[to_size(map.corner[h % 3 == 2 ? h - 2 : h + 1])] += 1U << 16U;
    }
    constexpr Color center = Color{1} << 40U;
    if (map.first_center != no_center)
        for (std::size_t v = 0; v < n; ++v)
            if (map.input_vertex[v] >= map.first_center) colors[v] += center;
    for (Color& color : colors) color = finalized(color);
    return refined_colors(map, std::move(colors), rounds);
}

std::vector<Color> refined_colors(const DartMap& map, std::vector<Color> colors, int rounds) {
    const std::size_t n = colors.size(), n_corners = map.corner.size();
    std::vector<Color> sums(n);
    for (int round = 0; round < rounds; ++round) {
        sums.assign(n, 0);
        for (std::size_t h = 0; h < n_corners; h += 3) {
            const auto u = to_size(map.corner[h]), v = to_size(map.corner[h + 1]),
                       w = to_size(map.corner[h + 2]);
            const Color triangle = finalized(colors[u] + colors[v] + colors[w]);
            sums[u] += triangle;
            sums[v] += triangle;
            sums[w] += triangle;
        }
        for (std::size_t v = 0; v < n; ++v) colors[v] = finalized(3 * colors[v] + sums[v]);
    }
    return colors;
}

// From the image of a dart to that of corner 0, direction 0 of its triangle.
static Dart image_of_first(Dart dart, Dart image) {
    const Dart corner = corner_of(dart);
    return next(image ^ direction_of(dart), corner == 0 ? 0 : 3 - corner);
}

Images SimultaneousTraversal::run(Index component_a, Dart root_a, Dart root_b) {
    const Index first = a_.component_begin[to_size(component_a)];
    const auto size = to_size(a_.component_size(component_a));
    if (images_.size() < size) {
        images_.resize(size, no_dart);
        queue_.resize(size + 1);  // a step writes to the place behind the last, whether or not it stays
    }
    images_[to_size(triangle_of(root_a) - first)] = image_of_first(root_a, root_b);
    queue_[0] = triangle_of(root_a);
    visited_ = 1;

    const bool agree =
        extend(first) && visited_ == size && vertices_agree(first, a_.component_size(component_a));
    steps_ += visited_;
    Images result;
    if (agree) result.assign(images_.begin(), images_.begin() + static_cast<std::ptrdiff_t>(size));
    for (std::size_t k = 0; k < visited_; ++k) images_[to_size(queue_[k] - first)] = no_dart;
    return result;
}

// A map that respects every edge between connected components of one size is onto, and so one-to-one. Whether
// a neighbor is new cannot be predicted, so both cases take the same steps.
bool SimultaneousTraversal::extend(Index first) {
    Dart* const images = images_.data();
    Index* const queue = queue_.data();
    std::size_t visited = visited_;
    bool agree = true;
    for (std::size_t k = 0; k < visited && agree; ++k) {
        fetch(first, k, visited);
        Dart f = make_dart(queue[k], 0), g = images[queue[k] - first];
        for (int side = 0; side < 3; ++side, f = next(f, 1), g = next(g, 1)) {
            const Dart over_f = a_.across(f), over_g = b_.across(g);
            agree = agree && (over_f == no_dart) == (over_g == no_dart);
            if (over_f == no_dart || !agree) continue;
            const Dart image = image_of_first(over_f, over_g);
            Dart& known = images[triangle_of(over_f) - first];
            const bool is_new = known == no_dart;
            agree = is_new || known == image;
            known = is_new ? image : known;
            queue[visited] = triangle_of(over_f);
            visited += is_new ? 1 : 0;
        }
    }
    visited_ = visited;
    return agree;
}

// What the steps to come will read: first the triangles, then what they point to.
void SimultaneousTraversal::fetch(Index first, std::size_t done, std::size_t visited) const {
    constexpr std::size_t ahead = 8;
    if (done + 2 * ahead < visited) {
        const Index t = queue_[done + 2 * ahead];
        __builtin_prefetch(&a_.twin[3 * to_size(t)]);
        __builtin_prefetch(&b_.twin[3 * to_size(triangle_of(images_[to_size(t - first)]))]);
    }
    if (done + ahead >= visited) return;
    const std::size_t h = 3 * to_size(queue_[done + ahead]);
    for (std::size_t c = 0; c < 3; ++c)
        if (a_.twin[h + c] != no_dart)
            __builtin_prefetch(&images_[to_size(triangle_of(a_.twin[h + c]) - first)]);
}

// Edges alone do not see that fans meet in one vertex (a pinch): whether all corners at one vertex go to one
// vertex, and, at the same time, whether all that go to one come from one.
bool SimultaneousTraversal::vertices_agree(Index first, Index size) {
    vertex_image_.resize(to_size(a_.n_vertices()));
    vertex_origin_.resize(to_size(b_.n_vertices()));
    ++run_;
    const auto is_single_valued = [&](std::vector<Known>& value, const auto& from, const auto& to) {
        bool agrees = true;
        for (Index t = first; t < first + size; ++t) {
            Dart g = images_[to_size(t - first)];
            for (std::size_t c = 0; c < 3; ++c, g = next(g, 1)) {
                const Index a = a_.corner[3 * to_size(t) + c], b = b_.origin(g);
                Known& known = value[to_size(from(a, b))];
                agrees = agrees && (known.run != run_ || known.vertex == to(a, b));
                known = {run_, to(a, b)};
            }
        }
        return agrees;
    };
    const auto on_a = [](Index a, Index) { return a; };
    const auto on_b = [](Index, Index b) { return b; };
    bool forward = false, backward = false;
    parallel_invoke([&] { forward = is_single_valued(vertex_image_, on_a, on_b); },
                    [&] { backward = is_single_valued(vertex_origin_, on_b, on_a); });
    return forward && backward;
}

}  // namespace counterpart::isomorphism
