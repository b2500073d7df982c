// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/match/match.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(LeftOutVertex, HasNoPartner) {
    TriangleMesh a = make_body({.subdivisions = 0}), b = a;
    for (TriangleMesh* mesh : {&a, &b}) {
        const Eigen::RowVector3d mean = mesh->vertices.colwise().mean();
        mesh->vertices.conservativeResize(mesh->vertices.rows() + 1, 3);
        mesh->vertices.bottomRows<1>() = mean;
        mesh->left_out = {mesh->n_vertices() - 1};
    }
    const MatchResult result = match(a, b);
    EXPECT_EQ(result.method, MatchMethod::exact);
    EXPECT_EQ(result.target_from_source[a.n_vertices() - 1], VertexMap::unmatched);
    EXPECT_EQ(result.confidence[a.n_vertices() - 1], 0);
    EXPECT_EQ(count_matched(result.target_from_source), a.n_vertices() - 1);
}

}  // namespace
}  // namespace counterpart
