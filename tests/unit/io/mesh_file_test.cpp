// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What all formats have in common; the formats' own rules are tested beside this file.
#include "base/random.hpp"
#include "support/expect_error.hpp"
#include "support/temporary_folder.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart::io {
namespace {

using test::TemporaryFolder;

TriangleMesh awkward_numbers() {
    TriangleMesh mesh = make_icosphere(1);
    mesh.vertices.row(0) << 1e-310, -0.0, 1.0 / 3;
    mesh.vertices.row(5) << 1e22, -123456789.123456789, std::numeric_limits<double>::min();
    return mesh;
}

std::string bytes_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

class LosslessFormat : public testing::TestWithParam<const char*> {};

TEST_P(LosslessFormat, RoundTripKeepsEveryBitAndTheOrder) {
    const TemporaryFolder folder;
    const TriangleMesh mesh = awkward_numbers();
    write_mesh(mesh, folder / GetParam());
    const MeshFile read = read_mesh(folder / GetParam());
    EXPECT_EQ(read.mesh.vertices, mesh.vertices);
    EXPECT_EQ(read.mesh.triangles, mesh.triangles);
    EXPECT_TRUE(read.notices.empty());
}

INSTANTIATE_TEST_SUITE_P(MeshFile, LosslessFormat,
                         testing::Values("a.off", "a.obj", "a.ply", "A.OFF", "b.c.Obj"));

TEST(MeshFile, StlRoundTripKeepsTheSurface) {
    const TemporaryFolder folder;
    TriangleMesh mesh = make_icosphere(1);
    mesh.vertices = mesh.vertices.cast<float>().cast<double>();
    write_mesh(mesh, folder / "a.stl");
    const MeshFile read = read_mesh(folder / "a.stl");
    ASSERT_EQ(read.mesh.n_vertices(), mesh.n_vertices());
    ASSERT_EQ(read.mesh.n_triangles(), mesh.n_triangles());
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(read.mesh.vertices.row(read.mesh.triangles(t, c)),
                      mesh.vertices.row(mesh.triangles(t, c)));
    ASSERT_EQ(read.notices.size(), 1U);
    EXPECT_NE(read.notices[0].find("240 corners joined by position into 42 vertices"), std::string::npos)
        << read.notices[0];
}

TEST(MeshFile, RefusesWhatHasNoFormatOrIsNotThere) {
    const TemporaryFolder folder;
    EXPECT_THROW(read_mesh(folder / "absent.obj"), IoError);
    EXPECT_THROW(read_mesh(folder.file("a.xyz", "")), IoError);
    std::filesystem::create_directory(folder / "folder.obj");
    EXPECT_THROW(read_mesh(folder / "folder.obj"), IoError);
    EXPECT_THROW(write_mesh(make_icosphere(0), folder / "a.xyz"), IoError);
    EXPECT_THROW(write_mesh(make_icosphere(0), folder / "absent" / "a.obj"), IoError);
}

TEST(MeshFile, EveryExtensionThatIsListedIsWrittenAndRead) {
    const TemporaryFolder folder;
    const MeshExtensions extensions = mesh_extensions();
    EXPECT_EQ(extensions.read.size(), 14U);
    EXPECT_EQ(extensions.written.size(), 8U);
    EXPECT_EQ(extensions.written_solids.size(), 3U);
    const TriangleMesh surface = make_icosphere(1);
    const TetrahedralMesh solid{Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, Tetrahedra{{0, 1, 2, 3}}};
    for (const std::string& extension : extensions.written) {
        write_mesh(surface, folder / ("surface" + extension));
        EXPECT_EQ(read_mesh(folder / ("surface" + extension)).mesh.n_triangles(), 80) << extension;
        EXPECT_EQ(std::count(extensions.read.begin(), extensions.read.end(), extension), 1) << extension;
    }
    for (const std::string& extension : extensions.written_solids) {
        write_tetrahedral_mesh(solid, folder / ("solid" + extension));
        EXPECT_EQ(read_tetrahedral_mesh(folder / ("solid" + extension))->mesh.n_tetrahedra(), 1) << extension;
        EXPECT_EQ(read_mesh(folder / ("solid" + extension)).mesh.n_triangles(), 4) << extension;
    }
}

TEST(MeshFile, AnExtensionThatIsNotOneIsAnsweredWithThoseThatAre) {
    const TemporaryFolder folder;
    test::expect_error<IoError>([&] { read_mesh(folder.file("a.txt", "")); },
                                ".off, .obj, .ply, .stl, .glb, .gltf, .msh");
    test::expect_error<IoError>([&] { read_mesh(folder.file("a.FBX", "")); }, "save it as .glb");
    test::expect_error<IoError>([&] { write_mesh(make_icosphere(0), folder / "a.msh"); },
                                ".gltf, .vtk, .vtp, which tells");
}

TEST(MeshFile, WhatIsWrittenIsRecognizedByItsBytes) {
    const TemporaryFolder folder;
    for (const std::string& extension : mesh_extensions().written) {
        write_mesh(make_icosphere(0), folder / ("a" + extension));
        EXPECT_EQ(recognized_extension(read_whole_file(folder / ("a" + extension))), extension);
    }
    EXPECT_EQ(recognized_extension("\xef\xbb\xbf# a comment\n\nv 0 0 0\n"), ".obj");
    EXPECT_EQ(recognized_extension("STOFF\n"), ".off");
    EXPECT_EQ(recognized_extension("$MeshFormat\n"), ".msh");
    EXPECT_EQ(recognized_extension("<?xml version=\"1.0\"?>\n<!DOCTYPE GIFTI>\n<GIFTI>"), ".gii");
    for (const std::string bytes : {"", "\n", "12 7\n", "view\n", "<html>", "\xff\xfe\x00"})
        EXPECT_EQ(recognized_extension(bytes), "") << bytes;
}

TEST(MeshFile, DoesNotWriteWhatItWouldNotRead) {
    const TemporaryFolder folder;
    TriangleMesh mesh = make_icosphere(0);
    mesh.triangles(3, 1) = 12;
    EXPECT_THROW(write_mesh(mesh, folder / "a.obj"), IoError);
    mesh = make_icosphere(0);
    mesh.vertices(3, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(write_mesh(mesh, folder / "a.ply"), IoError);
    mesh.vertices(3, 1) = 1e39;
    EXPECT_THROW(write_mesh(mesh, folder / "a.stl"), IoError);
    EXPECT_TRUE(std::filesystem::is_empty(folder / "."));
}

// Whatever is done to a file, the reader returns a valid mesh or throws IoError; sanitizers watch the rest.
class DamagedFile : public testing::TestWithParam<const char*> {};

void expect_mesh_or_error(const std::filesystem::path& file) {
    try {
        const MeshFile read = read_mesh(file);
        EXPECT_NO_THROW(require_valid(read.mesh));
    } catch (const IoError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    }
}

TEST_P(DamagedFile, TruncatedAnywhereIsAMeshOrAnError) {
    const TemporaryFolder folder;
    write_mesh(make_icosphere(0), folder / GetParam());
    const std::string bytes = bytes_of(folder / GetParam());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        expect_mesh_or_error(folder.file(GetParam(), std::string_view(bytes).substr(0, size)));
}

TEST_P(DamagedFile, WithFlippedBytesIsAMeshOrAnError) {
    const TemporaryFolder folder;
    write_mesh(make_icosphere(0), folder / GetParam());
    const std::string bytes = bytes_of(folder / GetParam());
    Random random(7);
    for (int round = 0; round < 500; ++round) {
        std::string damaged = bytes;
        for (std::uint64_t flips = 1 + random.below(4); flips > 0; --flips) {
            // Half of them printable, so that text stays text more often; many at the start, where the counts
            // are.
            const std::size_t range =
                random.below(2) == 0 ? std::min<std::size_t>(bytes.size(), 200) : bytes.size();
            damaged[random.below(range)] =
                static_cast<char>(random.below(2) == 0 ? random.below(256) : 32 + random.below(64));
        }
        expect_mesh_or_error(folder.file(GetParam(), damaged));
    }
}

INSTANTIATE_TEST_SUITE_P(MeshFile, DamagedFile, testing::Values("a.off", "a.obj", "a.ply", "a.stl"));

}  // namespace
}  // namespace counterpart::io
