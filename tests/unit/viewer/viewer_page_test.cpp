// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/base64.hpp"
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/viewer/viewer_page.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace counterpart::viewer {
namespace {

using test::expect_error;

TriangleMesh triangle() {
    TriangleMesh mesh;
    mesh.vertices = Points{{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
    mesh.triangles = Triangles{{0, 1, 2}};
    return mesh;
}

std::string element(const std::string& page, const std::string& id) {
    const std::size_t start = page.find('>', page.find("id=\"" + id + "\"")) + 1;
    return page.substr(start, page.find("</script>", start) - start);
}

TEST(Base64, TestVectorsOfRfc4648) {
    EXPECT_EQ(to_base64(""), "");
    EXPECT_EQ(to_base64("f"), "Zg==");
    EXPECT_EQ(to_base64("fo"), "Zm8=");
    EXPECT_EQ(to_base64("foo"), "Zm9v");
    EXPECT_EQ(to_base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(to_base64("\xff\xfe\xfd"), "//79");
}

TEST(ViewerPage, HoldsTheMeshesAsSixteenBitFractionsAndExactNumbers) {
    const std::string page = viewer_page(triangle(), triangle(), {{"m", {{2, 0, -1}, 3}}});
    const auto scene = nlohmann::json::parse(element(page, "scene"));
    EXPECT_EQ(scene["source"]["vertices"], 3);
    EXPECT_EQ(scene["source"]["extent"], (std::vector<double>{2, 4, 0}));
    EXPECT_EQ(scene["source"]["triangle_bytes"], 2);
    // Positions (0,0,0) (65535,0,0) (0,65535,0), two bytes to the multiple of four, triangle 0 1 2, two more;
    // the same for the target; then the map 2, 0, -1.
    using namespace std::string_literals;
    const std::string mesh = "\0\0\0\0\0\0\xff\xff\0\0\0\0\0\0\xff\xff\0\0\0\0"s + "\0\0\1\0\2\0\0\0"s;
    const std::string map = "\2\0\0\0\0\0\0\0\xff\xff\xff\xff"s;
    EXPECT_EQ(element(page, "buffer"), to_base64(mesh + mesh + map));
}

TEST(ViewerPage, HoldsImagesAndColorsCornerByCorner) {
    ViewerOptions options;
    options.source_appearance = {{Matrix{{0, 0}, {0.5, 1}}, Triangles{{0, 1, -1}}}, {"PNG!x"}, {0}, {}};
    options.target_appearance.colors = {Matrix{{1, 0, 0.5}}, Triangles{{0, 0, -1}}};
    const std::string page = viewer_page(triangle(), triangle(), {{"m", identity_map(3)}}, options);
    const auto scene = nlohmann::json::parse(element(page, "scene"));
    // Behind the two meshes of 28 bytes: three pairs of floats, the image's number, the image, three colors.
    EXPECT_EQ(scene["source"]["uv_offset"], 56);
    EXPECT_EQ(scene["source"]["image_of_triangle_offset"], 80);
    EXPECT_EQ(scene["source"]["images"], (nlohmann::json{{{"offset", 84}, {"bytes", 5}}}));
    EXPECT_EQ(scene["target"]["color_offset"], 92);
    EXPECT_FALSE(scene["target"].contains("uv_offset"));
    using namespace std::string_literals;
    const std::string uv = "\0\0\0\0\0\0\0\0\0\0\0\x3f\0\0\x80\x3f\0\0\0\0\0\0\0\0"s;
    const std::string rest = uv + "\0\0\0\0PNG!x\0\0\0"s + "\xff\0\x80\xff\0\x80\xff\xff\xff"s;
    const std::string mesh = "\0\0\0\0\0\0\xff\xff\0\0\0\0\0\0\xff\xff\0\0\0\0"s + "\0\0\1\0\2\0\0\0"s;
    const std::string map = "\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0"s;  // after three bytes to the multiple of four
    EXPECT_EQ(element(page, "buffer"), to_base64(mesh + mesh + rest + map));

    options.source_appearance.image_of_triangle = {1};
    const auto refused = [&] { viewer_page(triangle(), triangle(), {{"m", identity_map(3)}}, options); };
    expect_error<InvalidInput>(refused, "the appearance of the source does not fit");
    options.source_appearance.image_of_triangle = {0};
    options.target_appearance.colors.corners(0, 0) = 1;
    expect_error<InvalidInput>(refused, "the appearance of the target does not fit");
}

TEST(ViewerPage, LargeMeshesTakeFourBytesPerCorner) {
    const TriangleMesh mesh = make_grid(300, 300);
    const std::string page = viewer_page(mesh, triangle(), {{"m", {std::vector<Index>(90601, 0), 3}}});
    EXPECT_EQ(nlohmann::json::parse(element(page, "scene"))["source"]["triangle_bytes"], 4);
}

TEST(ViewerPage, TurnsTheTargetBackOntoTheSource) {
    TriangleMesh turned = triangle();
    turned.vertices.col(0) = -triangle().vertices.col(1);  // a quarter about z: (x, y) -> (-y, x)
    turned.vertices.col(1) = triangle().vertices.col(0);
    const std::string page = viewer_page(triangle(), turned, {{"m", identity_map(3)}});
    const auto q =
        nlohmann::json::parse(element(page, "scene"))["source_from_target"].get<std::vector<double>>();
    EXPECT_NEAR(std::abs(q[2]), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(q[2] * q[3], -0.5, 1e-12);  // a quarter backwards
}

TEST(ViewerPage, NamesCannotEndTheScriptElement) {
    const std::string page = viewer_page(triangle(), triangle(), {{"</script><b>\xff", identity_map(3)}});
    EXPECT_EQ(nlohmann::json::parse(element(page, "scene"))["maps"][0]["name"], "</script><b>\xef\xbf\xbd");
}

TEST(ViewerPage, RefusesWhatDoesNotFit) {
    const auto page = [](const ViewerMap& map, const ViewerOptions& options = {}) {
        return [=] { viewer_page(triangle(), triangle(), {map}, options); };
    };
    expect_error<InvalidInput>([] { viewer_page(triangle(), triangle(), {}); }, "no map");
    expect_error<InvalidInput>(page({"short", identity_map(2)}), "map 'short': the map has 2 entries");
    expect_error<InvalidInput>(page({"far", {{0, 1, 3}, 4}}), "map 'far': the map leads to 4 vertices");
    expect_error<InvalidInput>(page({"e", identity_map(3), {0.0}}), "1 errors for 3 source vertices");
    expect_error<InvalidInput>(page({"m", identity_map(3)}, {.truth = {0, 1}}), "truth: ");
    expect_error<InvalidInput>(page({"m", identity_map(3)}, {.base_vertex = 3}), "base vertex 3");
    TriangleMesh broken = triangle();
    broken.vertices(1, 2) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(viewer_page(broken, triangle(), {{"m", identity_map(3)}}), InvalidInput);
}

}  // namespace
}  // namespace counterpart::viewer
