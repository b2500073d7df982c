// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/edited_map.hpp"
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/render/color.hpp>
#include <counterpart/render/figures.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart::render {
namespace {

TEST(Carry, TakesEachValueToItsPartner) {
    const TriangleMesh source = make_icosphere(3);
    const test::DisguisedMesh target = test::shuffled(source, 7);
    const Points carried = transfer_to_target(source.vertices, target.mesh_from_original, target.mesh);
    EXPECT_EQ(carried, target.mesh.vertices);
    test::expect_error<InvalidInput>(
        [&] { transfer_to_target(source.vertices, identity_map(3), target.mesh); }, "");
}

TEST(Carry, FillsSmallHolesAndLeavesLargeOnes) {
    const TriangleMesh grid = make_grid(20, 20);
    const VertexMap map = test::edited(identity_map(grid.n_vertices()), [&](std::vector<Index>& image) {
        for (Index v = 0; v < grid.n_vertices(); ++v)
            if (grid.vertices(v, 0) > 0.52) image[static_cast<std::size_t>(v)] = VertexMap::unmatched;
    });
    const Points carried = transfer_to_target(grid.vertices, map, grid);
    int filled = 0, empty = 0;
    for (Index v = 0; v < grid.n_vertices(); ++v) {
        if (grid.vertices(v, 0) > 0.52) std::isnan(carried(v, 0)) ? ++empty : ++filled;
    }
    EXPECT_GE(filled, 60);
    EXPECT_GE(empty, 100);
}

TEST(Lines, AreSampledBySeed) {
    const TriangleMesh sphere = make_icosphere(3);
    const PlacedMesh placed{sphere, Placement(sphere, find_camera(sphere))};
    const VertexMap map = identity_map(sphere.n_vertices());
    const Scene scene = line_scene(placed, placed, map, {.count = 20, .seed = 1});
    EXPECT_EQ(scene.tubes.size(), 20u);
    EXPECT_EQ(scene.dots.size(), 40u);
    EXPECT_EQ(scene.dots[5].center, line_scene(placed, placed, map, {.count = 20, .seed = 1}).dots[5].center);
    EXPECT_NE(scene.dots[4].center, line_scene(placed, placed, map, {.count = 20, .seed = 2}).dots[4].center);
    EXPECT_GT(line_scene(placed, placed, map, {.count = 0}).tubes.size(), 150u);
}

TEST(Colors, AreMonotoneInLightness) {
    const auto lightness = [](const Color& c) { return c.dot(Color(0.2126, 0.7152, 0.0722)); };
    for (const std::string& name : colormap_names()) {
        const Colormap map = colormap_from_name(name);
        const double direction = lightness(sample(map, 1)) - lightness(sample(map, 0));
        for (int i = 0; i < 50; ++i)
            EXPECT_GT((lightness(sample(map, (i + 1) / 50.0)) - lightness(sample(map, i / 50.0))) * direction,
                      0);
    }
    EXPECT_EQ(sample(Colormap::magma, std::nan("")), no_value_color());
    test::expect_error<InvalidInput>([] { colormap_from_name("jet"); }, "viridis");
}

TEST(ValueSurface, RefusesWhatDoesNotFit) {
    const TriangleMesh sphere = make_icosphere(1);
    const PlacedMesh placed{sphere, Placement(sphere, find_camera(sphere))};
    test::expect_error<InvalidInput>([&] { value_surface(placed, Vector::Zero(3), 1, Colormap::magma); },
                                     "42");
    test::expect_error<InvalidInput>([&] { value_surface(placed, Vector::Zero(42), 0, Colormap::magma); },
                                     "positive");
}

}  // namespace
}  // namespace counterpart::render
