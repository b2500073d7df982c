// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/match/refine.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// A tenth of the map is known; the rest is found again, whichever way the known part is given.
TEST(Refine, FindsWhatIsNotKnown) {
    const TriangleMesh source = make_body({.subdivisions = 0});
    const TriangleMesh target = deform(source, {.bend = 0.3});
    std::vector<Index> image(static_cast<std::size_t>(source.n_vertices()), VertexMap::unmatched);
    for (std::size_t v = 0; v < image.size(); v += 10) image[v] = static_cast<Index>(v);
    const VertexMap partly_known(image, target.n_vertices());
    const RefineResult refined = refine_map(partly_known, source, target, {.basis_size = 60});
    Index n_right = 0;
    for (Index v = 0; v < source.n_vertices(); ++v) n_right += refined.target_from_source[v] == v;
    EXPECT_GT(n_right, source.n_vertices() * 8 / 10);
    EXPECT_GT(refined.confidence.mean(), 0.8);
    EXPECT_EQ(count_matched(refined.source_from_target), target.n_vertices());
    const RefineResult of_points =
        refine_map(surface_map_of(partly_known, target), source, target, {.basis_size = 60});
    EXPECT_EQ(count_matched(of_points.target_from_source), source.n_vertices());
    EXPECT_THROW(refine_map(VertexMap(), source, target), InvalidInput);
    EXPECT_THROW(
        refine_map(VertexMap(std::vector<Index>(image.size(), -1), target.n_vertices()), source, target),
        InvalidInput);
}

}  // namespace
}  // namespace counterpart
