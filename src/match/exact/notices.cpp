// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/notices.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace counterpart::exact {
namespace {

Message on_equal_components(const std::vector<EqualComponents>& classes) {
    std::vector<Index> vertices;  // one of each
    for (const EqualComponents& equal : classes)
        vertices.insert(vertices.end(), equal.source.begin(), equal.source.end());
    const EqualComponents& largest = *std::max_element(
        classes.begin(), classes.end(),
        [](const EqualComponents& a, const EqualComponents& b) { return a.source.size() < b.source.size(); });
    const std::string sentence =
        classes.size() == 1
            ? fmt::format("{} components of {} triangles are interchangeable; they were paired by position",
                          vertices.size(), largest.n_triangles)
            : fmt::format(
                  "{} components are interchangeable within {} classes, the largest of {} components "
                  "of {} triangles; they were paired by position",
                  vertices.size(), classes.size(), largest.source.size(), largest.n_triangles);
    return {MessageCode::interchangeable_components,
            Severity::notice,
            sentence,
            {Subject::map, std::move(vertices)}};
}

}  // namespace

void describe(const Described& source, ExactResult& result) {
    const auto add = [&](MessageCode code, std::string sentence) {
        result.messages.push_back({code, Severity::notice, std::move(sentence)});
    };
    const auto is_many = [](const Count& count) { return !count.number || *count.number > 1; };
    if (result.path == ExactPath::patches)
        add(MessageCode::non_manifold,
            fmt::format("non-manifold: {} edges with more than two {}, {} vertices in several "
                        "patches; matched patch by patch ({} patches)",
                        source.non_manifold_edges, source.faces, source.non_manifold_vertices,
                        result.n_components));
    if (result.mirrored)
        add(MessageCode::mirror_image,
            fmt::format("the target is a mirror image of the source{}",
                        result.winding_reversed
                            ? fmt::format(": all {} have the opposite winding", source.faces)
                            : ""));
    else if (result.winding_reversed)
        add(MessageCode::reversed_triangles,
            fmt::format("the target's winding is reversed: all {} have the opposite winding", source.faces));
    else if (source.n_reversed > 0)
        add(MessageCode::reversed_triangles,
            fmt::format("{} of {} {} have the opposite winding in the target", source.n_reversed,
                        source.n_faces, source.faces));
    if (is_many(result.automorphisms))
        add(MessageCode::symmetric_connectivity,
            fmt::format("the connectivity is symmetric: {} orientation-preserving matches are possible, the "
                        "choice was made by geometry",
                        to_string(result.automorphisms)));
    if (is_many(result.mirror_automorphisms) || *result.mirror_automorphisms.number > 0)
        add(MessageCode::mirrored_connectivity,
            fmt::format("{} orientation-reversing matches are possible too",
                        to_string(result.mirror_automorphisms)));
    if (!result.interchangeable.empty())
        result.messages.push_back(on_equal_components(result.interchangeable));
    if (!result.by_place.empty())
        result.messages.push_back(
            {MessageCode::alike_parts,
             Severity::notice,
             fmt::format(
                 "{} vertices belong to parts that are alike in themselves or to each other: only their "
                 "place tells how they lie",
                 result.by_place.size()),
             {Subject::map, result.by_place}});
    if (source.n_isolated > 0)
        add(MessageCode::isolated_vertices,
            fmt::format("{} isolated vertices were paired by position", source.n_isolated));
}

}  // namespace counterpart::exact
