// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/byte_order.hpp"
#include "io/gltf_document.hpp"
#include "support/gltf_accessors.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/gltf.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <cmath>
#include <filesystem>
#include <functional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace counterpart::io {
namespace {

using Json = nlohmann::ordered_json;

// A square of two triangles, cut along its diagonal by a texture seam: six vertices for four points, bound to
// two joints, with one blend shape.
struct Square {
    Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0}};
    std::string bytes;

    Square() {
        const Json position = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}, 3);
        const Json uv = floats({0, 0, .5, 0, .5, 1, .5, 0, 1, 1, .5, 1}, 2);
        const Json weights =
            floats({1, 0, 0, 0, .5, .5, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, .25, .75, 0, 0}, 4);
        const Json smile = floats({0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 1, 0, 0, 3, 0, 0, 4}, 3);
        const std::size_t joints_at = bytes.size();
        for (int v = 0; v < 6; ++v) bytes += std::string("\0\1\0\0", 4);
        const Json joints = accessor(joints_at, 5121, "VEC4", 6);
        const std::size_t indices_at = bytes.size();
        for (int i = 0; i < 6; ++i) append_number(bytes, static_cast<std::uint16_t>(i));
        const Json indices = accessor(indices_at, 5123, "SCALAR", 6);
        json["meshes"] = {
            {{"primitives",
              {{{"attributes",
                 {{"POSITION", position}, {"TEXCOORD_0", uv}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
                {"indices", indices},
                {"targets", {{{"POSITION", smile}}}}}}},
             {"extras", {{"targetNames", {"smile"}}}}}};
        json["nodes"] = {{{"mesh", 0}, {"translation", {0, 0, 5}}}};
        json["scenes"] = {{{"nodes", {0}}}};
    }

    Json floats(const std::vector<float>& numbers, int width) {
        const std::size_t at = bytes.size();
        for (const float number : numbers) append_number(bytes, number);
        const char* type = width == 2 ? "VEC2" : width == 3 ? "VEC3" : "VEC4";
        return accessor(at, 5126, type, numbers.size() / static_cast<std::size_t>(width));
    }
    Json accessor(std::size_t at, int component, const char* type, std::size_t count) {
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes.size() - at}});
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                     {"componentType", component},
                                     {"type", type},
                                     {"count", count}});
        return json["accessors"].size() - 1;
    }
    std::string glb() {
        json["buffers"] = {{{"byteLength", bytes.size()}}};
        std::string text = json.dump(), binary = bytes, file = "glTF";
        text.resize((text.size() + 3) / 4 * 4, ' ');
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        append_number(file, std::uint32_t{2});
        append_number(file, static_cast<std::uint32_t>(28 + text.size() + binary.size()));
        append_number(file, static_cast<std::uint32_t>(text.size()));
        file += "JSON" + text;
        append_number(file, static_cast<std::uint32_t>(binary.size()));
        return file + std::string("BIN\0", 4) + binary;
    }
};

const std::filesystem::path gltf_path =
    std::filesystem::temp_directory_path() / ("square" + std::to_string(getpid()) + ".glb");

GltfFile read_gltf_bytes(const std::string& bytes) {
    write_file(bytes, gltf_path);
    return read_gltf(gltf_path);
}

std::string gltf_error_of(const std::string& bytes) {
    try {
        read_gltf_bytes(bytes);
        return "read without an error";
    } catch (const IoError& error) {
        return error.what();
    }
}

TEST(Gltf, SeamsAreWeldedAndAttributesKept) {
    const GltfFile square = read_gltf_bytes(Square().glb());
    const AttributedMesh& content = square.content;
    EXPECT_EQ(content.mesh.vertices, (Points{{0, 0, 5}, {1, 0, 5}, {1, 1, 5}, {0, 1, 5}}));
    EXPECT_EQ(content.mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(square.vertex_from_file, (std::vector<Index>{0, 1, 2, 0, 2, 3}));
    ASSERT_EQ(square.notices.size(), 1U);
    ASSERT_EQ(content.texture_coordinates.size(), 1U);
    EXPECT_EQ(content.texture_coordinates[0].corners, (Triangles{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(content.texture_coordinates[0].values(3, 0), 0.5);
    EXPECT_EQ(content.skin.joints(1, 1), 1);
    EXPECT_EQ(content.skin.weights.row(3), (Eigen::RowVector4d(0.25, 0.75, 0, 0)));
    ASSERT_EQ(content.morphs.size(), 1U);
    EXPECT_EQ(content.morphs[0].name, "smile");
    EXPECT_EQ(content.morphs[0].displacements.col(2), (Vector{{1, 2, 3, 4}}));
    EXPECT_EQ(read_mesh(gltf_path).mesh.vertices, content.mesh.vertices);
}

TEST(Gltf, SkinnedMeshesStayAsTheyAreBound) {
    Square square;
    square.json["nodes"][0]["skin"] = 0;
    EXPECT_EQ(read_gltf_bytes(square.glb()).content.mesh.vertices.col(2).maxCoeff(), 0);
}

TEST(Gltf, PointsThatMorphApartAreNotWelded) {
    Square square;
    square.bytes[static_cast<std::size_t>(square.json["bufferViews"][3]["byteOffset"]) + 4 * 11 + 2] ^= 1;
    EXPECT_EQ(read_gltf_bytes(square.glb()).content.mesh.n_vertices(), 5);
}

TEST(Gltf, StripsAndFansKeepTheWinding) {
    for (const int mode : {5, 6}) {
        Square square;
        Json& primitive = square.json["meshes"][0]["primitives"][0];
        primitive["mode"] = mode;
        primitive.erase("indices");
        const Triangles triangles = read_gltf_bytes(square.glb()).content.mesh.triangles;
        ASSERT_EQ(triangles.rows(), 4);
        EXPECT_EQ(triangles.row(0), (Eigen::RowVector3i(0, 1, 2)));
        EXPECT_EQ(triangles.row(1), mode == 5 ? Eigen::RowVector3i(1, 0, 2) : Eigen::RowVector3i(0, 2, 0));
    }
}

TEST(Gltf, SaysWhatIsWrong) {
    using Edit = std::function<void(Json&)>;
    const std::vector<std::pair<Edit, std::string>> cases = {
        {[](Json& j) { j["asset"]["version"] = "1.0"; }, "glTF 1.0 is not supported"},
        {[](Json& j) { j.erase("asset"); }, "states no version"},
        {[](Json& j) { j["extensionsRequired"] = {"KHR_draco_mesh_compression"}; },
         "KHR_draco_mesh_compression"},
        {[](Json& j) { j["accessors"][0]["count"] = 100; }, "accessor 0: 100 rows do not fit"},
        {[](Json& j) { j["accessors"][0]["count"] = -1; }, "'count' must be a whole number"},
        {[](Json& j) { j["accessors"][0]["count"] = 1e15; }, "far more numbers"},
        {[](Json& j) { j["accessors"][0]["type"] = "VEC2"; }, "where VEC3 is needed"},
        {[](Json& j) { j["accessors"][0]["componentType"] = 7; }, "unknown componentType 7"},
        {[](Json& j) { j["accessors"][0]["byteOffset"] = 8; }, "do not fit"},
        {[](Json& j) { j["bufferViews"][0]["buffer"] = 3; }, "no buffer 3"},
        {[](Json& j) { j["bufferViews"][0]["byteOffset"] = 1e12; }, "do not fit"},
        {[](Json& j) { j["nodes"][0]["mesh"] = 9; }, "no element 9 in 'meshes'"},
        {[](Json& j) { j["nodes"][0]["children"] = {0}; }, "do not form a tree"},
        {[](Json& j) { j["meshes"][0]["primitives"][0]["mode"] = 1; }, "no triangles"},
        {[](Json& j) { j["meshes"][0]["primitives"] = "none"; }, "an object with"},
        {[](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"] = 5; },
         "where VEC4 is needed"},
        {[](Json& j) { j["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0"); },
         "needs its WEIGHTS"},
        {[](Json& j) { j["accessors"][3]["count"] = 5; }, "a morph target has 5 rows for 6 vertices"},
        {[](Json& j) { j["accessors"][1]["count"] = 5; }, "TEXCOORD_0 has 5 rows for 6 vertices"},
        {[](Json& j) { j["meshes"][0]["primitives"][0]["indices"] = 17; }, "no element 17 in 'accessors'"},
    };
    for (const auto& [edit, message] : cases) {
        Square square;
        edit(square.json);
        EXPECT_NE(gltf_error_of(square.glb()).find(message), std::string::npos)
            << message << " | " << gltf_error_of(square.glb());
    }
    Square outside;
    outside.json["buffers"] = {{{"uri", "gone.bin"}, {"byteLength", 10}}};
    EXPECT_NE(gltf_error_of(outside.json.dump()).find("buffer 0 is missing: there is no file"),
              std::string::npos);
    EXPECT_NE(gltf_error_of("glTF").find("cut off"), std::string::npos);
    EXPECT_NE(gltf_error_of("{").find("JSON is damaged"), std::string::npos);
    std::filesystem::remove(gltf_path);
}

TEST(Gltf, AnyTruncationIsAnError) {
    const std::string bytes = Square().glb();
    for (std::size_t size = 0; size < bytes.size() - 4; size += 7)
        EXPECT_THROW(read_gltf_bytes(bytes.substr(0, size)), IoError) << size;
    std::filesystem::remove(gltf_path);
}

// What is written and read again.
GltfFile written_gltf(const AttributedMesh& content, const char* extension = ".glb") {
    const test::TemporaryFolder folder;
    const std::filesystem::path copy = (folder / "copy").replace_extension(extension);
    write_gltf(content, copy);
    return read_gltf(copy);
}

TEST(WriteGltf, WhatDidNotChangeKeepsItsAccessors) {
    const test::TemporaryFolder folder;
    for (const bool placed : {false, true}) {
        Square square;
        // A joint that no weight makes use of, and what the program knows nothing of.
        square.bytes[static_cast<std::size_t>(square.json["bufferViews"][4]["byteOffset"]) + 2] = 1;
        square.json["accessors"][0]["min"] = {0, 0, 0};
        square.json["extras"] = {{"answer", 42.0}};
        if (placed)
            square.json["nodes"][0].update(Json{{"scale", {-2, 1, .3}}, {"rotation", {0, .6, 0, .8}}});
        const GltfFile before = read_gltf_bytes(square.glb());
        for (const char* name : {"copy.glb", "copy.gltf"}) {
            write_gltf(before.content, folder / name);
            EXPECT_EQ(test::accessor_difference(gltf_path, folder / name), "");
            EXPECT_EQ(read_gltf(folder / name).content.mesh.vertices, before.content.mesh.vertices);
        }
    }
}

TEST(WriteGltf, OnlyWhatChangedGetsNewAccessors) {
    Square square;
    square.json["nodes"][0]["scale"] = {2, 2, 2};
    GltfFile before = read_gltf_bytes(square.glb());
    before.content.mesh.vertices(2, 2) += 0.5;
    before.content.morphs[0].name = "grin";
    const GltfFile after = written_gltf(before.content);
    EXPECT_EQ(after.content.mesh.vertices, before.content.mesh.vertices);
    EXPECT_EQ(after.vertex_from_file, before.vertex_from_file);
    EXPECT_EQ(after.content.morphs[0].name, "grin");
    const test::TemporaryFolder folder;
    write_gltf(before.content, folder / "copy.glb");
    EXPECT_EQ(test::accessor_difference(gltf_path, folder / "copy.glb"), "the number of accessors");
}

TEST(WriteGltf, CornersThatComeApartSplitVertices) {
    GltfFile before = read_gltf_bytes(Square().glb());
    CornerAttribute& coordinates = before.content.texture_coordinates[0];
    coordinates.values.conservativeResize(7, 2);
    coordinates.values.row(6) << 0.25, 0.75;
    coordinates.corners(0, 1) = 6;
    GltfFile after = written_gltf(before.content);
    EXPECT_EQ(after.vertex_from_file.size(), 6U);
    // A second surface over the square, with a seam where there was none.
    before.content.mesh.triangles = Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}};
    coordinates.corners = Triangles{{0, 6, 2}, {3, 4, 5}, {0, 1, 5}};
    before.content.parts.assign(3, 0);
    after = written_gltf(before.content);
    EXPECT_EQ(after.content.mesh.triangles, before.content.mesh.triangles);
    EXPECT_EQ(after.content.mesh.vertices, before.content.mesh.vertices);
    EXPECT_EQ(after.vertex_from_file, (std::vector<Index>{0, 0, 1, 1, 2, 2, 3}));
    EXPECT_EQ(after.content.skin.weights, before.content.skin.weights);
    EXPECT_EQ(after.content.morphs[0].displacements, before.content.morphs[0].displacements);
    const CornerAttribute& now = after.content.texture_coordinates[0];
    for (int t = 0; t < 3; ++t)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(now.values.row(now.corners(t, c)), coordinates.values.row(coordinates.corners(t, c)));
}

TEST(WriteGltf, AMeshFromElsewhereGetsAFileOfItsOwn) {
    AttributedMesh content;
    content.mesh = {Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, Triangles{{0, 1, 2}, {0, 2, 3}}};
    content.normals = {Matrix{{0, 0, 1}, {0, 1, 0}}, Triangles{{0, 0, 0}, {1, 1, 1}}};
    content.colors = {{Matrix{{1, 0.5, 0, 1}}, Triangles{{0, 0, 0}, {0, 0, 0}}}};
    content.morphs = {{"up", Points::Ones(4, 3)}, {"down", -Points::Ones(4, 3)}};
    content.parts = {0, 1};
    for (const char* extension : {".glb", ".gltf"}) {
        const AttributedMesh after = written_gltf(content, extension).content;
        EXPECT_EQ(after.mesh.vertices, content.mesh.vertices);
        EXPECT_EQ(after.mesh.triangles, content.mesh.triangles);
        EXPECT_EQ(after.parts, content.parts);
        ASSERT_EQ(after.morphs.size(), 2U);
        EXPECT_EQ(after.morphs[1].name, "down");
        EXPECT_EQ(after.morphs[1].displacements, content.morphs[1].displacements);
        EXPECT_EQ(after.normals.values.row(after.normals.corners(1, 2)), content.normals.values.row(1));
        EXPECT_EQ(after.colors[0].values.row(0), content.colors[0].values.row(0));
    }
}

TEST(WriteGltf, SaysWhatIsWrongAndWritesNothing) {
    Square square;
    square.json["images"] = {{{"uri", "skin.png"}}};
    const AttributedMesh textured = read_gltf_bytes(square.glb()).content;
    AttributedMesh plain;
    plain.mesh = textured.mesh;
    const auto changed = [](AttributedMesh content, const std::function<void(AttributedMesh&)>& change) {
        change(content);
        return content;
    };
    const std::vector<std::pair<AttributedMesh, std::string>> cases = {
        {textured, "the texture image 0 is missing"},
        {changed(plain,
                 [](AttributedMesh& m) {
                     m.morphs = {{"smile", Points::Zero(3, 3)}};
                 }),
         "the morph target 'smile' has 3 rows where the mesh has 4 vertices"},
        {changed(plain, [&](AttributedMesh& m) { m.skin = textured.skin; }), "no skeleton"},
        {changed(plain, [](AttributedMesh& m) { m.mesh.triangles.resize(0, 3); }), "no faces"},
        {changed(plain, [](AttributedMesh& m) { m.parts = {0}; }), "1 part labels for 2 triangles"},
        {changed(plain,
                 [](AttributedMesh& m) {
                     m.normals = {Matrix{{0, 0, 1}}, Triangles{{0, 0, 1}, {0, 0, 0}}};
                 }),
         "a row of the normals that does not exist"},
        {changed(plain,
                 [](AttributedMesh& m) {
                     m.colors = {{Matrix{{0, 0, std::nan("")}}, Triangles{{0, 0, 0}, {0, 0, 0}}}};
                 }),
         "COLOR_0 is not finite"},
    };
    const test::TemporaryFolder folder;
    for (const auto& [content, message] : cases) {
        try {
            write_gltf(content, folder / "out.glb");
            ADD_FAILURE() << "written, where expected: " << message;
        } catch (const IoError& error) {
            EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
        }
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "out.glb"));
    std::filesystem::remove(gltf_path);
}

TEST(WriteGltf, WeightsThatSumToZeroAreRefused) {
    Square square;
    square.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, Json::object(), Json::object()};
    square.json["skins"] = {{{"joints", {1, 2}}}};
    AttributedMesh content = read_gltf_bytes(square.glb()).content;
    content.skin.weights.row(2).setZero();
    const test::TemporaryFolder folder;
    EXPECT_THROW(write_gltf(content, folder / "out.glb"), IoError);
    EXPECT_FALSE(std::filesystem::exists(folder / "out.glb"));
    content.skin.weights.row(2) << 0.25, 0.75, 0, 0;
    content.skin.joints.row(2) << 1, 0, 0, 0;
    EXPECT_EQ(written_gltf(content).content.skin.weights, content.skin.weights);
    content.skin.joints(2, 0) = 2;
    EXPECT_THROW(write_gltf(content, folder / "out.glb"), IoError);
}

TEST(WriteGltf, AnAnimationPlaysTheMorphTargetsInTheirOrder) {
    Square square;  // whose own animation moves the weights of another set of shapes
    const Json times = square.floats({0, 1, 0, 1}, 2), weights = square.floats({0, 1, 0, 1}, 2);
    square.json["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}},
         {"samplers", {{{"input", times}, {"output", weights}}}}}};
    AttributedMesh content = read_gltf_bytes(square.glb()).content;
    content.morphs = {{"frame_0001", Points::Ones(4, 3)}, {"frame_0002", Points::Ones(4, 3) * 3}};
    const test::TemporaryFolder folder;
    for (const char* name : {"out.glb", "out.gltf"}) {
        write_gltf(content, folder / name, 4);
        const GltfDocument document = load_gltf(folder / name);
        ASSERT_EQ(document.count("animations"), 1U);
        const GltfJson& animation = document.json["animations"][0];
        ASSERT_EQ(animation["channels"].size(), 1U);
        EXPECT_EQ(animation["channels"][0],
                  GltfJson({{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}));
        const GltfJson& sampler = animation["samplers"][0];
        EXPECT_EQ(sampler["interpolation"], "LINEAR");
        GltfBudget budget(document);
        EXPECT_EQ(read_accessor(document, sampler["input"], "SCALAR", budget), (Matrix{{0}, {0.25}, {0.5}}));
        EXPECT_EQ(read_accessor(document, sampler["output"], "SCALAR", budget),
                  (Matrix{{0}, {0}, {1}, {0}, {0}, {1}}));
        const GltfJson& input = document.json["accessors"][sampler["input"].get<std::size_t>()];
        EXPECT_EQ(input["max"], GltfJson({0.5}));
        EXPECT_EQ(read_gltf(folder / name).content.morphs[1].displacements, content.morphs[1].displacements);
    }
    content.morphs.clear();
    write_gltf(content, folder / "still.glb", 4);
    EXPECT_EQ(load_gltf(folder / "still.glb").count("animations"), 0U);
    EXPECT_THROW(write_gltf(content, folder / "still.glb", -1), InvalidInput);
}

}  // namespace
}  // namespace counterpart::io
