// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/polygons.hpp"

#include "match/exact/isomorphism.hpp"
#include "mesh/polygons.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace counterpart::exact {
namespace {

using isomorphism::to_size;

// For each corner of a triangle of the source one of the target that stands for the same corner of a polygon;
// the result's are those of coned meshes, whose triangle j begins at polygon corner j.
Triangles uncut_corners(const Polygons& source, const Polygons& target, TrianglesView coned) {
    const std::vector<Index> stands_for = target.triangle_corners();
    std::vector<Index> next(to_size(target.n_corners()));
    for (Index p = 0; p < target.count(); ++p)
        for (Index j = target.first[to_size(p)]; j < target.first[to_size(p) + 1]; ++j)
            next[to_size(j)] = j + 1 < target.first[to_size(p) + 1] ? j + 1 : target.first[to_size(p)];
    return source.corners.unaryExpr([&](Index j) {
        const Index corner = coned(j, 0);
        return stands_for[to_size(corner % 3 == 0 ? corner / 3 : next[to_size(corner / 3)])];
    });
}

// How many of the source's polygons are cut into other triangles in the target.
Index count_cut_differently(const Polygons& source, const Triangles& target_corners, const Polygons& target) {
    const auto cut_of = [](const Triangles& triangles, Index begin, Index end, const auto& corner) {
        std::vector<std::array<Index, 3>> cut;
        for (Index t = begin; t < end; ++t) {
            cut.push_back({corner(triangles(t, 0)), corner(triangles(t, 1)), corner(triangles(t, 2))});
            std::sort(cut.back().begin(), cut.back().end());
        }
        std::sort(cut.begin(), cut.end());
        return cut;
    };
    Index count = 0;
    for (Index p = 0; p < source.count(); ++p) {
        const Index n = source.size(p), begin = source.first_triangle(p);
        if (n == 3) continue;
        const auto of_target = [&](Index corner) { return target.corners.data()[corner]; };
        const Index image = of_target(target_corners(begin, 0));
        const auto q = static_cast<Index>(std::upper_bound(target.first.begin(), target.first.end(), image) -
                                          target.first.begin() - 1);
        const Index there = target.first_triangle(q);
        const auto itself = [](Index corner) { return corner; };
        if (cut_of(target_corners, begin, begin + n - 2, of_target) !=
            cut_of(target.corners, there, there + n - 2, itself))
            ++count;
    }
    return count;
}

VertexMap without_centers(const VertexMap& map, Index n_source, Index n_target) {
    return {{map.image().begin(), map.image().begin() + n_source}, n_target};
}

}  // namespace

ExactResult match_polygons(MeshView source, MeshView target, const ExactOptions& options) {
    const Polygons &from = *source.polygons, &to = *target.polygons;
    ExactResult differing;
    differing.difference = mesh::first_difference(from, to);
    if (!differing.difference.empty()) return differing;
    const TriangleMesh a = mesh::coned(source), b = mesh::coned(target);
    Isomorphism found = match_triangles(a, b, options, source.n_vertices(), target.n_vertices());
    ExactResult& result = found.result;
    Described& described = found.source;
    if (!result.identical) return std::move(result);
    result.target_from_source =
        without_centers(result.target_from_source, source.n_vertices(), target.n_vertices());
    for (VertexMap& other : result.alternatives)
        other = without_centers(other, source.n_vertices(), target.n_vertices());
    described.faces = "polygons";
    described.n_faces = from.count();
    described.n_reversed = result.reversed_triangles = 0;
    for (Index p = 0; p < from.count(); ++p) {
        const Index j = from.first[to_size(p)];
        if (result.target_corner_from_source(j, 0) % 3 == 0) continue;
        ++described.n_reversed;
        result.reversed_triangles += from.size(p) - 2;
    }
    result.target_corner_from_source = uncut_corners(from, to, result.target_corner_from_source);
    result.recut_polygons = count_cut_differently(from, result.target_corner_from_source, to);
    describe(described, result);
    if (result.recut_polygons > 0)
        result.notices.push_back(fmt::format("{} of {} polygons are cut into other triangles in the target",
                                             result.recut_polygons, from.count()));
    return std::move(result);
}

}  // namespace counterpart::exact
