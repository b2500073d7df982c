// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/polygons.hpp"

#include "base/hash_mixing.hpp"
#include "base/parallel.hpp"
#include "match/diagonals/diagonals.hpp"
#include "match/exact/isomorphism.hpp"
#include "match/isomorphism/traversal.hpp"
#include "mesh/polygons.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include <fmt/format.h>

namespace counterpart::exact {
namespace {

using isomorphism::to_size;

constexpr std::size_t grain = 2048;  // polygons that are worth a thread

// For each corner of a polygon of the source that of the target: of coned meshes triangle j begins at corner
// j.
std::vector<Index> polygon_corner_images(const Polygons& source, const Polygons& target,
                                         TrianglesView coned) {
    std::vector<Index> next(to_size(target.n_corners()));
    for (Index q = 0; q < target.count(); ++q) {
        const Index begin = target.first[to_size(q)], end = target.first[to_size(q) + 1];
        std::iota(next.begin() + begin, next.begin() + end, begin + 1);
        next[to_size(end - 1)] = begin;
    }
    std::vector<Index> image(to_size(source.n_corners()));
    parallel_for(image.size(), 4 * grain, [&](std::size_t j) {
        const Index corner = coned(static_cast<Index>(j), 0);
        image[j] = corner % 3 == 0 ? corner / 3 : next[to_size(corner / 3)];
    });
    return image;
}

// How many of the source's polygons are cut into other triangles in the target. Two cuts of a polygon are
// equal where the sums over their triangles are, of hashes that do not depend on a triangle's first corner.
Index count_cut_differently(const Polygons& source, const std::vector<Index>& image, const Polygons& target) {
    const auto hash = [](const Index* corner, const auto& name) {
        const auto of = [&](int c) { return finalized(static_cast<std::uint64_t>(name(corner[c])) + 1); };
        return finalized(of(0) + of(1) + of(2));
    };
    std::vector<Index> polygon_of(to_size(target.n_corners()));  // of the target's corners
    for (Index q = 0; q < target.count(); ++q)
        std::fill_n(polygon_of.begin() + target.first[to_size(q)], target.size(q), q);
    std::vector<std::uint8_t> differs(to_size(source.count()), 0);
    parallel_for(differs.size(), grain, [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        const Index q = polygon_of[to_size(image[to_size(source.first[i])])];
        std::uint64_t difference = 0;
        for (Index t = 0; t < source.size(p) - 2; ++t) {
            difference += hash(source.corners.row(source.first_triangle(p) + t).data(),
                               [&](Index corner) { return image[to_size(corner)]; });
            difference -= hash(target.corners.row(target.first_triangle(q) + t).data(), std::identity{});
        }
        differs[i] = difference == 0 ? 0 : 1;
    });
    return static_cast<Index>(std::count(differs.begin(), differs.end(), 1));
}

VertexMap without_centers(const VertexMap& map, Index n_source, Index n_target) {
    return {{map.image().begin(), map.image().begin() + n_source}, n_target};
}

// Without messages.
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
    const std::vector<Index> image = polygon_corner_images(from, to, result.target_corner_from_source),
                             stands_for = to.triangle_corners();
    result.target_corner_from_source =
        from.corners.unaryExpr([&](Index j) { return stands_for[to_size(image[to_size(j)])]; });
    result.recut_polygons = count_cut_differently(from, image, to);
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

// Without messages; corners are those of the triangles that the quads were made of.
Isomorphism match_with_quads(const diagonals::Recut& recut, ExactOptions options, double begin) {
    options.progress = part_of(options.progress, begin, 1);
    Isomorphism found = match_coned(recut.source.mesh, recut.target.mesh, options);
    if (found.result.identical)
        found.result.target_corner_from_source =
            in_input_order(found.result.target_corner_from_source, recut);
    return found;
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
        result.messages.push_back({MessageCode::recut_polygons, Severity::notice,
                                   fmt::format("{} of {} polygons are cut into other triangles in the target",
                                               result.recut_polygons, source.polygons->count())});
    return std::move(result);
}

ExactResult match_recut(MeshView source, MeshView target, const ExactOptions& options) {
    const auto [recut, why_not] =
        diagonals::find_recut_quads(source, target, part_of(options.progress, 0, 0.5));
    if (!recut) {
        ExactResult differing;
        differing.difference = why_not;
        return differing;
    }
    Isomorphism found = match_with_quads(*recut, options, 0.5);
    ExactResult& result = found.result;
    if (!result.identical) return std::move(result);
    if (const auto all = diagonals::with_known_quads(source, target, result.target_from_source))
        found = match_with_quads(*all, options, 0.75);
    found.source.faces = "triangles";
    found.source.n_faces = source.n_triangles();
    found.source.n_reversed = result.reversed_triangles;
    describe(found.source, result);
    result.messages.push_back(
        {MessageCode::recut_polygons, Severity::notice,
         fmt::format("{} quads are cut along the other diagonal in the target", result.recut_polygons)});
    return std::move(result);
}

}  // namespace counterpart::exact
