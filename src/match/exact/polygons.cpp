// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/polygons.hpp"

#include "base/parallel.hpp"
#include "match/diagonals/diagonals.hpp"
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
    using Cut = std::vector<std::array<Index, 3>>;
    const auto fill = [](Cut& cut, const Triangles& triangles, Index begin, Index end, const auto& corner) {
        cut.clear();
        for (Index t = begin; t < end; ++t) {
            cut.push_back({corner(triangles(t, 0)), corner(triangles(t, 1)), corner(triangles(t, 2))});
            std::sort(cut.back().begin(), cut.back().end());
        }
        std::sort(cut.begin(), cut.end());
    };
    std::vector<Index> polygon_of(to_size(target.n_corners()));  // of the target's corners
    for (Index q = 0; q < target.count(); ++q)
        std::fill_n(polygon_of.begin() + target.first[to_size(q)], target.size(q), q);
    Cut ours, theirs;
    Index count = 0;
    for (Index p = 0; p < source.count(); ++p) {
        const Index n = source.size(p), begin = source.first_triangle(p);
        if (n == 3) continue;
        const auto of_target = [&](Index corner) { return target.corners.data()[corner]; };
        const Index image = of_target(target_corners(begin, 0));
        const Index there = target.first_triangle(polygon_of[to_size(image)]);
        const auto itself = [](Index corner) { return corner; };
        fill(ours, target_corners, begin, begin + n - 2, of_target);
        fill(theirs, target.corners, there, there + n - 2, itself);
        if (ours != theirs) ++count;
    }
    return count;
}

VertexMap without_centers(const VertexMap& map, Index n_source, Index n_target) {
    return {{map.image().begin(), map.image().begin() + n_source}, n_target};
}

// Without notices.
Isomorphism match_coned(MeshView source, MeshView target, const ExactOptions& options) {
    const Polygons &from = *source.polygons, &to = *target.polygons;
    TriangleMesh a, b;
    parallel_invoke([&] { a = mesh::coned(source); }, [&] { b = mesh::coned(target); });
    Isomorphism found = match_triangles(a, b, options, source.n_vertices(), target.n_vertices());
    ExactResult& result = found.result;
    if (!result.identical) return found;
    result.target_from_source =
        without_centers(result.target_from_source, source.n_vertices(), target.n_vertices());
    for (VertexMap& other : result.alternatives)
        other = without_centers(other, source.n_vertices(), target.n_vertices());
    found.source.faces = "polygons";
    found.source.n_faces = from.count();
    found.source.n_reversed = result.reversed_triangles = 0;
    for (Index p = 0; p < from.count(); ++p) {
        const Index j = from.first[to_size(p)];
        if (result.target_corner_from_source(j, 0) % 3 == 0) continue;
        ++found.source.n_reversed;
        result.reversed_triangles += from.size(p) - 2;
    }
    result.target_corner_from_source = uncut_corners(from, to, result.target_corner_from_source);
    result.recut_polygons = count_cut_differently(from, result.target_corner_from_source, to);
    return found;
}

// From the triangles of meshes with quads to those that they were made of.
Triangles in_input_order(TrianglesView corners, const diagonals::Recut& recut) {
    Triangles result(corners.rows(), 3);
    for (Eigen::Index t = 0; t < corners.rows(); ++t)
        for (int c = 0; c < 3; ++c)
            result(recut.source.triangle[to_size(t)], c) =
                3 * recut.target.triangle[to_size(corners(t, c) / 3)] + corners(t, c) % 3;
    return result;
}

}  // namespace

ExactResult match_polygons(MeshView source, MeshView target, const ExactOptions& options) {
    ExactResult differing;
    differing.difference = mesh::first_difference(*source.polygons, *target.polygons);
    if (!differing.difference.empty()) return differing;
    Isomorphism found = match_coned(source, target, options);
    ExactResult& result = found.result;
    if (!result.identical) return std::move(result);
    describe(found.source, result);
    if (result.recut_polygons > 0)
        result.notices.push_back(fmt::format("{} of {} polygons are cut into other triangles in the target",
                                             result.recut_polygons, source.polygons->count()));
    return std::move(result);
}

std::optional<ExactResult> match_recut(MeshView source, MeshView target, const ExactOptions& options) {
    const auto recut = diagonals::find_recut_quads(source, target, part_of(options.progress, 0, 0.5));
    if (!recut) return std::nullopt;
    ExactOptions rest = options;
    rest.progress = part_of(options.progress, 0.5, 1);
    Isomorphism found = match_coned(recut->source.mesh, recut->target.mesh, rest);
    ExactResult& result = found.result;
    if (!result.identical) return std::nullopt;
    result.target_corner_from_source = in_input_order(result.target_corner_from_source, *recut);
    found.source.faces = "triangles";
    found.source.n_faces = source.n_triangles();
    found.source.n_reversed = result.reversed_triangles;
    describe(found.source, result);
    result.notices.push_back(
        fmt::format("{} quads are cut along the other diagonal in the target", result.recut_polygons));
    return std::move(result);
}

}  // namespace counterpart::exact
