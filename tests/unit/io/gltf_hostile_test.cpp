// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// glTF files from strangers: what they may name, and what a short one may ask for.
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/gltf.hpp>

#include <bit>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace counterpart {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

// One triangle in nine floats, which lie in `uri`.
Json triangle(const std::string& uri) {
    Json json = {{"asset", {{"version", "2.0"}}}};
    json["buffers"] = {{{"uri", uri}, {"byteLength", 36}}};
    json["bufferViews"] = {{{"buffer", 0}, {"byteLength", 36}}};
    json["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"type", "VEC3"}, {"count", 3}}};
    json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
    return json;
}

std::string floats() {
    std::string bytes;
    for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
        const auto raw = std::bit_cast<std::array<char, 4>>(x);
        bytes.append(raw.data(), raw.size());
    }
    return bytes;
}

const char* const inside =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

// A folder of a model with a secret beside it.
class GltfOfAStranger : public testing::Test {
  protected:
    GltfOfAStranger() {
        fs::create_directories(folder_ / "model" / "textures");
        write_file(floats(), folder_ / "model" / "own.bin");
        write_file(floats(), folder_ / "model" / "textures" / "of it.bin");
        write_file(floats() + "secret", folder_ / "secret");
        fs::create_symlink(folder_ / "secret", folder_ / "model" / "link.bin");
        fs::create_directory_symlink(folder_ / ".", folder_ / "model" / "up");
    }
    fs::path model(const Json& json) const { return folder_.file("model/a.gltf", json.dump()); }
    std::vector<std::string> leading_out() const {
        const std::string secret = (folder_ / "secret").string();
        return {secret,
                "../secret",
                "textures/../../secret",
                "link.bin",
                "up/secret",
                "%2e%2e/secret",
                "..%2Fsecret",
                fmt::format("%2F{}", secret.substr(1)),
                fmt::format("file://{}", secret),
                fmt::format("file:{}", secret),
                "FILE:///etc/passwd",
                "https://example.org/secret"};
    }

    test::TemporaryFolder folder_;
};

TEST_F(GltfOfAStranger, ReadsBuffersOfItsOwnFolderOnly) {
    for (const char* uri : {"own.bin", "./own.bin", "textures/of%20it.bin", "textures/of it.bin"})
        EXPECT_EQ(read_gltf(model(triangle(uri))).content.mesh.n_triangles(), 1) << uri;
    for (const std::string& uri : leading_out()) {
        SCOPED_TRACE(uri);
        test::expect_error<IoError>([&] { read_gltf(model(triangle(uri))); }, "refused unless");
    }
    test::expect_error<IoError>([&] { read_gltf(model(triangle("own.bin%00/../../secret"))); }, "no file");
    test::expect_error<IoError>([&] { read_gltf(model(triangle("textures"))); }, "is missing");
}

TEST_F(GltfOfAStranger, TakesNoImageOfAnotherFolderIn) {
    for (const std::string& uri : leading_out()) {
        SCOPED_TRACE(uri);
        Json json = triangle(inside);
        json["images"] = {{{"uri", uri}, {"mimeType", "image/png"}}};
        test::expect_error<IoError>([&] { read_gltf(model(json)); }, "the texture image 0 is '");
    }
    Json json = triangle(inside);
    json["images"] = {{{"uri", "own.bin"}}, {{"uri", "textures/../own.bin"}}};
    test::expect_error<IoError>([&] { read_gltf(model(json)); }, "the texture image 1 is '");
}

TEST_F(GltfOfAStranger, ReadsOtherFoldersIfTheCallerAllowsIt) {
    for (const char* uri : {"../secret", "link.bin", "up/secret", "%2e%2e/secret"}) {
        Json json = triangle(uri);
        json["images"] = {{{"uri", uri}}, {{"uri", "https://example.org/a.png"}}};
        const GltfFile file = read_gltf(model(json), {.allow_external = true});
        EXPECT_EQ(file.content.mesh.n_triangles(), 1) << uri;
        write_gltf(file.content, folder_ / "out.glb");
        const std::string bytes = read_whole_file(folder_ / "out.glb");
        EXPECT_NE(bytes.find("secret"), std::string::npos) << uri;
        EXPECT_NE(bytes.find("https://example.org/a.png"), std::string::npos) << uri;
    }
    test::expect_error<IoError>(
        [&] { read_gltf(model(triangle("https://example.org/a")), {.allow_external = true}); },
        "buffer 0 lies elsewhere");
}

TEST_F(GltfOfAStranger, AnImageNamedOftenIsStoredOnce) {
    Json json = triangle(inside);
    for (int i = 0; i < 500; ++i) json["images"].push_back({{"uri", i % 2 == 0 ? "own.bin" : "./own.bin"}});
    write_gltf(read_gltf(model(json)).content, folder_ / "out.glb");
    const GltfFile again = read_gltf(folder_ / "out.glb");
    EXPECT_EQ(again.content.mesh.n_triangles(), 1);
    const std::string bytes = read_whole_file(folder_ / "out.glb");
    std::size_t count = 0;
    for (std::size_t at = 0; (at = bytes.find(floats(), at)) != std::string::npos; ++at) ++count;
    EXPECT_EQ(count, 2U);  // the buffer and the image
}

// Reading follows the scene; writing looks at every node.
TEST_F(GltfOfAStranger, ANodeThatNoSceneShowsMayNameNoMeshThatIsNotThere) {
    Json json = triangle(inside);
    json["scenes"] = {{{"nodes", {0}}}};
    json["nodes"] = {{{"mesh", 0}}, {{"mesh", 30}, {"skin", 0}}};
    json["skins"] = {{{"joints", {0}}}};
    const AttributedMesh content = read_gltf(model(json)).content;
    test::expect_error<IoError>([&] { write_gltf(content, folder_ / "out.glb"); },
                                "there is no element 30 in 'meshes'");
    EXPECT_FALSE(fs::exists(folder_ / "out.glb"));
}

TEST_F(GltfOfAStranger, OneFileIsOneBuffer) {
    Json json = triangle("own.bin");
    for (const char* again : {"own.bin", "./own.bin", "o%77n.bin"}) {
        json["buffers"][1] = {{"uri", again}, {"byteLength", 36}};
        test::expect_error<IoError>([&] { read_gltf(model(json)); }, "buffer 1 is the file of another");
    }
}

// None of these takes more memory than an ordinary file of its size, which the sanitizers' limits watch over.
TEST_F(GltfOfAStranger, AShortFileCannotAskForMuch) {
    const auto refused = [&](const Json& json, const char* reason) {
        test::expect_error<IoError>([&] { read_gltf(model(json)); }, reason);
    };
    Json zeros = triangle(inside);
    zeros["accessors"][0] = {{"componentType", 5126},
                             {"type", "VEC3"},
                             {"count", 200'000'000},
                             {"sparse",
                              {{"count", 0},
                               {"indices", {{"bufferView", 0}, {"componentType", 5125}}},
                               {"values", {{"bufferView", 0}}}}}};
    refused(zeros, "far more numbers than a file of its size");

    Json targets = triangle(inside);
    targets["accessors"][0]["count"] = 1'000'000;
    targets["accessors"][0]["sparse"] = zeros["accessors"][0]["sparse"];
    targets["accessors"][0].erase("bufferView");
    Json& primitive = targets["meshes"][0]["primitives"][0];
    for (int i = 0; i < 100; ++i) primitive["targets"].push_back(Json::object());
    refused(targets, "far more numbers");

    Json shared = triangle(inside);
    shared["accessors"][0] = targets["accessors"][0];
    for (int i = 0; i < 100; ++i)
        shared["meshes"][0]["primitives"][static_cast<std::size_t>(i)] = {{"attributes", {{"POSITION", 0}}}};
    refused(shared, "far more numbers");

    Json sets = triangle(inside);
    for (int i = 0; i < 20; ++i)
        sets["meshes"][0]["primitives"][0]["attributes"][fmt::format("COLOR_{}", i)] = 0;
    refused(sets, "has more than 16 COLORs");

    Json names = triangle(inside);
    names["materials"] = {{{"name", std::string(10'000, 'n')}}};
    for (std::size_t i = 0; i < 1000; ++i)
        names["meshes"][0]["primitives"][i] = {{"attributes", {{"POSITION", 0}}}, {"material", 0}};
    refused(names, "far more numbers");
}

TEST_F(GltfOfAStranger, JsonIsBoundedInDepthAndKeys) {
    const auto refused = [&](const std::string& json, const char* reason) {
        test::expect_error<IoError>([&] { read_gltf(folder_.file("model/a.gltf", json)); }, reason);
    };
    const std::string deep(200'000, '[');
    refused("{\"extras\":" + deep, "nested deeper than 64");
    Json material = triangle(inside);
    std::string text = material.dump();
    std::string objects, closing;
    for (int i = 0; i < 100'000; ++i) {
        objects += "{\"aTexture\":";
        closing += '}';
    }
    text.back() = ',';
    refused(text + "\"materials\":[" + objects + "1" + closing + "]}", "nested deeper than 64");

    std::string keys = "{\"extras\":{";
    for (int i = 0; i < 5000; ++i) keys += fmt::format("\"{}\":0,", i);
    refused(keys + "\"a\":0}}", "more than 4096 keys");
    // Each object counts for itself.
    Json many = triangle(inside);
    for (int i = 0; i < 5000; ++i) many["extras"].push_back({{"key", {{"key", i}}}});
    EXPECT_NO_THROW(read_gltf(model(many)));
}

TEST_F(GltfOfAStranger, NumbersThatAreNoNumbersOfElements) {
    Json json = triangle(inside);
    json["scenes"] = {{{"nodes", {1e300}}}};
    json["scene"] = 0;
    json["nodes"] = {{{"mesh", 0}}};
    test::expect_error<IoError>([&] { read_gltf(model(json)); }, "a node must be a whole number");
    json["scenes"] = {{{"nodes", {0}}}};
    json["nodes"][0]["children"] = {-1e300};
    test::expect_error<IoError>([&] { read_gltf(model(json)); }, "a node must be a whole number");

    // Joints that Index cannot hold.
    Json skin = triangle(inside);
    skin["buffers"][1] = {{"uri", "own.bin"}, {"byteLength", 36}};
    std::string large(48, '\xff');
    write_file(large, folder_ / "model" / "own.bin");
    skin["bufferViews"][1] = {{"buffer", 1}, {"byteLength", 48}};
    skin["accessors"][1] = {{"bufferView", 1}, {"componentType", 5125}, {"type", "VEC4"}, {"count", 3}};
    for (const char* key : {"JOINTS_0", "WEIGHTS_0"})
        skin["meshes"][0]["primitives"][0]["attributes"][key] = 1;
    test::expect_error<IoError>([&] { read_gltf(model(skin)); }, "a joint is out of range");
    skin["accessors"][1]["componentType"] = 5126;  // not a number
    test::expect_error<IoError>([&] { read_gltf(model(skin)); }, "a joint is out of range");
}

}  // namespace
}  // namespace counterpart
