// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/extent.hpp"
#include "support/cuts.hpp"

#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <vector>

#include <gtest/gtest.h>

namespace counterpart::partial_match {
namespace {

using surface_match::preprocess;

// The same vertex, where the other mesh shows it: all are parts of `whole`.
VertexMap between(const test::PartOfMesh& source, const test::PartOfMesh& target, Index n_whole) {
    std::vector<Index> target_of_whole(static_cast<std::size_t>(n_whole), VertexMap::unmatched), image;
    for (Index w = 0; w < target.mesh.n_vertices(); ++w)
        target_of_whole[static_cast<std::size_t>(target.whole_from_part[w])] = w;
    for (const Index v : source.whole_from_part.image())
        image.push_back(target_of_whole[static_cast<std::size_t>(v)]);
    return {std::move(image), target.mesh.n_vertices()};
}

class ShowTheSameRegion : public testing::Test {
  protected:
    const TriangleMesh whole = make_body({.subdivisions = 2});
    const double top = whole.vertices.col(1).maxCoeff(), bottom = whole.vertices.col(1).minCoeff();

    test::PartOfMesh above(double share) const {
        return test::cut_by_plane(whole, {0, 1, 0}, bottom + share * (top - bottom));
    }
    bool in(const test::PartOfMesh& a, const test::PartOfMesh& b) const {
        return show_the_same_region(preprocess(a.mesh), preprocess(b.mesh), between(a, b, whole.n_vertices()),
                                    between(b, a, whole.n_vertices()));
    }
};

TEST_F(ShowTheSameRegion, NotWithoutABoundary) {
    const auto all = test::part_of(whole, [](const Eigen::RowVector3d&) { return true; });
    EXPECT_FALSE(in(all, all));
    EXPECT_FALSE(in(all, above(0.4)));
}

TEST_F(ShowTheSameRegion, WhatIsCutInOnePlace) {
    const test::PartOfMesh a = above(0.4);
    EXPECT_TRUE(in(a, a));
    test::PartOfMesh moved{deform(a.mesh, {.bend = 0.3, .twist = 0.2}), a.whole_from_part};
    moved.mesh.vertices *= 30;
    EXPECT_TRUE(in(a, moved));
    EXPECT_TRUE(in(moved, a));
}

TEST_F(ShowTheSameRegion, NotWhatIsCutFartherUp) {
    EXPECT_FALSE(in(above(0.4), above(0.5)));
    EXPECT_FALSE(in(above(0.5), above(0.4)));
}

TEST_F(ShowTheSameRegion, NotWhatHasAHoleBesides) {
    const test::PartOfMesh a = above(0.4);
    const test::PartOfMesh b = test::part_of(whole, [&](const Eigen::RowVector3d& x) {
        return x.y() > bottom + 0.4 * (top - bottom) && (x - a.mesh.vertices.row(0)).norm() > 0.15;
    });
    EXPECT_FALSE(in(a, b));
    EXPECT_FALSE(in(b, a));
}

// Partners are missed first along the boundary.
TEST_F(ShowTheSameRegion, UnmatchedVerticesFollowThoseBesideThem) {
    const test::PartOfMesh a = above(0.4);
    std::vector<Index> image = between(a, a, whole.n_vertices()).image();
    const double rim = a.mesh.vertices.col(1).minCoeff() + 0.01 * (top - bottom);
    for (Index v = 0; v < a.mesh.n_vertices(); ++v)
        if (a.mesh.vertices(v, 1) < rim) image[static_cast<std::size_t>(v)] = VertexMap::unmatched;
    const VertexMap map(image, a.mesh.n_vertices());
    EXPECT_TRUE(show_the_same_region(preprocess(a.mesh), preprocess(a.mesh), map, map));
    const VertexMap none(std::vector<Index>(image.size(), VertexMap::unmatched), a.mesh.n_vertices());
    EXPECT_FALSE(show_the_same_region(preprocess(a.mesh), preprocess(a.mesh), none, none));
}

}  // namespace
}  // namespace counterpart::partial_match
