// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Meshes that share a layout of texture coordinates.
#include "support/expect_error.hpp"
#include "support/layouts.hpp"
#include "support/messages.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/verdict.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::LaidOut;

MatchResult matched(const LaidOut& source, const LaidOut& target) {
    return match(source.mesh, target.mesh,
                 {.method = MatchMethod::uv, .uv = {.source = source.uv, .target = target.uv}});
}

LaidOut moved(LaidOut laid_out, double x) {
    laid_out.mesh.vertices.col(0).array() += x;
    return laid_out;
}

LaidOut laid_at(LaidOut laid_out, double u, double v) {
    laid_out.uv.values.rowwise() += Eigen::RowVector2d(u, v);
    return laid_out;
}

LaidOut bent(LaidOut laid_out) {
    laid_out.mesh = deform(laid_out.mesh, {.bend = 0.7, .twist = 0.3});
    return laid_out;
}

// Its left half lies on its right half, folded at the middle.
LaidOut folded(int cells, std::uint64_t seed) {
    LaidOut square = test::laid_out_square(cells, seed);
    square.uv.values.col(0) = (square.uv.values.col(0).array() - 0.5).abs();
    return square;
}

void expect_identity(const MatchResult& result, Index first = 0) {
    for (Index v = first; v < result.target_from_source.source_size(); ++v)
        ASSERT_EQ(result.target_from_source[v], v);
}

TEST(MatchUv, RefusesWhatHasNoUsableCoordinates) {
    const LaidOut square = test::laid_out_square(4, 1);
    const auto expect_refused = [&](LaidOut source, const std::string& part) {
        test::expect_error<InvalidInput>([&] { matched(source, square); }, part);
    };
    expect_refused({square.mesh, {}}, "the source has no texture coordinates");
    test::expect_error<InvalidInput>(
        [&] {
            matched(square, {square.mesh, {}});
        },
        "the target has no texture coordinates");
    LaidOut bad = square;
    bad.uv.corners(0, 0) = 25;
    expect_refused(bad, "do not fit the source");
    bad = square;
    bad.uv.corners.conservativeResize(3, 3);
    expect_refused(bad, "do not fit the source");
    for (const double number : {std::numeric_limits<double>::quiet_NaN(), 1e300}) {
        bad = square;
        bad.uv.values(7, 1) = number;
        expect_refused(bad, "row 7 of the texture coordinates of the source");
    }
    bad = square;
    bad.uv.values.setConstant(0.5);
    expect_refused(bad, "span no area");
    bad.uv.corners.setConstant(-1);
    expect_refused(bad, "span no area");
    expect_refused(laid_at(square, 3, 0.5), "laid out differently");
    bad = square;
    bad.uv.values.col(0) = 1 - bad.uv.values.col(0).array();
    expect_refused(bad, "or one of them is mirrored");
    EXPECT_THROW(match_uv({}, square.mesh, {.source = square.uv, .target = square.uv}), InvalidInput);
}

// Every quad shows the whole image.
TEST(MatchUv, TexturesThatRepeatTellNothing) {
    LaidOut square = test::laid_out_square(24, 1);
    const CornerAttribute places = square.uv;
    square.uv = {Matrix(square.mesh.triangles.size(), 2), Triangles(square.mesh.n_triangles(), 3)};
    for (Index t = 0; t < square.mesh.n_triangles(); ++t) {
        const Matrix corners = places.values(places.corners.row(t).transpose().eval(), Eigen::all);
        for (Index c = 0; c < 3; ++c) {
            square.uv.corners(t, c) = 3 * t + c;
            square.uv.values.row(3 * t + c) = corners.row(c) - corners.colwise().minCoeff();
        }
    }
    const MatchResult result = matched(square, square);
    EXPECT_EQ(result.uv->n_undecided, 25 * 25);
    EXPECT_EQ(verdict(result).advice, Advice::do_not_use) << test::lines_of(result.messages);
}

// Limbs that hide others in the image: what is matched is right, or off by an edge where the image shows a
// wall from above, and the rest is said.
TEST(MatchUv, ChartsOverThemselvesAreSeen) {
    const LaidOut source = test::laid_out_character(), target = test::retriangulated(source, 3);
    const MatchResult result = matched(target, source);
    double farthest = 0;
    for (Index v = 0; v < target.mesh.n_vertices(); ++v)
        if (result.confidence[v] > 0)
            farthest = std::max(farthest, (source.mesh.vertices.row(result.target_from_source[v]) -
                                           target.mesh.vertices.row(v))
                                              .norm());
    EXPECT_LT(farthest, 1.5 * mean_edge_length(source.mesh));
    EXPECT_GT(result.uv->n_by_place, 0);
    EXPECT_EQ(verdict(result).advice, Advice::check) << test::lines_of(result.messages);
}

TEST(MatchUv, FindsVerticesOfAnotherTriangulationInAnotherPose) {
    const LaidOut source = test::laid_out_ball(), target = test::retriangulated(source, 3);
    ASSERT_LT(target.mesh.n_vertices(), source.mesh.n_vertices());
    const MatchResult back = matched(bent(target), source);
    EXPECT_EQ(back.target_from_source.image(), target.original_from_mesh);
    EXPECT_EQ(verdict(back).advice, Advice::use) << test::lines_of(back.messages);
    EXPECT_EQ(back.uv->seam_agreement, 1);
    EXPECT_NEAR(back.confidence.minCoeff(), 0.95, 1e-6);
    const MatchResult result = matched(bent(source), target);
    EXPECT_EQ(verdict(result).advice, Advice::use) << test::lines_of(result.messages);
    const Points images = image_positions(result.uv->surface, target.mesh);
    // As far as collapsed vertices lie from the flatter surface.
    const double edge = mean_edge_length(target.mesh);
    EXPECT_LT((images - source.mesh.vertices).rowwise().norm().mean(), edge / 4);
    EXPECT_LT((images - source.mesh.vertices).rowwise().norm().maxCoeff(), edge);
}

// Whatever the method: the point that a vertex goes to has its coordinates.
TEST(MatchUv, ImagesHaveTheCoordinatesOfTheirVertices) {
    const LaidOut source = test::laid_out_ball(), target = test::retriangulated(source, 5);
    const UvResult found = match_uv(source.mesh, target.mesh, {.source = source.uv, .target = target.uv});
    std::vector<double> nearest(static_cast<std::size_t>(source.mesh.n_vertices()), 1);
    for (Index t = 0; t < source.mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Index v = source.mesh.triangles(t, c);
            const SurfacePoint& point = found.surface[v];
            Eigen::RowVector2d image = Eigen::RowVector2d::Zero();
            for (int k = 0; k < 3; ++k)
                image += point.weights[k] * target.uv.values.row(target.uv.corners(point.triangle, k));
            nearest[static_cast<std::size_t>(v)] =
                std::min(nearest[static_cast<std::size_t>(v)],
                         (image - source.uv.values.row(source.uv.corners(t, c))).norm());
        }
    for (const double distance : nearest) EXPECT_LT(distance, 1e-6);
}

// As mirrored halves are laid out.
TEST(MatchUv, HalvesFoldedOverOneAnotherStayApart) {
    const LaidOut source = folded(8, 1), target = bent(folded(8, 2));
    const MatchResult result = matched(source, target);
    expect_identity(result);
    EXPECT_EQ(result.uv->n_by_place, 0);
    EXPECT_EQ(verdict(result).advice, Advice::use) << test::lines_of(result.messages);
}

// Two alike parts on one place of the image, beside one on a place of its own, which shows how the target has
// moved: by just the distance between the two.
TEST(MatchUv, OfChartsOverOneAnotherPlaceDecides) {
    const auto parts = [](std::uint64_t seed) {
        const LaidOut one = test::laid_out_square(4, seed);
        return joined(joined(laid_at(one, 2, 0), moved(one, 3)), moved(one, 6));
    };
    const LaidOut source = parts(1), target = moved(parts(2), 3);
    const MatchResult result = matched(source, target);
    expect_identity(result);
    EXPECT_EQ(result.uv->n_by_place, 50);
    EXPECT_LT(result.confidence[30], result.confidence[10]);
    EXPECT_EQ(verdict(result).advice, Advice::use) << test::lines_of(result.messages);
}

TEST(MatchUv, WherePlaceDoesNotDecideVerticesStayUnmatched) {
    const auto parts = [](std::uint64_t seed) {
        const LaidOut one = test::laid_out_square(4, seed);
        return joined(one, moved(one, 3));
    };
    const LaidOut source = parts(1), target = moved(parts(2), 1.5);
    const MatchResult result = matched(source, target);
    for (Index v = 0; v < 25; ++v) {
        EXPECT_EQ(result.target_from_source[v], v);
        EXPECT_EQ(result.target_from_source[v + 25], VertexMap::unmatched);  // half-way between both
    }
    EXPECT_EQ(result.uv->n_undecided, 25);
    EXPECT_EQ(verdict(result).advice, Advice::check) << test::lines_of(result.messages);
    EXPECT_TRUE(contains(result.messages, MessageCode::layout_overlaps));
}

TEST(MatchUv, LayoutsThatDifferAreNotToBeUsed) {
    const LaidOut source = test::laid_out_ball();
    LaidOut turned = source, smaller = source;
    turned.uv.values = 1 - turned.uv.values.array();
    smaller.uv.values *= 0.7;
    for (const LaidOut& target : {turned, smaller}) {
        const MatchResult result = matched(source, target);
        EXPECT_FALSE(laid_out_alike(*result.uv));
        EXPECT_EQ(verdict(result).advice, Advice::do_not_use) << test::lines_of(result.messages);
    }
}

TEST(MatchUv, CoordinatesBesideAChartTakeItsEdge) {
    const LaidOut square = test::laid_out_square(4, 1);
    LaidOut wider = square;
    wider.uv.values.array() += (square.uv.values.array() - 0.5) * 0.01;
    const MatchResult result = matched(wider, square);
    expect_identity(result);
    EXPECT_GT(result.confidence.minCoeff(), 0);
    EXPECT_LT(result.confidence[0], result.confidence[12]);
}

TEST(MatchUv, TilesOfTheImageAreApart) {
    const LaidOut one = test::laid_out_square(4, 1), other = test::laid_out_square(4, 2);
    const MatchResult result =
        matched(joined(one, laid_at(moved(one, 3), 1, 0)), joined(laid_at(moved(other, 3), 1, 0), other));
    for (Index v = 0; v < 25; ++v) {
        EXPECT_EQ(result.target_from_source[v], v + 25);
        EXPECT_EQ(result.target_from_source[v + 25], v);
    }
}

// One shows a part of the other.
TEST(MatchUv, WhatTheTargetLacksIsUnmatched) {
    const LaidOut one = test::laid_out_square(4, 1), other = laid_at(moved(one, 3), 2, 0);
    const MatchResult result = matched(joined(one, other), test::laid_out_square(4, 2));
    EXPECT_EQ(count_matched(result.target_from_source), 25);
    EXPECT_EQ(result.uv->target_share, 1);
    EXPECT_EQ(verdict(result).advice, Advice::use) << test::lines_of(result.messages);
}

TEST(MatchUv, RefusesWhatItDoesNotFollow) {
    const LaidOut square = test::laid_out_square(2, 1);
    MatchOptions options{.method = MatchMethod::uv, .uv = {.source = square.uv, .target = square.uv}};
    options.spectral.landmarks = {{0, 0}};
    test::expect_error<InvalidInput>([&] { match(square.mesh, square.mesh, options); }, "landmarks");
}

}  // namespace
}  // namespace counterpart
