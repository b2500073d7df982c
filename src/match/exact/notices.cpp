// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/notices.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::exact {
namespace {

void describe_equal_components(const std::vector<EqualComponents>& classes,
                               std::vector<std::string>& notices) {
    if (classes.empty()) return;
    std::size_t n_components = 0;
    for (const EqualComponents& equal : classes) n_components += equal.source.size();
    const EqualComponents& largest = *std::max_element(
        classes.begin(), classes.end(),
        [](const EqualComponents& a, const EqualComponents& b) { return a.source.size() < b.source.size(); });
    notices.push_back(
        classes.size() == 1
            ? fmt::format("{} components of {} triangles are interchangeable; they were paired by position",
                          n_components, largest.n_triangles)
            : fmt::format("{} components are interchangeable within {} classes, the largest of {} components "
                          "of {} triangles; they were paired by position",
                          n_components, classes.size(), largest.source.size(), largest.n_triangles));
}

}  // namespace

void describe(const Described& source, ExactResult& result) {
    auto& notices = result.notices;
    const auto is_many = [](const Count& count) { return !count.number || *count.number > 1; };
    if (result.path == ExactPath::patches)
        notices.push_back(fmt::format(
            "non-manifold: {} edges with more than two {}, {} vertices in several "
            "patches; matched patch by patch ({} patches)",
            source.non_manifold_edges, source.faces, source.non_manifold_vertices, result.n_components));
    if (result.mirrored)
        notices.push_back(fmt::format(
            "the target is a mirror image of the source{}",
            result.winding_reversed ? fmt::format(": all {} have the opposite winding", source.faces) : ""));
    else if (result.winding_reversed)
        notices.push_back(
            fmt::format("the target's winding is reversed: all {} have the opposite winding", source.faces));
    else if (source.n_reversed > 0)
        notices.push_back(fmt::format("{} of {} {} have the opposite winding in the target",
                                      source.n_reversed, source.n_faces, source.faces));
    if (is_many(result.automorphisms))
        notices.push_back(
            fmt::format("the connectivity is symmetric: {} orientation-preserving matches are possible, the "
                        "choice was made by geometry",
                        to_string(result.automorphisms)));
    if (is_many(result.mirror_automorphisms) || *result.mirror_automorphisms.number > 0)
        notices.push_back(fmt::format("{} orientation-reversing matches are possible too",
                                      to_string(result.mirror_automorphisms)));
    describe_equal_components(result.interchangeable, notices);
    if (source.n_isolated > 0)
        notices.push_back(fmt::format("{} isolated vertices were paired by position", source.n_isolated));
}

}  // namespace counterpart::exact
