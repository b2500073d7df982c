// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/render/charts.hpp>

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart::render {
namespace {

using test::expect_error;

TEST(ErrorChart, RefusesCurvesThatAreNone) {
    expect_error<InvalidInput>([] { error_chart({}); }, "at least one");
    expect_error<InvalidInput>([] { error_chart({{"a", {0, 1}, {1}, 0}}); }, "'a'");
    expect_error<InvalidInput>([] { error_chart({{"a", {0, 1}, {0, 1}, 0}}, {.width = 10}); }, "300");
    expect_error<InvalidInput>([] { error_chart({{"a", {0, 1}, {0, 1}, 0}}, {.max_error = -1}); }, "largest");
}

TEST(ErrorChart, NamesAxesAndMapsInSvg) {
    const std::string svg = to_svg(error_chart({{"a<b", {0, 5, 10}, {0.1, 0.8, 1}, 2.5}}));
    for (const char* part : {"geodesic error", "vertices within the error", "a&lt;b (mean 2.50)", "</svg>"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
}

TEST(ErrorChart, OtherCurvesGiveOtherPictures) {
    const auto picture = [](double middle) {
        const Drawing drawing =
            error_chart({{"m", {0, 5, 10}, {0, middle, 1}, 1}}, {.width = 300, .height = 200});
        Image image(drawing.width, drawing.height, {1, 1, 1});
        draw(drawing, image);
        return image;
    };
    EXPECT_EQ(picture(0.5), picture(0.5));
    EXPECT_NE(picture(0.5), picture(0.9));
}

TEST(RoundTicks, AreRoundAndFew) {
    EXPECT_EQ(round_ticks(10, 10).size(), 11u);
    EXPECT_EQ(round_ticks(25, 6), (std::vector<double>{0, 5, 10, 15, 20, 25}));
    for (const double max : {0.013, 0.7, 3.0, 99.0, 12345.0}) {
        EXPECT_LE(round_ticks(max, 6).size(), 7u) << max;
        EXPECT_GE(round_ticks(max, 6).size(), 3u) << max;
    }
}

TEST(MatrixPicture, ShowsDistancesInOneScale) {
    expect_error<InvalidInput>([] { matrix_picture({}, {}, 400, 300); }, "at least one");
    expect_error<InvalidInput>([] { matrix_picture({Matrix()}, {"a"}, 400, 300); }, "empty");
    Matrix near = Matrix::Zero(2, 2), far = Matrix::Constant(2, 2, 3.0);
    far(0, 0) = std::numeric_limits<double>::infinity();
    const Image image = matrix_picture({near, far}, {"near", "far"}, 400, 300);
    EXPECT_LT((image.at(60, 60) - sample(Colormap::viridis, 0)).norm(), 0.01);
    EXPECT_LT((image.at(340, 130) - sample(Colormap::viridis, 1)).norm(), 0.01);
    EXPECT_LT((image.at(240, 60) - no_value_color()).norm(), 0.01);
}

TEST(Text, IsDrawnWhereItIsSaidToBe) {
    const double width = text_width("Wide text", 20);
    Image image(200, 60, {1, 1, 1});
    draw({200, 60, {Text{{20, 40}, "Wide text", 20, {0, 0, 0}}}}, image);
    const Image white(200, 60, {1, 1, 1});
    int left = 200, right = 0;
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 200; ++x)
            if (image.at(x, y) != white.at(x, y)) left = std::min(left, x), right = std::max(right, x);
    EXPECT_NEAR(left, 20, 3);
    EXPECT_NEAR(right, 20 + width, 3);
}

}  // namespace
}  // namespace counterpart::render
