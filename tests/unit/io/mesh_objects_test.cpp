// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/gltf.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/io/mesh_objects.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <filesystem>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace counterpart {
namespace {

using Path = std::filesystem::path;

std::vector<std::string> names_of(const std::vector<MeshObject>& objects) {
    std::vector<std::string> names;
    for (const MeshObject& object : objects) names.push_back(object.name);
    return names;
}

template <class A, class B>
void expect_equal(const A& a, const B& b) {
    ASSERT_EQ(a.rows(), b.rows());
    ASSERT_EQ(a.cols(), b.cols());
    EXPECT_EQ(a, b);
}

// At each corner; rows that no corner has do not count.
void expect_same_corners(const CornerAttribute& a, const CornerAttribute& b) {
    ASSERT_EQ(a.corners.rows(), b.corners.rows());
    for (Eigen::Index i = 0; i < a.corners.size(); ++i) {
        const Index row = a.corners.data()[i], other = b.corners.data()[i];
        ASSERT_EQ(row < 0, other < 0);
        if (row >= 0) expect_equal(a.values.row(row), b.values.row(other));
    }
}

void expect_same(const AttributedMesh& a, const AttributedMesh& b) {
    expect_equal(a.mesh.vertices, b.mesh.vertices);
    expect_equal(a.mesh.triangles, b.mesh.triangles);
    EXPECT_EQ(a.mesh.polygons.first, b.mesh.polygons.first);
    expect_equal(a.mesh.polygons.corners, b.mesh.polygons.corners);
    EXPECT_EQ(a.mesh.left_out, b.mesh.left_out);
    expect_same_corners(a.normals, b.normals);
    ASSERT_EQ(a.texture_coordinates.size(), b.texture_coordinates.size());
    for (std::size_t i = 0; i < a.texture_coordinates.size(); ++i)
        expect_same_corners(a.texture_coordinates[i], b.texture_coordinates[i]);
    ASSERT_EQ(a.colors.size(), b.colors.size());
    for (std::size_t i = 0; i < a.colors.size(); ++i) expect_same_corners(a.colors[i], b.colors[i]);
    EXPECT_EQ(a.parts, b.parts);
    EXPECT_EQ(a.part_names, b.part_names);
}

AttributedMesh object_of(const Path& file, const std::string& object) {
    return read_attributed_mesh(file, {.object = object}).content;
}

void expect_refused(const Path& file, const std::string& object, const std::string& part) {
    test::expect_error<IoError>([&] { read_mesh(file, {.object = object}); }, part);
    test::expect_error<IoError>([&] { read_attributed_mesh(file, {.object = object}); }, part);
}

// One after the other, these are the triangles of the whole file, at the same places.
void expect_together_whole(const Path& file) {
    const TriangleMesh whole = read_mesh(file).mesh;
    Index t = 0;
    const std::vector<MeshObject> objects = mesh_objects(file);
    for (std::size_t k = 0; k < objects.size(); ++k) {
        const TriangleMesh mesh = object_of(file, std::to_string(k)).mesh;
        EXPECT_EQ(mesh.n_vertices(), objects[k].n_vertices);
        EXPECT_EQ(mesh.n_triangles(), objects[k].n_triangles);
        for (Index i = 0; i < mesh.n_triangles(); ++i, ++t)
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(mesh.vertices.row(mesh.triangles(i, c)), whole.vertices.row(whole.triangles(t, c)));
    }
    EXPECT_EQ(t, whole.n_triangles());
}

// A square face and a triangle, each with its own everything, as Blender writes them.
const std::string square =
    "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 1 1 0\nv 9 9 9 0 0 0\nvt 0 0\nvt 1 0\nvn 0 0 1\n"
    "usemtl red\nf -5/-2/-1 -4/-1/-1 -3/-1/-1 -2/-2/-1\n";
const std::string tip =
    "v 0 0 1 1 0 0\nv 1 0 1 0 1 0\nv 0 1 1 0 0 1\nvt 0.5 0\nvt 0.5 1\nvn 0 1 0\nusemtl blue\n"
    "f -3/-2/-1 -2/-1/-1 -1/-1/-1\n";

TEST(MeshObjects, AnObjectOfAnObjFileIsAsInAFileOfItsOwn) {
    const test::TemporaryFolder folder;
    const Path both = folder.file("both.obj", "# two\no square\n" + square + "o tip\n" + tip);
    EXPECT_EQ(names_of(mesh_objects(both)), (std::vector<std::string>{"square", "tip"}));
    expect_same(object_of(both, "square"), read_attributed_mesh(folder.file("s.obj", square)).content);
    expect_same(object_of(both, "tip"), read_attributed_mesh(folder.file("t.obj", tip)).content);
    expect_same(object_of(both, "1"), object_of(both, "tip"));
    expect_equal(read_mesh(both, {.object = "tip"}).mesh.vertices, object_of(both, "tip").mesh.vertices);
    EXPECT_EQ(read_mesh(both, {.object = "tip"}).notices.back(),
              "object 1 'tip' of 2: 3 vertices, 1 triangles");
    expect_together_whole(both);
}

TEST(MeshObjects, SharedVerticesAreInEachAndUnusedOnesWhereTheFileHasThem) {
    const test::TemporaryFolder folder;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const Path file =
        folder.file("a.obj", "o all\n" + vertices + "f 1 2 3\no rest\nv 5 5 5\nf 3 2 4\nf -2 1 2\n");
    expect_equal(object_of(file, "all").mesh.vertices, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    const TriangleMesh rest = object_of(file, "rest").mesh;
    expect_equal(rest.vertices, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {5, 5, 5}}));
    expect_equal(rest.triangles, (Triangles{{2, 1, 3}, {3, 0, 1}}));
    expect_together_whole(file);
}

TEST(MeshObjects, GroupsCountWhereThereAreNoObjectsAndGoOn) {
    const test::TemporaryFolder folder;
    const std::string vertices = "g default\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const Path groups =
        folder.file("g.obj", vertices + "g left arm\nf 1 2 3\ng head\nf 2 3 4\ng left arm\nf 1 2 4\n");
    const std::vector<MeshObject> objects = mesh_objects(groups);
    EXPECT_EQ(names_of(objects), (std::vector<std::string>{"left arm", "head"}));
    EXPECT_EQ(objects[0].n_vertices, 4);
    expect_equal(object_of(groups, "left arm").mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 3}}));
    const Path mixed = folder.file("m.obj", vertices + "f 1 2 3\ng head\nf 2 3 4\no body\nf 1 2 4\n");
    EXPECT_EQ(names_of(mesh_objects(mixed)), (std::vector<std::string>{"", "body"}));
    EXPECT_EQ(object_of(mixed, "0").mesh.n_triangles(), 2);
    expect_together_whole(mixed);
}

TEST(MeshObjects, NamesMayBeAnythingAndNumbersAreForTheRest) {
    const test::TemporaryFolder folder;
    const Path file = folder.file(
        "a.obj",
        "o \xc3\x84rmel links \nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\no 0\nv 2 0 0\nv 3 0 0\nv 2 1 0\n"
        "f -3 -2 -1\no twin\nf 1 2 3\no twin\nf 4 5 6\no nothing\no\nf 1 2 4\n");
    EXPECT_EQ(names_of(mesh_objects(file)),
              (std::vector<std::string>{"\xc3\x84rmel links", "0", "twin", "twin", ""}));
    EXPECT_EQ(object_of(file, "\xc3\x84rmel links").mesh.vertices(0, 0), 0);
    EXPECT_EQ(object_of(file, "0").mesh.vertices(0, 0), 2);  // a name goes before a number
    EXPECT_EQ(object_of(file, "3").mesh.vertices(0, 0), 2);
    EXPECT_EQ(object_of(file, "").mesh.vertices(2, 0), 2);
    expect_refused(file, "twin", "a.obj: 2 objects are named 'twin': choose one by its number, of 2, 3");
    expect_refused(file, "nothing",
                   "there is no object 'nothing'; the file has 5 objects: 0 '\xc3\x84rmel links', 1 '0', 2 "
                   "'twin', 3 'twin', 4 (without a name)");
    for (const char* wanted : {"5", "-1", "1.0", " 1", "99999999999999999999"})
        expect_refused(file, wanted, fmt::format("there is no object '{}'", wanted));
}

TEST(MeshObjects, OtherFilesHaveOneObject) {
    const test::TemporaryFolder folder;
    const TriangleMesh sphere = make_icosphere(1);
    for (const char* name : {"a.off", "a.ply", "a.stl", "a.vtk", "a.vtp", "a.glb", "a.obj"}) {
        SCOPED_TRACE(name);
        const Path file = folder / name;
        write_mesh(sphere, file);
        const std::vector<MeshObject> objects = mesh_objects(file);
        EXPECT_EQ(names_of(objects), (std::vector<std::string>{""}));
        EXPECT_EQ(objects[0].n_vertices, sphere.n_vertices());
        expect_equal(read_mesh(file, {.object = "0"}).mesh.vertices, read_mesh(file).mesh.vertices);
        expect_refused(file, "arm", "there is no object 'arm'; the file has one object: 0 (without a name)");
        expect_refused(file, "1", "there is no object '1'");
    }
}

TEST(MeshObjects, SolidsOfTextStlAreJoinedEachByItself) {
    const auto facet = [](double x) {
        return fmt::format(
            "facet normal 0 0 1\nouter loop\nvertex {} 0 0\nvertex 1 0 0\nvertex 1 1 0\n"
            "endloop\nendfacet\n",
            x);
    };
    const test::TemporaryFolder folder;
    const Path file =
        folder.file("a.stl", "solid left part\n" + facet(0) + "endsolid left part\nsolid right\n" + facet(2) +
                                 facet(2) + "endsolid\n");
    const std::vector<MeshObject> objects = mesh_objects(file);
    EXPECT_EQ(names_of(objects), (std::vector<std::string>{"left part", "right"}));
    EXPECT_EQ(objects[1].n_vertices, 3);
    EXPECT_EQ(objects[1].n_triangles, 2);
    const Path right = folder.file("b.stl", "solid right\n" + facet(2) + facet(2) + "endsolid\n");
    expect_same(object_of(file, "right"), read_attributed_mesh(right).content);
    expect_together_whole(file);
    expect_refused(file, "middle",
                   "there is no object 'middle'; the file has 2 objects: 0 'left part', 1 'right'");
}

TEST(MeshObjects, VerticesThatAreNoNumbersAreLeftOutOfTheirObject) {
    const test::TemporaryFolder folder;
    const std::string broken = "usemtl green\nv 0 0 7\nv 1 0 7\nv 0 1 7\nv nan 0 0\nf -4 -3 -2\nf -3 -2 -1\n";
    const Path file = folder.file("a.obj", "o square\n" + square + "o broken\n" + broken);
    expect_same(object_of(file, "broken"), read_attributed_mesh(folder.file("b.obj", broken)).content);
    EXPECT_EQ(mesh_objects(file)[1].n_vertices, 4);
    EXPECT_EQ(mesh_objects(file)[1].n_triangles, 1);
    EXPECT_NO_THROW(read_mesh(file, {.strict = true, .object = "square"}));
    test::expect_error<IoError>([&] { read_mesh(file, {.strict = true, .object = "broken"}); },
                                "vertex 3 has a coordinate that is no finite number");
}

TEST(MeshObjects, ManyTakeLinearTime) {
    const test::TemporaryFolder folder;
    constexpr int n = 100'000;
    std::string text;
    for (int i = 0; i < n; ++i)
        text += fmt::format("o part {}\nv {} 0 0\nv {} 1 0\nv {} 0 1\nf -3 -2 -1\n", i, i, i, i);
    const Path file = folder.file("a.obj", text);
    const std::vector<MeshObject> objects = mesh_objects(file);
    ASSERT_EQ(std::ssize(objects), n);
    EXPECT_EQ(objects[n - 1].n_vertices, 3);
    EXPECT_EQ(object_of(file, "part 77777").mesh.vertices(0, 0), 77777);
    expect_refused(file, "part", "8 'part 8', 9 'part 9' and 99990 more");
}

TEST(MeshObjects, AreKeptApartWhenObjIsWritten) {
    const test::TemporaryFolder folder;
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    for (const std::string& text : std::vector<std::string>{
             "o square\n" + square + "o tip\n" + tip + "v 8 8 8\n",
             "v 7 7 7\n" + vertices + "o arm #1\nf 2 3 4\no \nf 3 4 5\no arm #1\nf 2 3 5\n",
             vertices + "g a\nf 1 2 3\ng b\nf 2 3 4\ng a\nf 1 2 4\n",
         }) {
        SCOPED_TRACE(text);
        const Path file = folder.file("in.obj", text), out = folder / "out.obj";
        const AttributedMesh before = read_attributed_mesh(file).content;
        write_attributed_mesh(before, out);
        const AttributedMesh after = read_attributed_mesh(out).content;
        expect_same(after, before);
        EXPECT_EQ(names_of(mesh_objects(out)), names_of(mesh_objects(file)));
        for (std::size_t k = 0; k < mesh_objects(file).size(); ++k)
            expect_same(object_of(out, std::to_string(k)), object_of(file, std::to_string(k)));
    }
}

// Two nodes, one of which moves and mirrors its mesh, and a third that shows the first mesh again.
Path gltf_of_two(const test::TemporaryFolder& folder) {
    AttributedMesh content;
    content.mesh = {Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1}},
                    Triangles{{0, 1, 2}, {3, 4, 5}, {3, 4, 6}}};
    content.parts = {0, 1, 1};
    content.part_names = {"red", "blue"};
    const Path file = folder / "one.gltf";
    write_gltf(content, file);
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(read_whole_file(file));
    auto& primitives = json["meshes"][0]["primitives"];
    json["meshes"].push_back({{"primitives", {primitives[1]}}});
    primitives.erase(1);
    json["scenes"][0]["nodes"] = {0, 1, 2};
    json["nodes"] = {{{"mesh", 0}, {"name", "left arm"}, {"translation", {0, 0, 3}}},
                     {{"mesh", 1}, {"name", "right"}, {"scale", {-1, 1, 1}}},
                     {{"mesh", 0}, {"name", "again"}}};
    return folder.file("two.gltf", json.dump());
}

TEST(MeshObjects, OfGltfAreMeshesByTheirNodes) {
    const test::TemporaryFolder folder;
    const Path file = gltf_of_two(folder);
    const std::vector<MeshObject> objects = mesh_objects(file);
    ASSERT_EQ(names_of(objects), (std::vector<std::string>{"left arm", "right", "again"}));
    EXPECT_EQ(objects[1].n_vertices, 4);
    expect_together_whole(file);
    const AttributedMesh right = object_of(file, "right");
    expect_equal(right.mesh.vertices, (Points{{-5, 0, 0}, {-6, 0, 0}, {-5, 1, 0}, {-5, 0, 1}}));
    expect_equal(right.mesh.triangles, (Triangles{{0, 2, 1}, {0, 3, 1}}));
    EXPECT_EQ(right.part_names, (std::vector<std::string>{"blue"}));
    expect_equal(object_of(file, "0").mesh.vertices, (Points{{0, 0, 3}, {1, 0, 3}, {0, 1, 3}}));
    // Another node that shows the first mesh.
    expect_equal(object_of(file, "again").mesh.vertices, (Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    expect_equal(object_of(file, "2").mesh.vertices, object_of(file, "again").mesh.vertices);
    expect_refused(file, "none", "the file has 3 objects: 0 'left arm', 1 'right', 2 'again'");
}

// As a forest is: one tree in many places, in a file that has room for the numbers of a few.
TEST(MeshObjects, InstancesThatTakeFarMoreMemoryThanTheFileAreLeftOut) {
    const test::TemporaryFolder folder;
    write_mesh(make_icosphere(6), folder / "tree.gltf");
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(read_whole_file(folder / "tree.gltf"));
    const auto read = [&](int n_trees) {
        json["nodes"] = nlohmann::ordered_json::array();
        json["scenes"][0]["nodes"] = nlohmann::ordered_json::array();
        for (int i = 0; i < n_trees; ++i) {
            json["nodes"].push_back({{"mesh", 0}, {"translation", {3 * i, 0, 0}}});
            json["scenes"][0]["nodes"].push_back(i);
        }
        return read_mesh(folder.file("forest.gltf", json.dump()));
    };
    const MeshFile few = read(3);
    EXPECT_EQ(few.mesh.n_vertices(), 3 * 40962);
    EXPECT_NEAR(few.mesh.vertices.col(0).maxCoeff(), 7, 1e-6);
    const MeshFile many = read(2000);
    EXPECT_EQ(many.mesh.n_vertices(), 40962);
    EXPECT_EQ(many.notices.front(), "1999 further instances of meshes left out");
}

TEST(MeshObjects, OfGltfAreWrittenAloneOrTogether) {
    const test::TemporaryFolder folder;
    const Path file = gltf_of_two(folder), out = folder / "out.glb", obj = folder / "out.obj";
    write_attributed_mesh(read_attributed_mesh(file).content, out);
    EXPECT_EQ(names_of(mesh_objects(out)), (std::vector<std::string>{"left arm", "right", "again"}));
    expect_same(read_attributed_mesh(out).content, read_attributed_mesh(file).content);
    write_attributed_mesh(object_of(file, "right"), out);
    EXPECT_EQ(names_of(mesh_objects(out)), (std::vector<std::string>{"right"}));
    expect_same(read_attributed_mesh(out).content, object_of(file, "right"));
    write_attributed_mesh(read_attributed_mesh(file).content, obj);
    EXPECT_EQ(names_of(mesh_objects(obj)), (std::vector<std::string>{"left arm", "right", "again"}));
    expect_equal(object_of(obj, "right").mesh.vertices, object_of(file, "right").mesh.vertices);
}

TEST(MeshObjects, OfOtherFilesAreNodesOfGltfEachWithItsParts) {
    const test::TemporaryFolder folder;
    const std::string two_colors = "usemtl blue\nf 1 2 3\n";  // of a square's object, in the tip's material
    const Path obj = folder.file("a.obj", "o square\n" + square + two_colors + "o tip\n" + tip);
    for (const char* name : {"a.glb", "a.gltf"}) {
        const Path gltf = folder / name, again = folder / "again.obj";
        write_attributed_mesh(read_attributed_mesh(obj).content, gltf);
        EXPECT_EQ(names_of(mesh_objects(gltf)), (std::vector<std::string>{"square", "tip"}));
        const AttributedMesh whole = read_attributed_mesh(gltf).content;
        EXPECT_EQ(whole.part_names, (std::vector<std::string>{"red", "blue", "blue"}));
        EXPECT_EQ(whole.parts, (std::vector<Index>{0, 0, 1, 2}));
        const AttributedMesh alone = object_of(gltf, "tip"), expected = object_of(obj, "tip");
        expect_equal(alone.mesh.vertices, expected.mesh.vertices);
        expect_equal(alone.mesh.triangles, expected.mesh.triangles);
        expect_same_corners(alone.texture_coordinates[0], expected.texture_coordinates[0]);
        expect_same_corners(alone.normals, expected.normals);
        EXPECT_EQ(object_of(gltf, "square").part_names, (std::vector<std::string>{"red", "blue"}));
        write_attributed_mesh(whole, again);
        EXPECT_EQ(names_of(mesh_objects(again)), (std::vector<std::string>{"square", "tip"}));
    }
    const auto json = nlohmann::json::parse(read_whole_file(folder / "a.gltf"));
    EXPECT_EQ(json["nodes"].size(), 2U);
    EXPECT_EQ(json["materials"].size(), 2U);  // nodes share them
}

TEST(MeshObjects, ThatShareVerticesStayOneMeshInGltf) {
    const test::TemporaryFolder folder;
    const Path obj = folder.file(
        "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng arm\nf 1 2 3\ng head\nf 2 3 4\ng arm\nf 1 2 4\n");
    const Path gltf = folder / "a.glb";
    write_attributed_mesh(read_attributed_mesh(obj).content, gltf);
    EXPECT_EQ(names_of(mesh_objects(gltf)), (std::vector<std::string>{""}));
    expect_equal(read_mesh(gltf).mesh.vertices, read_mesh(obj).mesh.vertices);
    expect_equal(read_mesh(gltf).mesh.triangles, read_mesh(obj).mesh.triangles);
}

}  // namespace
}  // namespace counterpart
