// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/npy.hpp>

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

namespace counterpart::io {
namespace {

std::filesystem::path scratch(const std::string& name) {
    return std::filesystem::temp_directory_path() / ("surface_map_" + std::to_string(getpid()) + name);
}

const SurfaceMap some_map{{{2, {0.25, 0.5, 0.25}}, {}, {0, {1.0 / 3, 1.0 / 3, 1 - 2.0 / 3}}}, 3};

TEST(SurfaceMapFile, ComesBackExactly) {
    for (const std::string name : {".txt", ".npy"}) {
        write_surface_map(some_map, scratch(name));
        EXPECT_EQ(read_surface_map(scratch(name)), some_map) << name;
        EXPECT_TRUE(std::holds_alternative<SurfaceMap>(read_map(scratch(name)))) << name;
        std::filesystem::remove(scratch(name));
    }
}

TEST(SurfaceMapFile, TheFormatIsToldInCapitalsToo) {
    write_surface_map(some_map, scratch(".NPY"));
    EXPECT_EQ(read_npy(scratch(".NPY")).cols(), 4);
    EXPECT_EQ(read_surface_map(scratch(".NPY")), some_map);
    std::filesystem::remove(scratch(".NPY"));
}

TEST(SurfaceMapFile, TellsTheKindsApart) {
    for (const std::string name : {".txt", ".npy"}) {
        write_vertex_map(identity_map(4), scratch(name));
        EXPECT_TRUE(std::holds_alternative<VertexMap>(read_map(scratch(name)))) << name;
        std::filesystem::remove(scratch(name));
    }
}

TEST(SurfaceMapFile, NamesTheLineThatIsWrong) {
    for (const std::string line :
         {"1 0.5 0.5", "1 0.5 0.5 0.5", "1 -1 1 1", "0.5 1 0 0", "-2 1 0 0", "1 nan 1 0", "1 1 0 0 0", "x"}) {
        write_file("0 1 0 0\n" + line + "\n", scratch("bad.txt"));
        try {
            read_surface_map(scratch("bad.txt"));
            ADD_FAILURE() << line;
        } catch (const IoError& error) {
            EXPECT_NE(std::string(error.what()).find(":2:"), std::string::npos) << error.what();
        }
    }
    std::filesystem::remove(scratch("bad.txt"));
}

}  // namespace
}  // namespace counterpart::io
