// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/render/figures.hpp>
#include <counterpart/render/scene.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart::render {
namespace {

using test::expect_error;

const RenderOptions small{.width = 120, .height = 80};

PlacedMesh placed(const TriangleMesh& mesh) { return {mesh, Placement(mesh, find_camera(mesh))}; }

Scene torus_scene(Texture texture) {
    static const TriangleMesh torus = make_torus(48, 24);
    std::vector<Placement> places(2, Placement(torus, find_camera(torus, {.direction = "30,35"})));
    arrange_in_row(places);
    return texture_scene({torus, places[0]}, {torus, places[1]}, identity_map(torus.n_vertices()), texture);
}

/// Mean difference of the channels, 0 .. 255.
double difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.rgb.size(), b.rgb.size()); ++i)
        sum += std::abs(a.rgb[i] - b.rgb[i]);
    return sum / static_cast<double>(a.rgb.size());
}

/// Mean difference of the channels where either picture shows more than its background, 0 .. 255.
double difference_of_what_is_drawn(const Image& a, const Image& b) {
    EXPECT_EQ(a.rgb.size(), b.rgb.size());
    double sum = 0, count = 0;
    for (std::size_t i = 0; i + 2 < std::min(a.rgb.size(), b.rgb.size()); i += 3) {
        const auto is_background = [&](const Image& image) {
            return std::equal(&image.rgb[i], &image.rgb[i] + 3, image.rgb.begin());
        };
        if (is_background(a) && is_background(b)) continue;
        for (std::size_t k = i; k < i + 3; ++k) sum += std::abs(a.rgb[k] - b.rgb[k]);
        count += 3;
    }
    return sum / count;
}

/// The picture kept under this name. Run with COUNTERPART_UPDATE_IMAGES=1 to replace it by `now`.
Image stored(const std::string& name, const Image& now) {
    const std::filesystem::path file = std::filesystem::path(COUNTERPART_STORED_IMAGES) / name;
    if (std::getenv("COUNTERPART_UPDATE_IMAGES") != nullptr) write_file(encode_png(now), file);
    std::ifstream in(file, std::ios::binary);
    return decode_png(std::string(std::istreambuf_iterator<char>(in), {}));
}

TEST(Render, RefusesWhatCannotBeDrawn) {
    expect_error<InvalidInput>([] { render({}, small); }, "empty");
    Scene scene;
    scene.surfaces.push_back({make_icosphere(1), Points::Zero(3, 3), {}});
    expect_error<InvalidInput>([&] { render(scene, small); }, "attributes");
    scene.surfaces[0].attributes = Points::Zero(42, 3);
    expect_error<InvalidInput>([&] { render(scene, {.width = 0}); }, "pixels");
    expect_error<InvalidInput>([&] { render(scene, {.margin = 0.5}); }, "margin");
    expect_error<InvalidInput>([&] { render(scene, {.bottom = 900}); }, "bottom");
    expect_error<InvalidInput>([&] { render(scene, {.occlusion_rays = 0}); }, "rays");
    scene.surfaces[0].mesh.vertices(0, 0) = 1e16;
    expect_error<InvalidInput>([&] { render(scene, small); }, "1e15");
    scene.surfaces[0].mesh.vertices(0, 0) = std::numeric_limits<double>::infinity();
    EXPECT_THROW(render(scene, small), InvalidInput);
    scene.surfaces.clear();
    scene.dots.push_back({Eigen::RowVector3d::Zero(), 1e16, Color(0, 0, 0)});
    expect_error<InvalidInput>([&] { render(scene, small); }, "1e15");
}

TEST(Render, SameBytesForAnyNumberOfThreads) {
    RenderOptions one = small, three = small;
    one.n_threads = 1, three.n_threads = 3;
    const Scene scene = torus_scene(Texture::checker);
    EXPECT_EQ(render(scene, one), render(scene, three));
}

TEST(Render, LooksAsStored) {
    for (const auto& [name, texture] :
         {std::pair{"torus_colors.png", Texture::colors}, {"torus_checker.png", Texture::checker}}) {
        const Image now = render(torus_scene(texture), small);
        EXPECT_LT(difference_of_what_is_drawn(now, stored(name, now)), 1) << name;
    }
}

TEST(Render, OtherTexturesDiffer) {
    EXPECT_GT(
        difference(render(torus_scene(Texture::colors), small), render(torus_scene(Texture::checker), small)),
        4);
}

TEST(Render, DotsAndTubesHideWhatIsBehindThem) {
    const TriangleMesh sphere = make_icosphere(3);
    Scene scene{{plain_surface(sphere, placed(sphere).placement)}, {}, {}};
    const Image bare = render(scene, small);
    scene.dots.push_back({{0, 0, 1}, 0.1, {1, 0, 0}});
    scene.tubes.push_back({{-0.1, 0.15, 1}, {0.1, 0.15, 1}, 0.03, {0, 0, 1}});
    const Image front = render(scene, small);
    const Color dot = front.at(60, 40);
    EXPECT_GT(dot[0], 3 * dot[1]);
    scene.dots[0].center.z() = -1;
    scene.tubes[0].from.z() = scene.tubes[0].to.z() = -1;
    EXPECT_LT(difference(render(scene, small), bare), 0.01);
}

TEST(Fit, KeepsAllWithinTheMargins) {
    const Scene scene = torus_scene(Texture::colors);
    const RenderOptions options{.width = 300, .height = 200, .bottom = 40};
    const Frame frame = fit(scene, options);
    for (const Surface& surface : scene.surfaces) {
        for (Index v = 0; v < surface.mesh.n_vertices(); ++v) {
            const Eigen::RowVector2d pixel = frame.pixel(surface.mesh.vertices.row(v));
            EXPECT_GE(pixel.x(), 0.039 * 300);
            EXPECT_LE(pixel.x(), 0.961 * 300);
            EXPECT_LE(pixel.y(), 0.961 * 200 - 40 + 1e-9);
        }
    }
}

}  // namespace
}  // namespace counterpart::render
